import { SessionStop } from "../features/run/StopButton";
import { ShownLengths } from "../shared/figures/unit";
import { DialogHead } from "../shared/layers/Dialog";
import { useUnits } from "../state/window/units";
import { App } from "./App";

/** The window with what its parts are given from outside: how lengths are shown, and what stands in the head of every dialog. */
export function Root() {
  return (
    <ShownLengths value={useUnits()}>
      <DialogHead value={<SessionStop />}>
        <App />
      </DialogHead>
    </ShownLengths>
  );
}
