/** Where a drag leads: in the plane of the view, along an axis, or in a plane. Pure. */

import type { Axis, Vec3 } from "../interface";
import { AXES, along, alongAxis, dot, ORIGIN, onPlane, scale, subtract } from "../vec";
import type { Projection } from "../view/projection";

export type Constraint =
  | { readonly kind: "view" }
  | { readonly kind: "axis"; readonly axis: Axis }
  /** In the plane at right angles to `normal`. */
  | { readonly kind: "plane"; readonly normal: Axis };

export const FREE: Constraint = { kind: "view" };

/** Pointer on the screen, CSS pixels. */
export interface Pointer {
  readonly x: number;
  readonly y: number;
}

/** How far `anchor` goes, mm, when the pointer goes from `start` to `now`. Nowhere where the view gives no answer: an axis seen from its end. */
export function displacement(
  constraint: Constraint,
  anchor: Vec3,
  start: Pointer,
  now: Pointer,
  projection: Projection,
): Vec3 {
  const rays = [projection.ray(start.x, start.y), projection.ray(now.x, now.y)] as const;
  if (constraint.kind === "axis") {
    const axis = AXES[constraint.axis];
    const [from, to] = [alongAxis(rays[0], anchor, axis), alongAxis(rays[1], anchor, axis)];
    return from === null || to === null ? ORIGIN : scale(axis, to - from);
  }
  const normal = constraint.kind === "plane" ? AXES[constraint.normal] : projection.axes.back;
  const [from, to] = [onPlane(rays[0], anchor, normal), onPlane(rays[1], anchor, normal)];
  return from && to ? subtract(to, from) : ORIGIN;
}

/** The part of a displacement that the constraint allows. */
export function allowed(constraint: Constraint, by: Vec3): Vec3 {
  if (constraint.kind === "axis") return scale(AXES[constraint.axis], dot(by, AXES[constraint.axis]));
  if (constraint.kind === "plane") return along(by, AXES[constraint.normal], -dot(by, AXES[constraint.normal]));
  return by;
}

/** The nearest point of the grid (mm), in the directions that the constraint and the view leave free; the others stay as they are. */
export function onGrid(constraint: Constraint, at: Vec3, grid: number, back: Vec3): Vec3 {
  if (!(grid > 0)) return at;
  const names = ["x", "y", "z"] as const;
  return names.map((name, i) => {
    const value = at[i] ?? 0;
    const fixed =
      constraint.kind === "axis"
        ? constraint.axis !== name
        : constraint.kind === "plane"
          ? constraint.normal === name
          : Math.abs(back[i] ?? 0) > 0.999;
    return fixed ? value : Math.round(value / grid) * grid;
  }) as unknown as Vec3;
}
