import type { Fix } from "../../generated/responses";
import { money, time } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { useDesign } from "../../state/design/design";
import { otherWires, useFixes } from "../../state/design/fixes/fixes";
import { useView } from "../../state/window/view";
import { isFirst, totals } from "./totals";
import "./check.css";

/** Before and after, while a fix is shown in the view: over the view, so that the list of fixes stays where the pointer is. */
export function PreviewFigures() {
  const shown = useFixes((store) => store.shown);
  const preview = useView((view) => view.preview !== null);
  if (!shown || !preview) return null;
  return (
    <section className="preview-figures" aria-label="Before and after the fix">
      <strong>{shown.title}</strong>
      <Figures fix={shown} />
    </section>
  );
}

function Figures({ fix }: { readonly fix: Fix }) {
  const check = useDesign((design) => design.check);
  const { length, long } = useLengths();
  const { change } = fix;
  const now = totals(check);
  const row = (
    name: string,
    before: number | null,
    by: number | null,
    after: number | null,
    shown: (value: number) => string,
  ) => {
    if (before === null && by === null && after === null) return null;
    const known = before !== null && by !== null;
    return (
      <tr key={name}>
        <th scope="row">{name}</th>
        <td>{before === null ? "\u2013" : shown(before)}</td>
        <td>{after !== null ? shown(after) : known ? shown(before + by) : "\u2013"}</td>
      </tr>
    );
  };
  if (isFirst(change) && fix.after.time_s === null)
    return (
      <p className="muted small">
        Totals of stock, time and cost are shown once the wires are within the machine's limits.
      </p>
    );
  const errors = check?.diagnostics.filter(({ severity }) => severity === "error").length ?? 0;
  return (
    <table className="before-after">
      <thead>
        <tr>
          <td />
          <th scope="col">now</th>
          <th scope="col">with the fix</th>
        </tr>
      </thead>
      <tbody>
        {otherWires(fix) && row("Wires", check?.wires.length ?? null, null, fix.after.wires, String)}
        {row("Wire", now.length_mm, change.length_mm, fix.after.length_mm, length)}
        {row("Stock", now.stock_mm, change.stock_mm, fix.after.stock_mm, long)}
        {row("Time", now.time_s, change.time_s, fix.after.time_s, time)}
        {row("Cost of stock", now.cost, change.cost, fix.after.cost, (value) =>
          money(value, change.currency ?? now.currency),
        )}
        <tr>
          <th scope="row">Errors</th>
          <td>{errors}</td>
          <td>{fix.errors_after}</td>
        </tr>
      </tbody>
    </table>
  );
}
