import { useShape } from "../state/frame/shape";
import { useByHand } from "../state/machine/by_hand";
import { usePlayback } from "../state/program/program";
import { runSequence, stopSequenceClock } from "../state/sequence/clock";
import { hideSequence, useSequence } from "../state/sequence/sequence";
import { type End, together, whenChanged } from "./changes";

/** What goes with a sequence that is shown: only one thing is shown in the view. */
export function followSequence(): End {
  return together([
    stopSequenceClock,
    whenChanged(
      useSequence,
      ({ playing }) => [playing],
      ({ playing }) => {
        if (playing) runSequence();
      },
    ),
    whenChanged(
      usePlayback,
      ({ played }) => [played],
      ({ played }) => {
        if (played) hideSequence();
      },
    ),
    whenChanged(
      useByHand,
      ({ played }) => [played],
      ({ played }) => {
        if (played) hideSequence();
      },
    ),
    whenChanged(
      useShape,
      ({ view }) => [view],
      ({ view }) => {
        if (view) hideSequence();
      },
    ),
  ]);
}
