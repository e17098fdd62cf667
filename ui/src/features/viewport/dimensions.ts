import type { SceneDesign, SceneDimensions, Selection, Vec3 } from "../../scene/interface";
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
  const distance =
    one && other ? between(one, other) : (measured(selection, design, lines) ?? onlyLine(selection, lines));
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

/** The construction line that is all of a selection, from end to end. */
function onlyLine({ vertices, edges, lines }: Selection, all: readonly Line[]): { from: Vec3; to: Vec3 } | null {
  const [place] = lines;
  const line = vertices.size + edges.size === 0 && lines.size === 1 ? all[place ?? -1] : undefined;
  return line ? { from: line[0], to: line[1] } : null;
}
