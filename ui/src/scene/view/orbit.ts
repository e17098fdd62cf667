/** Where the eye is and how it moves. Pure: angles in radians, lengths in mm, the screen in CSS pixels, z up. */

import type { Vec3 } from "../interface";
import { add, along, ballAround, dot, scale, subtract } from "../vec";

/** Turning about a target, the horizon stays level. */
export interface Orbit {
  readonly target: Vec3;
  /** Of the eye about z: 0 on the +x side, quarter turn on the +y side. */
  readonly yaw: number;
  /** Of the eye above the horizon, -90° to 90°. */
  readonly pitch: number;
  /** Of the eye from the target; it sets the scale of orthographic views too. */
  readonly distance: number;
  readonly orthographic: boolean;
}

/** Axis views are orthographic. They are named after the side that the eye is on, front is -y. */
export type ViewName = "front" | "back" | "right" | "left" | "top" | "bottom" | "perspective";

/** Vertical, of the perspective. */
export const FIELD_OF_VIEW = (36 * Math.PI) / 180;

/** Half the height that is seen at a distance of 1. */
export const HALF_HEIGHT = Math.tan(FIELD_OF_VIEW / 2);

const QUARTER = Math.PI / 2;
const NEAREST = 0.5;
const FARTHEST = 2e5;
/** Radians a pixel. */
const TURN = 0.0075;

const VIEWS: Readonly<Record<ViewName, { yaw: number; pitch: number }>> = {
  front: { yaw: -QUARTER, pitch: 0 },
  back: { yaw: QUARTER, pitch: 0 },
  right: { yaw: 0, pitch: 0 },
  left: { yaw: Math.PI, pitch: 0 },
  top: { yaw: -QUARTER, pitch: QUARTER },
  bottom: { yaw: -QUARTER, pitch: -QUARTER },
  perspective: { yaw: -1.02, pitch: 0.36 },
};

export const FIRST: Orbit = { target: [0, 0, 0], ...VIEWS.perspective, distance: 400, orthographic: false };

/** Directions of the picture, of length 1; `back` points from the target to the eye. */
export function axes({ yaw, pitch }: Orbit): { right: Vec3; up: Vec3; back: Vec3 } {
  const [sy, cy, sp, cp] = [Math.sin(yaw), Math.cos(yaw), Math.sin(pitch), Math.cos(pitch)];
  return { right: [-sy, cy, 0], up: [-sp * cy, -sp * sy, cp], back: [cp * cy, cp * sy, sp] };
}

export const eye = (orbit: Orbit): Vec3 => along(orbit.target, axes(orbit).back, orbit.distance);

/** mm a pixel at the target. */
export const pixelAtTarget = (orbit: Orbit, height: number): number =>
  (2 * orbit.distance * HALF_HEIGHT) / Math.max(height, 1);

/** Turned by dragging: the thing under the pointer goes with it. An axis view becomes a perspective. */
export function turned(orbit: Orbit, dx: number, dy: number): Orbit {
  const pitch = Math.min(Math.max(orbit.pitch + dy * TURN, -QUARTER), QUARTER);
  return { ...orbit, yaw: orbit.yaw - dx * TURN, pitch, orthographic: false };
}

/** Shifted by dragging: what is as far as the target stays under the pointer. */
export function shifted(orbit: Orbit, dx: number, dy: number, height: number): Orbit {
  const { right, up } = axes(orbit);
  const pixel = pixelAtTarget(orbit, height);
  return { ...orbit, target: along(along(orbit.target, right, -dx * pixel), up, dy * pixel) };
}

/** Nearer (`factor` below 1) or farther; what is `x` right and `y` above the middle stays where it is on the screen. */
export function zoomed(orbit: Orbit, factor: number, x: number, y: number, height: number): Orbit {
  const distance = Math.min(Math.max(orbit.distance * factor, NEAREST), FARTHEST);
  const { right, up } = axes(orbit);
  const stays = pixelAtTarget(orbit, height) * (1 - distance / orbit.distance);
  return { ...orbit, distance, target: along(along(orbit.target, right, x * stays), up, y * stays) };
}

