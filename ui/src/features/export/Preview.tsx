import { useEffect } from "react";
import type { FormatEntry } from "../../generated/responses";
import { Button } from "../../shared/Button";
import { Checkbox } from "../../shared/inputs";
import { Line } from "../../shared/Line";
import { useLengths } from "../../shared/unit";
import { useDesign } from "../../state/design";
import { preview, setDespiteErrors, useExports } from "../../state/exports";
import { useUi } from "../../state/ui";
import { bytes } from "./groups";

/** How long nothing has to change before it is asked for, ms. */
const REST_MS = 350;

/** The beginning of what would be written, and what to know of it. */
export function Preview({ format }: { readonly format: FormatEntry }) {
  const { preview: shown, previewing, settings, despiteErrors } = useExports();
  const { vertices, edges, state, check } = useDesign();
  const showSection = useUi((ui) => ui.showSection);
  const { said } = useLengths();
  useEffect(() => {
    const timer = window.setTimeout(() => void preview(), REST_MS);
    return () => window.clearTimeout(timer);
  }, [format, settings, despiteErrors, vertices, edges, state?.machine, state?.material, state?.doublings, state?.start]);
  const mine = shown?.format === format.id ? shown : null;
  const infeasible = format.program && (mine?.refused?.errors || mine?.seen?.feasible === false || check?.feasible === false);
  return (
    <div className="stack" aria-busy={previewing}>
      {infeasible && (
        <div className="inset stack">
          <ul>
            <Line
              tone="error"
              what="The machine cannot make this"
              sub="The checks object. It is written only when you say so."
              action={
                <Button kind="link" onClick={() => showSection("check")}>
                  Check
                </Button>
              }
            />
          </ul>
          <Checkbox checked={despiteErrors} onChange={setDespiteErrors}>
            Write it all the same
          </Checkbox>
        </div>
      )}
      {mine?.refused && !(mine.refused.errors && infeasible) && (
        <ul>
          <Line tone="error" what="It cannot be written" sub={said(mine.refused.message)} />
        </ul>
      )}
      {mine?.seen?.notes.map((note) => (
        <p key={note.code + note.message} className="muted small">
          {said(note.message)}
        </p>
      ))}
      {mine?.seen?.beginnings.map((beginning, index) => (
        <figure key={index} className="preview">
          <figcaption className="muted small">
            {mine.seen && mine.seen.beginnings.length > 1 ? `File ${index + 1} · ` : ""}
            {bytes(mine.seen?.bytes[index] ?? 0)}
            {beginning === null ? " · nothing to read here: open the file" : ""}
          </figcaption>
          {beginning !== null && (
            <pre className="selectable" tabIndex={0} aria-label="First lines">
              {beginning}
            </pre>
          )}
        </figure>
      ))}
      {!mine && <p className="muted small">{previewing ? "Looking what would be written…" : " "}</p>}
    </div>
  );
}
