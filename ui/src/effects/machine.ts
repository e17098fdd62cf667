import { platform, type WindowEvent } from "../platform";
import { hearWork } from "../state/asking/work";
import { checkDesign } from "../state/design/design";
import { hearByHand, hideByHand } from "../state/machine/by_hand";
import { hearOperator, saidOf, useRun } from "../state/machine/run";
import { runClock, stopClock } from "../state/program/player";
import { usePlayback } from "../state/program/program";
import { type End, together, whenChanged } from "./changes";

/** Everything that the Rust side sends unasked. */
function hear(event: WindowEvent): void {
  switch (event.event) {
    case "work":
      hearWork(event.value);
      break;
    case "operator":
      hearOperator(event.value);
      hearByHand(event.value);
      break;
  }
}

/** What goes with a machine that is connected. */
export function followMachine(): End {
  return together([
    platform.listen(hear),
    // What a connected machine takes is part of what is checked.
    whenChanged(useRun, ({ state }) => [saidOf(state)], checkNow),
  ]);
}

function checkNow(): void {
  checkDesign();
}

/** What goes with the program that is played. */
export function followPlayback(): End {
  return together([
    stopClock,
    whenChanged(
      usePlayback,
      ({ playing }) => [playing],
      ({ playing }) => {
        if (playing) runClock();
      },
    ),
    // Only one thing is shown: a program that is played takes the place of what moves by hand have bent.
    usePlayback.subscribe(({ played }) => {
      if (played) hideByHand();
    }),
  ]);
}
