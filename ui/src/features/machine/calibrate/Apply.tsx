import { useState } from "react";
import { Button } from "../../../shared/controls/Button";
import { Field } from "../../../shared/controls/Field";
import { Checkbox, TextInput } from "../../../shared/controls/inputs";
import { Line } from "../../../shared/lists/Line";
import {
  applyCalibration,
  revertCalibration,
  useIsOfReadings,
  useWhyNotBack,
} from "../../../state/calibration/applying";
import { useCalibration } from "../../../state/calibration/calibration";
import { useMachines } from "../../../state/machine/machines";
import { isSlug } from "../profile/slug";
import { Compared } from "./Compared";

/** "my-wirebend-kit", and what is one's own stays as it is. */
const ownId = (id: string): string => (id.startsWith("my-") ? `${id}-2` : `my-${id}`);

/** Profiles of what was found, which the design takes; what changes by it, and the way back. */
export function Apply() {
  const { sheet, applied, reverted, busy } = useCalibration();
  const whyNotBack = useWhyNotBack();
  const { machines, materials } = useMachines();
  const [machine, setMachine] = useState(ownId(sheet?.machine ?? "machine"));
  const [material, setMaterial] = useState(ownId(sheet?.material ?? "wire"));
  const [force, setForce] = useState(false);
  if (!sheet) return null;
  const taken = (id: string, all: readonly { readonly id: string; readonly shipped: boolean }[] | null) =>
    all?.find((entry) => entry.id === id) ?? null;
  const wrong = (id: string, all: Parameters<typeof taken>[1], parent: string): string | null => {
    if (!isSlug(id)) return "Use lower-case letters, digits and single hyphens between them.";
    if (id === parent) return "Choose another id: it inherits from this one.";
    return taken(id, all)?.shipped ? "This profile comes with the program. Choose another id." : null;
  };
  const wrongMachine = wrong(machine, machines, sheet.machine);
  const wrongMaterial = wrong(material, materials, sheet.material);
  const replaces = taken(machine, machines) !== null || taken(material, materials) !== null;
  const why =
    wrongMachine ??
    wrongMaterial ??
    (busy ? "Wait until this is done." : replaces && !force ? "Allow that the profiles are replaced." : null);
  return (
    <div className="calibrate-columns">
      <div className="stack">
        <p>
          Both profiles inherit from those that the coupons were planned with. Each value says when it was calibrated
          and from how many readings. The design takes them.
        </p>
        <Field label="Machine" error={wrongMachine}>
          {(ids) => <TextInput {...ids} value={machine} onChange={(event) => setMachine(event.currentTarget.value)} />}
        </Field>
        <Field label="Wire" error={wrongMaterial}>
          {(ids) => (
            <TextInput {...ids} value={material} onChange={(event) => setMaterial(event.currentTarget.value)} />
          )}
        </Field>
        <Checkbox checked={force} onChange={setForce} why={replaces ? null : "There are no profiles of these ids yet."}>
          Replace the profiles that have these ids
        </Checkbox>
        <div className="row wrap">
          <Button kind="primary" why={why} onClick={() => void applyCalibration(machine, material, replaces)}>
            Apply
          </Button>
          <Button icon="undo" why={whyNotBack} onClick={() => void revertCalibration()}>
            Take back
          </Button>
        </div>
        {applied && (
          <ul aria-live="polite">
            <Outcome />
            {!reverted && applied.result.report.doubts.map((text) => <Line key={text} tone="warning" what={text} />)}
            {!reverted && applied.result.report.gaps.map((text) => <Line key={text} tone="info" what={text} />)}
          </ul>
        )}
      </div>
      {applied?.compared ? (
        <Compared compared={applied.compared} />
      ) : (
        <p className="muted">What changes is listed here.</p>
      )}
    </div>
  );
}

/** What became of the design and of profiles. */
function Outcome() {
  const { applied, reverted } = useCalibration();
  const whyNotBack = useWhyNotBack();
  const isOfReadings = useIsOfReadings();
  if (!applied) return null;
  const { result, before, replaced } = applied;
  const given = `The design was given ${result.machine} with ${result.material}`;
  if (reverted) {
    const profiles = !replaced
      ? "The new profiles stay in your list of machines and wires."
      : reverted.profiles
        ? "The profiles that were replaced are as before."
        : "Profiles were changed since: those that were replaced stay as they are.";
    return reverted.design ? (
      <Line tone="info" what={`The design was given ${before.machine} again`} sub={profiles} />
    ) : (
      <Line tone="info" what={profiles} />
    );
  }
  if (whyNotBack) return <Line tone="info" what={given} sub={whyNotBack} />;
  if (!isOfReadings)
    return <Line tone="warning" what={given} sub="The readings were changed since. Apply again to take them." />;
  return <Line tone="fine" what={given} sub={result.files.join(", ")} />;
}
