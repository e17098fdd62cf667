/** The handles of the gizmo: which of them is under the pointer. Pure; lengths in CSS pixels. */

import type { Axis, Vec3 } from "../interface";
import { nearOnSegment } from "../picking/picking";
import { AXES, add, dot, scale } from "../vec";
import type { Projection } from "../view/projection";
import type { Constraint } from "./move";

/** From the middle. */
export const ARROW = { from: 16, to: 66 } as const;
export const SQUARE = { from: 22, to: 36 } as const;
/** A quarter of a circle around each axis, without its ends, where the arrows are. */
export const ARC = { radius: 52, from_deg: 14, to_deg: 76 } as const;
/** Cosine of the angle between the axis of an arc and the view from which on it is not there. */
export const EDGE_ON = 0.1;

const REACH = 7;
const NAMES: readonly Axis[] = ["x", "y", "z"];

/** What moves: an axis, or a plane at right angles to one. */
export type MoveHandle = Exclude<Constraint, { readonly kind: "view" }>;

/** What turns about an axis. */
export interface TurnHandle {
  readonly kind: "turn";
  readonly axis: Axis;
}

export type Handle = MoveHandle | TurnHandle;

export const HANDLES: readonly Handle[] = [
  ...NAMES.map((axis): Handle => ({ kind: "axis", axis })),
  ...NAMES.map((normal): Handle => ({ kind: "plane", normal })),
  ...NAMES.map((axis): Handle => ({ kind: "turn", axis })),
];

/** The two other axes, in the order that keeps right-handedness. */
export function acrossOf(normal: Axis): readonly [Axis, Axis] {
  return normal === "x" ? ["y", "z"] : normal === "y" ? ["z", "x"] : ["x", "y"];
}

export function handleAt(projection: Projection, centre: Vec3, x: number, y: number): MoveHandle | null {
  if (projection.perspective && projection.depth(centre) <= 0) return null;
  const pixel = projection.pixel(centre);
  const at = (axis: Axis, far: number): Vec3 => add(centre, scale(AXES[axis], far * pixel));
  let best: MoveHandle | null = null;
  let bestOff: number = REACH;
  for (const axis of NAMES) {
    const ends = [at(axis, ARROW.from), at(axis, ARROW.to)] as const;
    const [a, b] = [projection.seen(ends[0]), projection.seen(ends[1])];
    // Seen from its end an axis is a point, and cannot be followed.
    if (Math.hypot(a.x - b.x, a.y - b.y) < 8) continue;
    const near = nearOnSegment(projection, ...ends, x, y);
    if (near && near.off < bestOff) [best, bestOff] = [{ kind: "axis", axis }, near.off];
  }
  if (best) return best;
  for (const normal of NAMES) {
    const [u, v] = acrossOf(normal);
    const corners = (
      [
        [SQUARE.from, SQUARE.from],
        [SQUARE.to, SQUARE.from],
        [SQUARE.to, SQUARE.to],
        [SQUARE.from, SQUARE.to],
      ] as const
    ).map(([a, b]) => projection.seen(add(at(u, a), scale(AXES[v], b * pixel))));
    if (within(corners, x, y)) return { kind: "plane", normal };
  }
  return null;
}

/** The arc that turns, where it is seen with some width: edge on it would be in the way of arrows. */
export function turnAt(projection: Projection, centre: Vec3, x: number, y: number): TurnHandle | null {
  if (projection.perspective && projection.depth(centre) <= 0) return null;
  const pixel = projection.pixel(centre);
  let best: TurnHandle | null = null;
  let bestOff: number = REACH;
  for (const axis of NAMES) {
    if (Math.abs(dot(projection.axes.back, AXES[axis])) < EDGE_ON) continue;
    const places = arcOf(axis).map((place) => add(centre, scale(place, pixel)));
    for (const [k, from] of places.slice(0, -1).entries()) {
      const near = nearOnSegment(projection, from, places[k + 1] ?? from, x, y);
      if (near && near.off < bestOff) [best, bestOff] = [{ kind: "turn", axis }, near.off];
    }
  }
  return best;
}

/** Places along the arc about an axis, from its middle. */
function arcOf(axis: Axis): Vec3[] {
  const [u, v] = acrossOf(axis);
  const pieces = 10;
  return Array.from({ length: pieces + 1 }, (_, k) => {
    const rad = ((ARC.from_deg + ((ARC.to_deg - ARC.from_deg) * k) / pieces) * Math.PI) / 180;
    return add(scale(AXES[u], ARC.radius * Math.cos(rad)), scale(AXES[v], ARC.radius * Math.sin(rad)));
  });
}

/** Whether a point is in a convex polygon that is seen with some area. */
function within(corners: readonly { x: number; y: number }[], x: number, y: number): boolean {
  const turns = corners.map((a, i) => {
    const b = corners[(i + 1) % corners.length] ?? a;
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  });
  // Twice the area of each triangle with the point: seen edge on, their sum is next to nothing.
  const area = Math.abs(turns.reduce((sum, turn) => sum + turn, 0)) / 2;
  return area > 30 && (turns.every((turn) => turn >= 0) || turns.every((turn) => turn <= 0));
}
