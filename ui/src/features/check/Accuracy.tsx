import { useMemo } from "react";
import type { Prediction } from "../../generated/responses";
import { Field } from "../../shared/controls/Field";
import { Bar, Checkbox, Select } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { number, percent, sentence, short } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { Line } from "../../shared/lists/Line";
import { useWork } from "../../state/asking/work";
import { useDesign } from "../../state/design/design";
import { select } from "../../state/design/selection";
import { useFrame } from "../../state/frame/frame";
import { useMachines } from "../../state/machine/machines";
import {
  choosePrediction,
  noiseOf,
  noiseTaken,
  usePrediction,
  usePredictionStale,
} from "../../state/prediction/prediction";
import { frame } from "../../state/window/view";
import { gradientOf } from "../frame/ramp";
import { displacement, exactness } from "../frame/words";
import { Part } from "../panel/Section";
import { PredictButton } from "./PredictButton";
import { bends, farthest, hottest, sources, widest } from "./spread";
import { VertexAccuracy } from "./VertexAccuracy";

/** So many bends are named. */
const NAMED = 3;

const SOURCES: Readonly<Record<ReturnType<typeof sources>[number]["source"], string>> = {
  feed: "Feeds",
  rotation: "Rotations",
  bend: "Bends",
  curvature: "Bows of edges",
};

/** How far off the machine will make the design, before it is bent. */
export function Accuracy() {
  const { noise, within, answer, problem, shown, asking } = usePrediction();
  const machines = useMachines((store) => store.machines);
  const stale = usePredictionStale();
  const machine = useDesign(({ state }) => state?.machine ?? null);
  const check = useDesign((design) => design.check);
  const known = useFrame(({ choices }) => choices?.errors ?? null);
  const work = useWork(({ works }) => works.get("predict"));
  const taken = noiseTaken(noise, noiseOf(machines, machine), known ?? []);
  const hasProgram = check?.wires.some(({ bends }) => bends !== null) ?? false;
  const why = hasProgram ? null : "There is no program yet: the findings above say why.";
  return (
    <Part title="Accuracy">
      <div className="stack">
        <Field label="Errors of">
          {(ids) => (
            <Select
              {...ids}
              value={taken ?? ""}
              choices={(known ?? []).map(({ id, name }) => ({ value: id, label: name }))}
              onChoose={(id) => choosePrediction({ noise: id })}
            />
          )}
        </Field>
        <Field label="Within">
          {(ids) => (
            <NumberField
              {...ids}
              label="How close every vertex has to be to its place"
              value={within}
              positive
              min={1e-3}
              max={1e4}
              onCommit={(value) => choosePrediction({ within: value })}
            />
          )}
        </Field>
        <div className="row">
          <span className="grow muted small" role="status">
            {asking ? "Predicting…" : stale ? "Changed since it was predicted." : ""}
          </span>
          <PredictButton why={why} />
        </div>
        <div className="predict-bar">
          {asking && <Bar done={work?.done ?? 0} of={work?.of ?? 0} label="Predicting" />}
        </div>
        {problem && (
          <ul>
            <Line tone="error" what="The accuracy was not predicted" sub={sentence(problem)} />
          </ul>
        )}
        {answer && <Results prediction={answer.value} />}
        {answer && (
          <Checkbox
            checked={shown && !stale}
            why={stale ? "Predict it again first." : null}
            onChange={(checked) => choosePrediction({ shown: checked })}
          >
            Show in the view
          </Checkbox>
        )}
      </div>
    </Part>
  );
}

function Vertex({ vertex }: { readonly vertex: number }) {
  const go = () => {
    select([vertex], []);
    frame([vertex], []);
  };
  return (
    <button type="button" className="button link" onClick={go}>
      vertex {vertex}
    </button>
  );
}

