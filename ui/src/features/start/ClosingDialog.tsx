import { Button } from "../../shared/controls/Button";
import { Dialog } from "../../shared/layers/Dialog";
import { useClosing } from "../../state/files/closing";
import type { Phase } from "../../state/machine/operator";

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
        {does ?? "A wire is being bent."} {does === undefined ? "The machine" : "It"} stops at once, and has to be homed
        before it moves again.
        {does === undefined && " The progress of the wire is recorded."}
      </p>
    </Dialog>
  );
}
