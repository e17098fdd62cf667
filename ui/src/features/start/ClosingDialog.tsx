import { Button } from "../../shared/Button";
import { Dialog } from "../../shared/Dialog";
import { useClosing } from "../../state/closing";
import type { Phase } from "../../state/operator";

const DOES: Partial<Readonly<Record<Phase, string>>> = {
  homing: "The machine is homing.",
  moving: "The machine is being moved.",
  stopping: "The machine is being stopped.",
};

/** Asked before the window closes while a machine is at work. */
export function ClosingDialog() {
  const asked = useClosing((closing) => closing.asked);
  if (!asked) return null;
  const { phase, answer } = asked;
  const does = DOES[phase];
  return (
    <Dialog
      title="Stop the machine and close?"
      onClose={() => answer(false)}
      actions={
        <>
          <Button data-first onClick={() => answer(false)}>
            Cancel
          </Button>
          <Button kind="primary" onClick={() => answer(true)}>
            Stop and close
          </Button>
        </>
      }
    >
      <p>
        {does ?? "A wire is being made."} {does === undefined ? "The machine" : "It"} stops at once, and has to be homed before it moves again.
        {does === undefined && " How far the wire has come is on record."}
      </p>
    </Dialog>
  );
}
