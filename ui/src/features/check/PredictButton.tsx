import { useEffect } from "react";
import { Button } from "../../shared/controls/Button";
import { useDesign } from "../../state/design/design";
import { needFrameChoices, useFrame } from "../../state/frame/frame";
import { useMachines } from "../../state/machine/machines";
import { noiseOf, noiseTaken, predict, stopPrediction, usePrediction } from "../../state/prediction/prediction";
import "./check.css";

/** Predicts how far off the machine will make the design, and stops that. `why`: why it cannot. */
export function PredictButton({ why }: { readonly why: string | null }) {
  const { noise, asking } = usePrediction();
  const machine = useDesign(({ state }) => state?.machine ?? null);
  const machines = useMachines((store) => store.machines);
  const known = useFrame(({ choices }) => choices?.errors ?? null);
  useEffect(needFrameChoices, []);
  if (asking)
    return (
      <Button className="predict-go" onClick={() => void stopPrediction()}>
        Stop
      </Button>
    );
  const unknown = noiseTaken(noise, noiseOf(machines, machine), known ?? []) === null;
  return (
    <Button
      className="predict-go"
      why={unknown ? "The errors of machines are not known yet." : why}
      onClick={() => void predict()}
    >
      Predict
    </Button>
  );
}
