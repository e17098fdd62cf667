import { useEffect } from "react";
import type { FormatEntry } from "../../generated/responses";
import { useUnit } from "../../shared/figures/unit";
import { Line } from "../../shared/lists/Line";
import { isRefused, useDesign } from "../../state/design/design";
import { preview, setDespiteErrors, useExports } from "../../state/files/exports";
import { Anyway } from "../check/Anyway";
import { Notes } from "../panel/Notes";
import { bytes, isPrinted } from "./groups";

/** How long nothing has to change before it is asked for, ms. */
const REST_MS = 350;

/** The beginning of what would be written, and what to know of it. */
export function Preview({ format }: { readonly format: FormatEntry }) {
  const { preview: shown, previewing, settings, despiteErrors } = useExports();
  const design = useDesign();
  const { version, state } = design;
  const unit = useUnit();
  // biome-ignore lint/correctness/useExhaustiveDependencies: what is written depends on all of these
  useEffect(() => {
    const timer = window.setTimeout(() => void preview(), REST_MS);
    return () => window.clearTimeout(timer);
  }, [format, settings, despiteErrors, version, state?.name, unit]);
  const mine = shown?.format === format.id ? shown : null;
  const infeasible = format.program && (mine?.refused?.errors || mine?.seen?.feasible === false || isRefused(design));
  return (
    <div className="stack" aria-busy={previewing}>
      {infeasible && (
        <Anyway checked={despiteErrors} onChange={setDespiteErrors}>
          Write it anyway
        </Anyway>
      )}
      {mine?.refused && !(mine.refused.errors && infeasible) && (
        <ul>
          <Line tone="error" what="The file cannot be written" sub={mine.refused.message} />
        </ul>
      )}
      <Notes notes={mine?.seen?.notes ?? []} />
      {mine?.seen?.beginnings.map((beginning, index) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: the files of a format have no other name
        <figure key={index} className="preview">
          <figcaption className="muted small">
            {mine.seen && mine.seen.beginnings.length > 1 ? `File ${index + 1} · ` : ""}
            {bytes(mine.seen?.bytes[index] ?? 0)}
            {beginning !== null ? "" : isPrinted(format) ? " · pages to print" : " · binary file: no preview"}
          </figcaption>
          {beginning !== null && (
            <section aria-label="First lines">
              {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, also by keys */}
              <pre className="selectable" tabIndex={0}>
                {beginning}
              </pre>
            </section>
          )}
        </figure>
      ))}
      {!mine && <p className="muted small">{previewing ? "Preparing the preview…" : " "}</p>}
    </div>
  );
}
