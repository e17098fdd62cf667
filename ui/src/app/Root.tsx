import { SessionStop } from "../features/run/StopButton";
import { ShownUnit } from "../shared/figures/unit";
import { DialogHead } from "../shared/layers/Dialog";
import { useUnits } from "../state/window/units";
import { App } from "./App";

/** The window with what its parts are given from outside: how lengths are shown, and what stands in the head of every dialog. */
export function Root() {
  return (
    <ShownUnit value={useUnits(({ unit }) => unit)}>
      <DialogHead value={<SessionStop />}>
        <App />
      </DialogHead>
    </ShownUnit>
  );
}
