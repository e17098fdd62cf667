import { Button } from "../../../shared/controls/Button";
import { Segmented } from "../../../shared/controls/inputs";
import { Dialog } from "../../../shared/layers/Dialog";
import {
  type CalibrationStep,
  closeCalibration,
  showStep,
  useCalibration,
} from "../../../state/calibration/calibration";
import { useMachines } from "../../../state/machine/machines";
import { Apply } from "./Apply";
import { Coupons } from "./Coupons";
import { Fit } from "./Fit";
import { Measure } from "./Measure";
import { Versions } from "./Versions";
import { progressOf, versionsOf } from "./words";
import "./calibrate.css";

const STEPS: readonly { readonly value: CalibrationStep; readonly label: string }[] = [
  { value: "coupons", label: "1  Coupons" },
  { value: "measure", label: "2  Measure" },
  { value: "fit", label: "3  Fit" },
  { value: "apply", label: "4  Apply" },
];

/** What earlier calibrations made; no step of this one. */
const VERSIONS = { value: "versions", label: "Versions" } as const;

/** From coupons to profiles of one's own machine and wire, in four steps. */
export function CalibrationDialog() {
  const { open, step, sheet, report, problem } = useCalibration();
  const { machines } = useMachines();
  if (!open) return null;
  const whyNot = (of: CalibrationStep): string | null => {
    if (of === "versions") return versionsOf(machines ?? []).length > 0 ? null : "Nothing is calibrated yet.";
    if (of === "coupons") return null;
    if (!sheet) return "Make coupons or open a sheet first.";
    return of !== "measure" && !report ? "Enter readings first." : null;
  };
  const at = STEPS.findIndex(({ value }) => value === step);
  const next = at < 0 ? null : (STEPS[at + 1] ?? null);
  const before = STEPS[at - 1] ?? null;
  return (
    <Dialog
      title="Calibrate machine and wire"
      onClose={closeCalibration}
      large
      actions={
        <>
          <p className="grow calibrate-state ellipsis" aria-live="polite">
            {problem ? <span className="value-refused">{problem}</span> : progressOf(sheet, report)}
          </p>
          {before && <Button onClick={() => showStep(before.value)}>Back</Button>}
          {next ? (
            <Button
              kind="primary"
              className="calibrate-next"
              why={whyNot(next.value)}
              onClick={() => showStep(next.value)}
            >
              Next
            </Button>
          ) : (
            <Button kind="primary" className="calibrate-next" onClick={closeCalibration}>
              Done
            </Button>
          )}
        </>
      }
    >
      <Segmented
        label="Step"
        value={step}
        choices={[...STEPS, VERSIONS].map((one) => ({ ...one, why: whyNot(one.value) }))}
        onChoose={showStep}
      />
      <div className="calibrate-step">
        {step === "coupons" && <Coupons />}
        {step === "measure" && <Measure />}
        {step === "fit" && <Fit />}
        {step === "apply" && <Apply />}
        {step === "versions" && <Versions />}
      </div>
    </Dialog>
  );
}
