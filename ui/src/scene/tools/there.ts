/** What the pointer is on of all that is there, whatever is snapped to while something is drawn. */

import type { SnapKind } from "../interface";
import { DEFAULT_SNAP, type SnapTarget, snap } from "../picking/snap";
import type { Stage } from "../stage";

const THERE: ReadonlySet<SnapKind> = new Set(
  [...DEFAULT_SNAP.kinds].filter((kind) => kind !== "angle" && kind !== "grid" && kind !== "plane"),
);

const NOTHING = { vertices: new Set<number>(), edges: new Set<number>() };

export function there(stage: Stage, x: number, y: number): SnapTarget | null {
  const place = {
    ...stage.pickable,
    stencil: stage.stencils.empty ? null : stage.stencils.bare,
    construction: stage.pickable.lines,
    plane: null,
    without: NOTHING,
  };
  return snap(place, { ...stage.snap, kinds: THERE }, x, y);
}
