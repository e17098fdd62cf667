import { type ReactNode, useId, useRef, useState } from "react";
import { Icon } from "../../shared/controls/icons";
import { Mark, type Tone } from "../../shared/lists/Mark";
import { useInSight } from "../../shared/lists/sight";
import { type SectionId, useUi } from "../../state/window/ui";
import "./panel.css";

/** A section of the panel. Its header shows the state in a phrase, also while it is closed; then its contents are not there. */
export function Section({
  id,
  title,
  phrase,
  tone,
  children,
}: {
  readonly id: SectionId;
  readonly title: string;
  readonly phrase: string;
  /** A mark before the phrase. */
  readonly tone?: Tone | null;
  readonly children: ReactNode;
}) {
  const open = useUi((ui) => ui.open.includes(id));
  const toggle = useUi((ui) => ui.toggleSection);
  const contents = useId();
  const box = useRef<HTMLElement>(null);
  const [atFirst] = useState(open);
  useInSight(box, open && !atFirst);
  return (
    <section ref={box} className="section" id={`section-${id}`} aria-labelledby={`${contents}-title`}>
      <h2>
        <button
          type="button"
          className="section-head"
          aria-expanded={open}
          aria-controls={open ? contents : undefined}
          onClick={() => toggle(id)}
        >
          <Icon name={open ? "down" : "right"} size={12} />
          <span id={`${contents}-title`} className="section-title">
            {title}
          </span>
          <span className="section-phrase">
            {tone && <Mark tone={tone} />}
            <span className="ellipsis">{phrase}</span>
          </span>
        </button>
      </h2>
      {open && (
        <div id={contents} className="section-body">
          {children}
        </div>
      )}
    </section>
  );
}

/** A part of a section with a small heading. */
export function Part({
  title,
  aside,
  children,
}: {
  readonly title: string;
  readonly aside?: ReactNode;
  readonly children: ReactNode;
}) {
  return (
    <div className="part">
      <div className="part-head">
        <h3>{title}</h3>
        {aside}
      </div>
      {children}
    </div>
  );
}
