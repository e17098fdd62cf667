import { select, useSelection } from "../state/design/selection";
import { toggleSupports, useFrame } from "../state/frame/frame";
import { runSwing, showFrame, stopSwing, useShape } from "../state/frame/shape";
import { useByHand } from "../state/machine/by_hand";
import { usePlayback } from "../state/program/program";
import { type End, together, whenChanged } from "./changes";

/** What goes with a frame that is computed and shown. */
export function followFrame(): End {
  return together([
    stopSwing,
    whenChanged(
      useShape,
      ({ swinging }) => [swinging],
      ({ swinging }) => {
        if (swinging) runSwing();
      },
    ),
    // Only one thing is shown in the view.
    whenChanged(
      usePlayback,
      ({ played }) => [played],
      ({ played }) => {
        if (played) showFrame(null);
      },
    ),
    whenChanged(
      useByHand,
      ({ played }) => [played],
      ({ played }) => {
        if (played) showFrame(null);
      },
    ),
    // While supports are picked, a click chooses one and selects nothing.
    whenChanged(
      useSelection,
      ({ vertices }) => [vertices],
      ({ vertices }) => {
        if (!useFrame.getState().picking || vertices.size === 0) return;
        toggleSupports(vertices);
        select([]);
      },
    ),
  ]);
}
