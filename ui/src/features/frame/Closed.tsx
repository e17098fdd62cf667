import type { FrameShown, ResourcesReport } from "../../generated/responses";
import { count, number } from "../../shared/figures/format";
import { useLengths, useUnit } from "../../shared/figures/unit";
import type { Faces } from "../../state/frame/faces";
import { Part } from "../panel/Section";
import { facesOf } from "./faces_name";
import { Place } from "./Place";
import { displacement, force, stress } from "./words";

/** What it is, its figure, and what is to be known beside it. */
type FigureRow = readonly [string, string, string];

function Figures({ label, rows }: { readonly label: string; readonly rows: readonly FigureRow[] }) {
  return (
    <table className="figures" aria-label={label}>
      <tbody>
        {rows.map(([what, value, more]) => (
          <tr key={what}>
            <td>{what}</td>
            <td>{value}</td>
            <td className="muted">{more}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** What the wires take, as Bend-Forming compares machines. */
function Takes({ resources }: { readonly resources: ResourcesReport }) {
  const { long } = useLengths();
  const { length_mm, bends, mass_g, joints_g, energy_kj, time_min } = resources;
  const rows: readonly FigureRow[] = [
    ["Length", long(length_mm), ""],
    ["Bends", number(bends, 0), ""],
    ["Mass", `${number(mass_g, 1)} g`, joints_g > 0 ? `${number(joints_g, 1)} g of joints` : ""],
    ...(energy_kj == null || time_min == null
      ? []
      : ([
          ["Energy", `${number(energy_kj, 2)} kJ`, ""],
          ["Time at 25 W", `${number(time_min, 1)} min`, "not of your machine"],
        ] as const)),
  ];
  return <Figures label="What it takes" rows={rows} />;
}

/** Figures of the closed frame, over all wires that were drawn; as made and as closed of the first of them. */
export function Closed({ shown, faces }: { readonly shown: FrameShown; readonly faces: Faces | null }) {
  const unit = useUnit();
  const { closing, of_runs, resources, runs } = shown.result;
  const first = shown.shapes.closed;
  if (!closing) return null;
  const sd = of_runs?.sd;
  const rows: readonly FigureRow[] = [
    [
      "Off the drawing, RMS",
      displacement(closing.vertices_rms_mm, unit),
      sd ? `± ${displacement(sd.vertices_rms_mm, unit)}` : "",
    ],
    ...(faces === null
      ? []
      : ([
          [
            `${facesOf(faces)} off flat, RMS`,
            displacement(closing.surface_rms_mm, unit),
            sd ? `± ${displacement(sd.surface_rms_mm, unit)}` : "",
          ],
        ] as const)),
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
    <Part title="Once closed" aside={runs !== null && <span className="muted small">{count(runs, "wire")}</span>}>
      <Figures label="Closed frame" rows={rows} />
      {resources && <Takes resources={resources} />}
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
              <td>There</td>
              <td>
                <Place vertex={first.made_at_vertex} />
              </td>
              <td>
                <Place vertex={first.at_vertex} />
              </td>
            </tr>
          </tbody>
        </table>
      )}
    </Part>
  );
}
