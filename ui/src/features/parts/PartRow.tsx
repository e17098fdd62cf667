import { useState } from "react";
import { Button } from "../../shared/controls/Button";
import { Popover } from "../../shared/layers/Popover";
import type { Look } from "../../state/parts/parts";

/** px of a row. */
export const ROW = 32;

/** Apart from each other, and from what colours mean elsewhere: red, amber, green, blue and yellow. */
const COLOURS = {
  Teal: "#1f9aa8",
  Violet: "#8a63d2",
  Magenta: "#c2559d",
  Brown: "#a9764a",
  Olive: "#8c8f3c",
  Slate: "#6f8197",
} as const;

function Swatch({
  name,
  look,
  usual,
  onChange,
}: {
  readonly name: string;
  readonly look: Look;
  readonly usual: string;
  readonly onChange: (change: Partial<Look>) => void;
}) {
  const [open, setOpen] = useState(false);
  const choose = (colour: string | null) => {
    setOpen(false);
    if (colour !== (look.colour ?? null)) onChange({ colour });
  };
  const choices: [string, string | null][] = [["Default", null], ...Object.entries(COLOURS)];
  return (
    <Popover
      label={`Colour of ${name}`}
      open={open}
      onOpenChange={setOpen}
      button={
        <button type="button" className="swatch" aria-label={`Colour of ${name}`} title="Colour">
          <span style={{ background: look.colour ?? usual }} />
        </button>
      }
    >
      <div className="swatches">
        {choices.map(([label, colour]) => (
          <button
            key={label}
            type="button"
            className="swatch-choice"
            aria-pressed={colour === (look.colour ?? null)}
            onClick={() => choose(colour)}
          >
            <span style={{ background: colour ?? usual }} />
            {label}
          </button>
        ))}
      </div>
    </Popover>
  );
}

/** A part or a stencil in its list: its colour, its name, which chooses it, its figures, and whether it is shown. */
export function PartRow({
  name,
  look,
  usual,
  figures,
  chosen,
  onChoose,
  onPoint,
  onChange,
  onRemove,
}: {
  readonly name: string;
  readonly look: Look;
  /** The colour that it has without one of its own, for style sheets. */
  readonly usual: string;
  readonly figures: string;
  readonly chosen: boolean;
  readonly onChoose: () => void;
  readonly onPoint?: (pointed: boolean) => void;
  readonly onChange: (change: Partial<Look>) => void;
  readonly onRemove?: () => void;
}) {
  const hidden = look.hidden ?? false;
  return (
    // biome-ignore lint/a11y/useSemanticElements: of many rows those in sight are there, and they are laid out by height
    <div
      role="listitem"
      className={`part-row${chosen ? " chosen" : ""}${hidden ? " hidden-part" : ""}`}
      style={{ height: ROW }}
      onPointerEnter={() => onPoint?.(true)}
      onPointerLeave={() => onPoint?.(false)}
    >
      <Swatch name={name} look={look} usual={usual} onChange={onChange} />
      <button type="button" className="part-name" aria-pressed={chosen} title={name} onClick={onChoose}>
        <span className="ellipsis">{name}</span>
        <span className="muted">{figures}</span>
      </button>
      <Button
        kind="quiet"
        icon={hidden ? "hidden" : "shown"}
        aria-label={hidden ? `Show ${name}` : `Hide ${name}`}
        title={hidden ? "Show" : "Hide"}
        onClick={() => onChange({ hidden: !hidden })}
      />
      {onRemove && <Button kind="quiet" icon="trash" aria-label={`Remove ${name}`} title="Remove" onClick={onRemove} />}
    </div>
  );
}
