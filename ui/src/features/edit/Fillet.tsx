import { useState } from "react";
import { Field } from "../../shared/controls/Field";
import { NumberField } from "../../shared/controls/NumberField";
import { count } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { tell } from "../../state/asking/problems";
import { fillet } from "../../state/design/operations";
import { whyNot } from "../../state/window/commands";
import { Do } from "./forms";

/** Corners rounded by a radius. What comes out is told: the machine's shortest edge decides how many chords there are. */
export function FilletForm() {
  const [radius, setRadius] = useState(30);
  const [step, setStep] = useState(15);
  const { length } = useLengths();
  const make = async (by: number) => {
    if (whyNot("fillet")) return;
    const made = await fillet(by, step);
    if (!made) return;
    const chords = `${count(made.chords, "chord")} of ${length(made.mm)}`;
    tell("info", `${count(made.corners, "corner")} rounded to a radius of ${length(by)} with ${chords}.`, "fillet");
  };
  return (
    <>
      <Field label="Radius" hint="Of the arc that the chords follow.">
        {({ id }) => (
          <NumberField
            id={id}
            label="Radius"
            value={radius}
            onCommit={setRadius}
            onEnter={(entered) => void make(entered)}
          />
        )}
      </Field>
      <Field label="Step" hint="Largest bend angle between two chords. No chord is shorter than the machine can make.">
        {({ id }) => <NumberField id={id} kind="angle" label="Step" value={step} min={1} max={90} onCommit={setStep} />}
      </Field>
      <Do command="fillet" onDo={() => void make(radius)}>
        Fillet
      </Do>
    </>
  );
}
