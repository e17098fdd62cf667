import type { FrameShown } from "../../generated/responses";
import { number } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { Part } from "../panel/Section";
import { displacement, force, stress } from "./words";

/** Figures of the closed frame, over all wires that were drawn; as made and as closed of the first of them. */
export function Closed({ shown }: { readonly shown: FrameShown }) {
  const unit = useUnit();
  const { closing, of_runs, resources, runs } = shown.result;
  const first = shown.shapes.closed;
  if (!closing) return null;
  const sd = of_runs?.sd;
  const rows: readonly (readonly [string, string, string])[] = [
    [
      "Off the drawing, RMS",
      displacement(closing.surface_rms_mm, unit),
      sd ? `± ${displacement(sd.surface_rms_mm, unit)}` : "",
    ],
    ["Force along struts, RMS", force(closing.axial_rms_n), sd ? `± ${force(sd.axial_rms_n)}` : ""],
    ["Stress, RMS", stress(closing.von_mises_rms_mpa), sd ? `± ${stress(sd.von_mises_rms_mpa)}` : ""],
    [
      "Largest pull to close",
      closing.largest_pull_n == null ? "–" : force(closing.largest_pull_n),
      sd?.largest_pull_n == null ? "" : `± ${force(sd.largest_pull_n)}`,
    ],
    [
      "Gap before",
      closing.gap_mm == null ? "–" : displacement(closing.gap_mm, unit),
      sd?.gap_mm == null ? "" : `± ${displacement(sd.gap_mm, unit)}`,
    ],
  ];
  return (
    <Part title="Once closed" aside={<span className="muted small">{runs} wires</span>}>
      <table className="figures" aria-label="Closed frame">
        <tbody>
          {rows.map(([what, value, spread]) => (
            <tr key={what}>
              <td>{what}</td>
              <td>{value}</td>
              <td className="muted">{spread}</td>
            </tr>
          ))}
          {resources && (
            <tr>
              <td>Wire</td>
              <td>{number(resources.wire_g, 1)} g</td>
              <td />
            </tr>
          )}
        </tbody>
      </table>
      {first && (
        <table className="figures" aria-label="The first wire">
          <thead>
            <tr>
              <th scope="col">The first wire</th>
              <th scope="col">As made</th>
              <th scope="col">As closed</th>
            </tr>
          </thead>
          <tbody>
            <tr>
              <td>Off the drawing, at most</td>
              <td>{displacement(first.max_made_mm, unit)}</td>
              <td>{displacement(first.max_closed_mm, unit)}</td>
            </tr>
            <tr>
              <td>At vertex</td>
              <td>{first.made_at_vertex}</td>
              <td>{first.at_vertex}</td>
            </tr>
          </tbody>
        </table>
      )}
    </Part>
  );
}
