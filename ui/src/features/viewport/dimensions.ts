import type { SceneDesign, SceneDimensions, Selection } from "../../scene/interface";
import { cornerOf, edgeOf, useExact } from "../../state/design/exact";

export const NO_DIMENSIONS: SceneDimensions = { all: false, edges: [], corners: [], stays: null };

/** The dimensions that are written in the view: those of what is selected, or of everything. */
export function dimensionsOf(selection: Selection, design: SceneDesign, all: boolean): SceneDimensions {
  const [edge, corner] = [edgeOf(selection, design), cornerOf(selection, design)];
  const { end, side } = useExact.getState();
  const stays = typeof edge !== "string" ? edge.ends[end] : typeof corner !== "string" ? corner.ends[side] : null;
  return {
    all,
    edges: typeof edge === "string" ? [] : [edge.id],
    corners: typeof corner === "string" ? [] : [corner],
    stays,
  };
}
