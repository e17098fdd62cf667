import type { SceneDesign, SceneDimensions, Selection } from "../../scene/interface";
import type { Line } from "../../state/construction/lines";
import { cornerOf, edgeOf, useExact } from "../../state/design/exact";
import { between, measured } from "../../state/design/measure";
import { useView } from "../../state/window/view";

export const NO_DIMENSIONS: SceneDimensions = { all: false, edges: [], corners: [], between: null, stays: null };

/** The dimensions that are written in the view: those of what is selected, or of everything. */
export function dimensionsOf(
  selection: Selection,
  design: SceneDesign,
  lines: readonly Line[],
  all: boolean,
): SceneDimensions {
  const [edge, corner] = [edgeOf(selection, design), cornerOf(selection, design)];
  const { measuring } = useView.getState();
  const [one, other] = measuring;
  const distance = one && other ? between(one, other) : measured(selection, design, lines);
  const { end, side } = useExact.getState();
  const stays = typeof edge !== "string" ? edge.ends[end] : typeof corner !== "string" ? corner.ends[side] : null;
  return {
    all,
    edges: typeof edge === "string" ? [] : [edge.id],
    between: distance && (other || typeof edge === "string") ? [distance.from, distance.to] : null,
    corners: typeof corner === "string" ? [] : [corner],
    stays,
  };
}
