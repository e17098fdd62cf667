import { type ReactNode, useId, useState } from "react";
import { Icon } from "./icons";
import "./fold.css";

/** A part of a section that is open or not, with a phrase that shows its state while it is not. */
export function Fold({
  title,
  phrase,
  start = false,
  children,
}: {
  readonly title: string;
  readonly phrase?: ReactNode;
  readonly start?: boolean;
  readonly children: ReactNode;
}) {
  const [open, setOpen] = useState(start);
  const id = useId();
  return (
    <div className="fold">
      <h3>
        <button
          type="button"
          className="fold-head"
          aria-expanded={open}
          aria-controls={open ? id : undefined}
          onClick={() => setOpen(!open)}
        >
          <Icon name={open ? "down" : "right"} size={12} />
          <span className="fold-title">{title}</span>
          <span className="fold-phrase">{phrase}</span>
        </button>
      </h3>
      {open && (
        <div id={id} className="fold-body">
          {children}
        </div>
      )}
    </div>
  );
}
