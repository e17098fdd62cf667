import type { ContinuumChoice } from "../../generated/requests";
import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Bar, Checkbox, Segmented } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { percent, short } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { Line } from "../../shared/lists/Line";
import { useDesign } from "../../state/design/design";
import { askTolerance, require, useFrame, useToleranceStale } from "../../state/frame/frame";
import { Notes } from "../panel/Notes";
import { Part } from "../panel/Section";
import { Faces } from "./Faces";
import { facesOf } from "./faces_name";
import { displacement, exactness, force, frequency, stress } from "./words";

/** A truss of the size of an antenna, in place of the design. */
const LARGE: ContinuumChoice = { rings: 408, depth_mm: 50, diameter_mm: 50_000, bow: 0 };

/** A truss that is too large to be solved. */
function Continuum() {
  const truss = useFrame(({ required }) => required.continuum);
  const change = (part: Partial<ContinuumChoice>) => truss && require({ continuum: { ...truss, ...part } });
  return (
    <>
      <Checkbox
        checked={truss !== null}
        onChange={(checked) =>
          require(checked ? { continuum: LARGE, vary: "feed", stress: null } : { continuum: null })
        }
      >
        A large truss by closed formulas, in place of the design
      </Checkbox>
      {truss && (
        <>
          <Field label="Rings">
            {(ids) => (
              <NumberField
                {...ids}
                label="Rings around the middle triangle"
                kind="whole"
                value={truss.rings}
                min={1}
                max={1_000_000}
                onCommit={(rings) => change({ rings })}
              />
            )}
          </Field>
          <Field label="Depth">
            {(ids) => (
              <NumberField
                {...ids}
                label="Depth of the truss"
                value={truss.depth_mm}
                positive
                min={1e-3}
                max={1e9}
                onCommit={(depth_mm) => change({ depth_mm })}
              />
            )}
          </Field>
          <Field label="Diameter">
            {(ids) => (
              <NumberField
                {...ids}
                label="Diameter of the truss"
                value={truss.diameter_mm}
                positive
                min={1e-3}
                max={1e9}
                onCommit={(diameter_mm) => change({ diameter_mm })}
              />
            )}
          </Field>
          <Field label="Bow of struts">
            {(ids) => (
              <NumberField
                {...ids}
                label="Bow of its struts, as a share of their length"
                kind="percent"
                value={truss.bow ?? 0}
                min={0}
                max={0.5}
                onCommit={(bow) => change({ bow })}
              />
            )}
          </Field>
        </>
      )}
    </>
  );
}

