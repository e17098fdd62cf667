import { isOpen, stop, useRun } from "../../state/machine/run";
import "./stop.css";

/** Stops the machine the moment it is pressed. There as long as a machine is connected. */
export function StopButton() {
  const open = useRun((run) => isOpen(run.state));
  return (
    <button
      type="button"
      className="stop-button"
      // Without a machine it is grey, and pressing it stops whatever there is anyway.
      aria-disabled={!open || undefined}
      title={open ? "Stops the machine at once" : "No machine is connected"}
      aria-keyshortcuts="Control+Space"
      // When the finger comes down, not when it goes up.
      onPointerDown={(event) => {
        if (event.button === 0) stop();
      }}
      onKeyDown={(event) => {
        if ((event.key === "Enter" || event.key === " ") && !event.repeat) stop();
      }}
      // Pressed by something that is no pointer and no key.
      onClick={(event) => {
        if (event.detail === 0) stop();
      }}
    >
      STOP <kbd>Ctrl-Space</kbd>
    </button>
  );
}

/** STOP where it is only wanted as long as there is something to stop: in the head of every dialog. */
export function SessionStop() {
  return useRun((run) => isOpen(run.state)) ? <StopButton /> : null;
}
