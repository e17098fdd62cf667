import { type ReactNode, useId, useState } from "react";
import "./layers.css";

/** A name and a key beside a button that shows only a drawing; shown on hover and on focus. `children` gets the id to describe itself by. */
export function Tooltip({ text, keys, side = "right", children }: { readonly text: string; readonly keys?: string | undefined; readonly side?: "right" | "below"; readonly children: ReactNode }) {
  const id = useId();
  const [shown, setShown] = useState(false);
  return (
    <span
      className="tooltip-anchor"
      onPointerEnter={() => setShown(true)}
      onPointerLeave={() => setShown(false)}
      onFocus={() => setShown(true)}
      onBlur={() => setShown(false)}
      onKeyDown={(event) => event.key === "Escape" && setShown(false)}
    >
      {children}
      {shown && (
        <span id={id} role="tooltip" className={`tooltip ${side}`}>
          {text}
          {keys && <kbd>{keys}</kbd>}
        </span>
      )}
    </span>
  );
}