/** Looking from a side, at the same target and scale. */
export function looking(orbit: Orbit, view: ViewName): Orbit {
  return { ...orbit, ...VIEWS[view], orthographic: view !== "perspective" };
}

/** Looking from where a direction points, at the same target and scale. Straight from above and below it looks as those views do. */
export function lookingFrom(orbit: Orbit, [x, y, z]: Vec3): Orbit {
  const across = Math.hypot(x, y);
  return { ...orbit, yaw: across < 1e-9 ? VIEWS.top.yaw : Math.atan2(y, x), pitch: Math.atan2(z, across) };
}

/** How squarely a plane is seen, by its normal of length 1: 1 straight on, 0 from its edge. */
export const squareness = (orbit: Orbit, normal: Vec3): number => Math.abs(dot(axes(orbit).back, normal));

/** Looking straight at a plane from the side that the eye is on, from that of its normal where it is on neither; without perspective. */
export function facingPlane(orbit: Orbit, normal: Vec3): Orbit {
  const [x, y, z] = dot(axes(orbit).back, normal) < -1e-6 ? scale(normal, -1) : normal;
  const yaw = Math.hypot(x, y) < 1e-9 ? VIEWS.top.yaw : Math.atan2(y, x);
  return { ...orbit, yaw, pitch: Math.asin(Math.min(Math.max(z, -1), 1)), orthographic: true };
}

/** Which of the axis views this is; null of any other. */
export function viewOf(orbit: Orbit): ViewName | null {
  const { back, up } = axes(orbit);
  const names = Object.keys(VIEWS) as ViewName[];
  const same = names.find((name) => {
    const other = axes({ ...orbit, ...VIEWS[name] });
    return dot(back, other.back) > 1 - 1e-9 && dot(up, other.up) > 1 - 1e-9;
  });
  return orbit.orthographic && same && same !== "perspective" ? same : null;
}

/** CSS pixels that framing leaves free at the left and at the right, where tools lie over the view. */
const BESIDE = 56;

/** Width to height of what framing fills of a view, CSS pixels; of a narrow one at least half. */
export function framedAspect(width: number, height: number): number {
  return Math.max(width - 2 * BESIDE, width / 2) / Math.max(height, 1);
}

/** Nearest view from the same side that shows all places with a margin, and at least `least` mm. Unchanged where there are none. */
export function framing(orbit: Orbit, places: readonly Vec3[], aspect: number, least = 20): Orbit {
  const ball = ballAround(places);
  if (!ball) return orbit;
  const { right, up, back } = axes(orbit);
  // The middle of what is seen, not of the box: a long thing seen from its end would be off centre otherwise.
  const seen = places.map((place) => subtract(place, ball.centre));
  const extent = (way: Vec3): [number, number] => {
    const reach = seen.map((place) => dot(place, way));
    return [reach.reduce((a, b) => Math.min(a, b), Infinity), reach.reduce((a, b) => Math.max(a, b), -Infinity)];
  };
  const [left, rightmost] = extent(right);
  const [low, high] = extent(up);
  const target = add(ball.centre, add(scale(right, (left + rightmost) / 2), scale(up, (low + high) / 2)));
  let distance = least / 2 / HALF_HEIGHT;
  for (const place of places) {
    const off = subtract(place, target);
    const nearer = orbit.orthographic ? 0 : dot(off, back);
    distance = Math.max(
      distance,
      nearer + Math.abs(dot(off, up)) / HALF_HEIGHT,
      nearer + Math.abs(dot(off, right)) / (HALF_HEIGHT * aspect),
    );
  }
  return { ...orbit, target, distance: Math.min(distance * 1.16, FARTHEST) };
}