/** How good a machine must be for what is required. */
export function Tolerance() {
  const { required, tolerance, askingTolerance, toleranceProblem } = useFrame();
  const stale = useToleranceStale();
  const unit = useUnit();
  const empty = useDesign((design) => design.edges.size === 0);
  const none = required.surface === null && required.force === null && required.stress === null;
  const only = required.continuum ? "The closed formulas know feeds alone." : null;
  const found = tolerance?.value;
  const rows = found && [
    {
      of: "surface",
      label: tolerance.faces === null ? "Shape" : facesOf(tolerance.faces),
      limit: required.surface,
      is: found.achieved.surface_mm,
      show: (mm: number) => displacement(mm, unit),
    },
    { of: "force", label: "Force", limit: required.force, is: found.achieved.force_n, show: force },
    { of: "stress", label: "Stress", limit: required.stress, is: found.achieved.stress_mpa ?? null, show: stress },
  ];
  const clearable = (key: "surface" | "force" | "stress") =>
    required[key] !== null && (
      <Button
        kind="quiet"
        small
        icon="close"
        aria-label="Not required"
        title="Not required"
        onClick={() => require({ [key]: null })}
      />
    );
  return (
    <Part title="Tolerance">
      <div className="stack">
        <Field label="Shape">
          {(ids) => (
            <div className="row">
              <NumberField
                {...ids}
                label="Shape off the drawing, at most"
                value={required.surface}
                positive
                min={1e-6}
                max={1e6}
                placeholder="not required"
                onCommit={(value) => require({ surface: value })}
              />
              {clearable("surface")}
            </div>
          )}
        </Field>
        <Field label="Force">
          {(ids) => (
            <div className="row">
              <NumberField
                {...ids}
                label="Force along struts, at most"
                kind="number"
                unit="N"
                value={required.force}
                positive
                min={1e-6}
                max={1e9}
                placeholder="not required"
                onCommit={(value) => require({ force: value })}
              />
              {clearable("force")}
            </div>
          )}
        </Field>
        <Field label="Stress">
          {(ids) => (
            <div className="row">
              <NumberField
                {...ids}
                label="Stress, at most"
                why={required.continuum ? "The closed formulas know no stresses." : null}
                kind="number"
                unit="MPa"
                value={required.stress}
                positive
                min={1e-6}
                max={1e9}
                placeholder="not required"
                onCommit={(value) => require({ stress: value })}
              />
              {clearable("stress")}
            </div>
          )}
        </Field>
        <Continuum />
        {!required.continuum && <Faces />}
        <Field label="Errors of">
          {() => (
            <Segmented
              label="Errors of"
              value={required.vary}
              choices={[
                { value: "feed", label: "Feeds" },
                { value: "angle", label: "Angles", why: only },
                { value: "both", label: "Both", why: only },
              ]}
              onChoose={(vary) => require({ vary })}
            />
          )}
        </Field>
        <div className="row">
          <span className="grow muted small">{stale ? "Changed since." : "All values are root mean squares."}</span>
          <Button
            why={
              empty && !required.continuum
                ? "Draw or open a design first."
                : none
                  ? "Say what is required first."
                  : askingTolerance
                    ? "It is being computed."
                    : null
            }
            onClick={() => void askTolerance()}
          >
            Find the tolerance
          </Button>
        </div>
        <div className="frame-bar">{askingTolerance && <Bar done={0} of={0} label="Tolerance" />}</div>
        {toleranceProblem && (
          <ul>
            <Line tone="error" what="No tolerance was found" sub={toleranceProblem} />
          </ul>
        )}
        {found && <Notes notes={found.notes} />}
        {found && rows && (
          <table className="figures" aria-label="Tolerance">
            <tbody>
              {found.feed_sigma_mm != null && (
                <tr>
                  <td>Feeds, standard deviation</td>
                  <td colSpan={2}>{exactness(found.feed_sigma_mm, unit)}</td>
                </tr>
              )}
              {found.angle_sigma_deg != null && (
                <tr>
                  <td>Bends and rotations, standard deviation</td>
                  <td colSpan={2}>{short(found.angle_sigma_deg, 3)}°</td>
                </tr>
              )}
              {rows.map(({ of, label, limit, is, show }) =>
                is === null ? null : (
                  <tr key={of} className={of === found.governed_by ? "governs" : undefined}>
                    <td>
                      {label}
                      {of === found.governed_by && ", which governs"}
                    </td>
                    <td>{show(is)}</td>
                    <td className="muted">{limit === null ? "not required" : `of ${show(limit)}`}</td>
                  </tr>
                ),
              )}
              {found.first_frequency && (
                <tr>
                  <td>First frequency, straight struts</td>
                  <td colSpan={2}>{frequency(found.first_frequency.straight_hz)}</td>
                </tr>
              )}
              {found.first_frequency && found.first_frequency.bow > 0 && (
                <tr>
                  <td>Where struts bow by {percent(found.first_frequency.bow, 1)}</td>
                  <td>{frequency(found.first_frequency.bowed_hz)}</td>
                  <td className="muted">
                    {found.first_frequency.bowed_between_hz.map(frequency).join(" to ")} by joints
                  </td>
                </tr>
              )}
            </tbody>
          </table>
        )}
      </div>
    </Part>
  );
}
