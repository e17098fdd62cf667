import { Checkbox } from "../../shared/controls/inputs";
import { sentence } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { choosePrediction, usePrediction, usePredictionStale } from "../../state/prediction/prediction";
import { useRunFile } from "../../state/program/run_file";
import { PredictButton } from "../check/PredictButton";
import { farthest } from "../check/spread";
import { displacement } from "../frame/words";

/** How far off the vertices come out, while the wire is played: what *Accuracy* in *Check* has predicted, or predicts now. */
export function Expected() {
  const { answer, problem, shown, asking } = usePrediction();
  const stale = usePredictionStale();
  const ofFile = useRunFile(({ file }) => file !== null);
  const unit = useUnit();
  if (ofFile) return null;
  const far = answer && !stale ? farthest(answer.value) : null;
  const status = asking
    ? "Predicting…"
    : problem
      ? sentence(problem)
      : far
        ? `Worst vertex: 95 % within ${displacement(far.radius, unit)}`
        : stale
          ? "Changed since it was predicted."
          : "How far off each vertex comes out.";
  return (
    <div className="stack">
      <div className="row">
        <Checkbox
          checked={shown && far !== null}
          why={far ? null : "Predict the accuracy first."}
          onChange={(checked) => choosePrediction({ shown: checked })}
        >
          Accuracy
        </Checkbox>
        <span className="grow" />
        <PredictButton why={far ? "It is predicted already." : null} />
      </div>
      <p className="muted small expected" role="status" title={status}>
        {status}
      </p>
    </div>
  );
}
