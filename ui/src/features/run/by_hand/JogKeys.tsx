import { type KeyboardEvent, useState } from "react";
import { Button } from "../../../shared/controls/Button";
import { Segmented } from "../../../shared/controls/inputs";
import { angle } from "../../../shared/figures/format";
import { useLengths } from "../../../shared/figures/unit";
import { type Axis, nameOf, pressedKey, STEPS, type StepName, type Steps } from "./jog_keys";

/** Moving the machine by keys, as long as the button is on and has the focus; by which step is shown, and changed, beside it. */
export function JogKeys({
  steps,
  why,
  onSteps,
  onJog,
}: {
  readonly steps: Steps;
  readonly why: string | null;
  readonly onSteps: (steps: Steps) => void;
  readonly onJog: (axis: Axis, by: number) => void;
}) {
  const [on, setOn] = useState(false);
  const { length } = useLengths();
  const step = nameOf(steps);
  const keys = (event: KeyboardEvent) => {
    const pressed = on ? pressedKey(event.nativeEvent, steps, step) : null;
    if (!pressed) return;
    event.preventDefault();
    event.stopPropagation();
    if (pressed.kind === "move") onJog(pressed.axis, pressed.by);
    else if (pressed.kind === "step") onSteps(STEPS[pressed.name]);
    else if (pressed.kind === "end") setOn(false);
  };
  return (
    <div className="stack">
      <div className="row">
        <Button
          small
          pressed={on}
          // What moves a machine ends with the focus: keys are for something else then.
          onBlur={() => setOn(false)}
          onKeyDown={keys}
          onClick={(event) => {
            // Not every engine gives a button the focus by a click.
            event.currentTarget.focus();
            setOn(!on);
          }}
        >
          Jog with keys
        </Button>
        <Segmented<StepName | "own">
          label="Step of a move by hand"
          choices={[
            { value: "fine", label: "Fine" },
            { value: "medium", label: "Medium" },
            { value: "coarse", label: "Coarse" },
          ]}
          value={step ?? "own"}
          onChoose={(name) => name !== "own" && onSteps(STEPS[name])}
        />
      </div>
      <p className={on ? "jog-keys on small" : "jog-keys small"} role="status">
        {on ? (why ?? "Keys move the machine. Esc ends it.") : "Off: keys do not move the machine."}{" "}
        <span className="muted">
          ← → feed by {length(steps.feed)} · ↑ ↓ bend by {angle(steps.bend)} · Page Up, Page Down rotate by{" "}
          {angle(steps.rotate)} · + − step
        </span>
      </p>
    </div>
  );
}