function Results({ prediction }: { readonly prediction: Prediction }) {
  const unit = useUnit();
  const far = useMemo(() => farthest(prediction), [prediction]);
  const gap = useMemo(() => widest(prediction), [prediction]);
  const by = useMemo(() => sources(prediction).filter(({ rms }) => rms > 0), [prediction]);
  const named = useMemo(() => bends(prediction, NAMED), [prediction]);
  const squares = by.reduce((sum, { rms }) => sum + rms * rms, 0);
  return (
    <>
      <table className="figures" aria-label="Expected accuracy">
        <thead>
          <tr>
            <th scope="col">Off the design</th>
            <th scope="col">on average</th>
            <th scope="col">95 % within</th>
          </tr>
        </thead>
        <tbody>
          {far && (
            <tr>
              <td>
                Worst, <Vertex vertex={far.vertex} />
              </td>
              <td>{displacement(far.mean, unit)}</td>
              <td>{displacement(far.radius, unit)}</td>
            </tr>
          )}
          {gap && (
            <tr>
              <td>
                Gap at <Vertex vertex={gap.vertex} />
              </td>
              <td>{displacement(gap.mean, unit)}</td>
              <td>{displacement(gap.radius, unit)}</td>
            </tr>
          )}
        </tbody>
      </table>
      {far && far.radius > 0 && (
        <div>
          <div className="predict-ramp" style={{ background: gradientOf("rising") }} />
          <div className="predict-ends">
            <span>0</span>
            <span>Colour: off on average</span>
            <span>{displacement(hottest(prediction), unit)}</span>
          </div>
        </div>
      )}
      {by.length > 0 && (
        <table className="figures" aria-label="What the errors come from">
          <thead>
            <tr>
              <th scope="col">Comes from</th>
              <th scope="col">RMS</th>
              <th scope="col">share</th>
            </tr>
          </thead>
          <tbody>
            {by.map(({ source, rms }) => (
              <tr key={source}>
                <td>{SOURCES[source]}</td>
                <td>{displacement(rms, unit)}</td>
                <td>{percent((rms * rms) / squares, 0)}</td>
              </tr>
            ))}
            {named.length > 0 && (
              <tr>
                <td colSpan={3}>
                  Bends that matter most:{" "}
                  {named.map(({ vertex }, index) => (
                    // biome-ignore lint/suspicious/noArrayIndexKey: a vertex may be there twice
                    <span key={index}>
                      {index > 0 && ", "}
                      <Vertex vertex={vertex} />
                    </span>
                  ))}
                </td>
              </tr>
            )}
          </tbody>
        </table>
      )}
      <VertexAccuracy prediction={prediction} />
      <Needed prediction={prediction} />
      <p className="muted small">
        {number(prediction.runs, 0)} wires were bent by the formulas, with the first edge in place.
      </p>
    </>
  );
}

/** How exact a machine must be. */
function Needed({ prediction: { tolerance } }: { readonly prediction: Prediction }) {
  const unit = useUnit();
  if (!tolerance) return null;
  const within = exactness(tolerance.within_mm, unit);
  if (!tolerance.possible)
    return (
      <ul>
        <Line
          tone="warning"
          what={`No machine makes it within ${within}`}
          sub="Without errors a vertex is farther off already. The findings above say why."
        />
      </ul>
    );
  const sigma = ({ source, sigma }: (typeof tolerance.alone)[number]): string => {
    if (sigma == null) return "any";
    if (source === "feed") return `± ${exactness(sigma, unit)}`;
    return source === "curvature" ? `± ${percent(sigma, 1)}` : `± ${short(sigma, 3)}°`;
  };
  return (
    <table className="figures" aria-label="Tolerance">
      <thead>
        <tr>
          <th scope="col">To be within {within}</th>
          <th scope="col">each alone, σ</th>
        </tr>
      </thead>
      <tbody>
        {tolerance.alone.map((one) => (
          <tr key={one.source}>
            <td>{SOURCES[one.source]}</td>
            <td>{sigma(one)}</td>
          </tr>
        ))}
        {tolerance.together != null && (
          <tr>
            <td>All of them, times</td>
            <td>{short(tolerance.together, 3)}</td>
          </tr>
        )}
      </tbody>
    </table>
  );
}
