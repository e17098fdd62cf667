/** Figures of what is shown of a frame. */

import type { FrameShown } from "../../generated/responses";
import type { Vec3 } from "../../scene/interface";
import type { FrameView } from "./shape";

type Shape = readonly (readonly Vec3[])[];

/** The displacements of a view, strut by strut; of wires as they are made, wire by wire. Null where there are none. */
export function movedOf({ shapes }: FrameShown, view: FrameView): { at: Shape; by: Shape } | null {
  const at = shapes.struts.map(({ at_mm }) => at_mm);
  const of = (by: Shape | null | undefined) => (by ? { at, by } : null);
  switch (view.kind) {
    case "loaded":
      return of(shapes.loaded);
    case "mode":
      return of(shapes.modes[view.mode]);
    case "closed":
      return of(shapes.closed?.closed);
    case "made":
      return shapes.closed
        ? { at: shapes.closed.made.map(({ at_mm }) => at_mm), by: shapes.closed.made.map(({ by_mm }) => by_mm) }
        : null;
  }
}

export const size = ([x, y, z]: Vec3): number => Math.hypot(x, y, z);

/** The largest of displacements, mm. */
export function largest(by: Shape): number {
  let most = 0;
  for (const points of by) for (const point of points) most = Math.max(most, size(point));
  return most;
}

/** The diagonal of the box around places, mm. */
export function extent(at: Shape): number {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const points of at)
    for (const point of points)
      for (const axis of [0, 1, 2] as const) {
        low[axis] = Math.min(low[axis] ?? 0, point[axis]);
        high[axis] = Math.max(high[axis] ?? 0, point[axis]);
      }
  const span = [0, 1, 2].map((axis) => (high[axis] ?? 0) - (low[axis] ?? 0));
  return Math.hypot(...span.filter((one) => one > 0));
}

/** Displacements are well seen as this part of the frame. */
const WELL_SEEN = 0.06;

/** By how much they are enlarged so; 1, 2 or 5 times a power of ten. */
export function usualScale({ at, by }: { at: Shape; by: Shape }): number {
  const most = largest(by);
  if (!(most > 0)) return 1;
  const wanted = (WELL_SEEN * extent(at)) / most;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const digit = wanted / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}
