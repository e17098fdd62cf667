import type { DiagnosticReport, FrameShown } from "../../generated/responses";
import { count, percent, sentence } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { Line } from "../../shared/lists/Line";
import { select } from "../../state/design/selection";
import { frame } from "../../state/window/view";
import { Notes } from "../panel/Notes";
import { placesOf } from "../viewport/marks";
import { Place } from "./Place";
import { displacement, force, frequency, mass, stress, utilisation } from "./words";

/** A finding, and where it is. */
export function Finding({ report }: { readonly report: DiagnosticReport }) {
  const { vertices, edges } = placesOf(report);
  const go = () => {
    select(vertices, edges);
    frame(vertices, edges);
  };
  return (
    <Line
      tone={report.severity}
      what={
        vertices.length + edges.length > 0 ? (
          <button type="button" className="line-button plain" onClick={go}>
            {sentence(report.message)}
          </button>
        ) : (
          sentence(report.message)
        )
      }
      sub={sentence(report.help)}
    />
  );
}

/** The figures of a frame, each with its place. */
export function Results({ shown }: { readonly shown: FrameShown }) {
  const { length, unit } = useLengths();
  const { frame: figures, static: loaded, modes, bowed, material } = shown.result;
  const members = loaded?.members ?? [];
  const most = (of: (member: (typeof members)[number]) => number) =>
    members.toSorted((a, b) => of(b) - of(a)).find((member) => of(member) > 0);
  const used = most(({ utilisation }) => utilisation ?? 0);
  const stressed = most(({ von_mises_mpa }) => von_mises_mpa ?? 0);
  const buckling = most(({ buckling_ratio }) => buckling_ratio);
  const pulled = most(({ axial_n }) => Math.abs(axial_n));
  const bends = modes.find(({ kind }) => kind !== "rigid");
  const lowest = bowed?.modes.find(({ kind }) => kind !== "rigid");
  return (
    <div className="stack">
      {shown.result.diagnostics.length > 0 && (
        <ul>
          {shown.result.diagnostics.map((report) => (
            <Finding key={`${report.code} ${report.message}`} report={report} />
          ))}
        </ul>
      )}
      <table className="figures" aria-label="Results">
        <tbody>
          {loaded && (
            <tr>
              <td>Largest displacement</td>
              <td>{displacement(loaded.max_displacement_mm, unit)}</td>
              <td>
                <Place vertex={loaded.at_vertex} />
              </td>
            </tr>
          )}
          {used?.utilisation != null && (
            <tr>
              <td>Utilisation</td>
              <td>{utilisation(used.utilisation)}</td>
              <td>
                <Place edge={used.edge} />
              </td>
            </tr>
          )}
          {stressed?.von_mises_mpa != null && (
            <tr>
              <td>Stress</td>
              <td>{stress(stressed.von_mises_mpa)}</td>
              <td>
                <Place edge={stressed.edge} />
              </td>
            </tr>
          )}
          {pulled && (
            <tr>
              <td>{pulled.axial_n < 0 ? "Compression" : "Tension"}</td>
              <td>{force(Math.abs(pulled.axial_n))}</td>
              <td>
                <Place edge={pulled.edge} />
              </td>
            </tr>
          )}
          {buckling && (
            <tr>
              <td>Share of the buckling load</td>
              <td>{utilisation(buckling.buckling_ratio)}</td>
              <td>
                <Place edge={buckling.edge} />
              </td>
            </tr>
          )}
          {bends && (
            <tr>
              <td>Lowest frequency</td>
              <td>{frequency(bends.frequency_hz)}</td>
              <td>{bends.edge != null && <Place edge={bends.edge} />}</td>
            </tr>
          )}
          {bowed && lowest && (
            <tr>
              <td>Where struts bow by {percent(bowed.share, 1)}</td>
              <td>{frequency(lowest.frequency_hz)}</td>
              <td className="muted">{percent(bowed.of_straight, 0)} of straight</td>
            </tr>
          )}
          <tr>
            <td>Mass, without joints</td>
            <td>{mass(figures.mass_g)}</td>
            <td className="muted">{length(figures.length_mm)}</td>
          </tr>
        </tbody>
      </table>
      <Notes notes={shown.result.notes} />
      <p className="muted small">
        {count(figures.members, "strut")} of {material}, held at {count(figures.supports, "vertex", "vertices")}. Small
        displacements, rigid joints.
      </p>
    </div>
  );
}
