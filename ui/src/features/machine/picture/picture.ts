/**
 * A picture of a machine: its bodies seen from the front, the left and above, without perspective, far faces first. Frame of the
 * bodies: mm, x the way the wire leaves, z the bend axis. Picture: mm, x to the right, y down.
 */

import type { Shape } from "../../../generated/responses";

type Vec3 = readonly [number, number, number];

interface Face {
  readonly points: readonly (readonly [number, number])[];
  readonly part: Shape["part"];
  /** How much light it has, 0 to 1. */
  readonly light: number;
}

export interface Picture {
  readonly faces: readonly Face[];
  /** What has to be shown: x, y, width and height, mm. */
  readonly box: readonly [number, number, number, number];
}

/** Towards the eye: the machine is seen from where the wire leaves, from its right and from above. */
const EYE: Vec3 = unit([0.62, -0.68, 0.46]);
const LIGHT: Vec3 = unit([0.25, -0.5, 0.83]);
/** Sides of what is round. */
const SIDES = 24;
/** Faces longer than this are cut, so that which is further away can be said of each part, mm. */
const CUT = 60;

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const sum = (a: Vec3, b: Vec3, by = 1): Vec3 => [a[0] + b[0] * by, a[1] + b[1] * by, a[2] + b[2] * by];

function unit(v: Vec3): Vec3 {
  const size = Math.hypot(...v);
  return size > 0 ? [v[0] / size, v[1] / size, v[2] / size] : [0, 0, 1];
}

/** To the right and up in the picture; z of the machine is up. */
const RIGHT: Vec3 = unit(cross([0, 0, 1], EYE));
const UP: Vec3 = cross(EYE, RIGHT);

/** Where a place is in the picture, mm. */
export function project(at: Vec3): readonly [number, number] {
  return [dot(at, RIGHT), -dot(at, UP)];
}

/** Axes of a body: its own x, y and z. `axis` is its z; the turn is the shortest one, as in the view. */
export function axesOf(axis: Vec3): readonly [Vec3, Vec3, Vec3] {
  const w = unit(axis);
  // The shortest turn from z to w, applied to x and y; straight down it goes about x.
  if (w[2] < -1 + 1e-9) return [[1, 0, 0], [0, -1, 0], w];
  const k = 1 / (1 + w[2]);
  const x: Vec3 = [1 - w[0] * w[0] * k, -w[0] * w[1] * k, -w[0]];
  const y: Vec3 = [-w[0] * w[1] * k, 1 - w[1] * w[1] * k, -w[1]];
  return [x, y, w];
}

/** Corners around a face, seen from outside against the clock. */
type Outline = readonly Vec3[];

function boxFaces(at: Vec3, [u, v, w]: readonly [Vec3, Vec3, Vec3], [sx, sy, sz]: Vec3): Outline[] {
  const faces: Outline[] = [];
  const sides: readonly (readonly [Vec3, number, Vec3, number, Vec3, number])[] = [
    [u, sx, v, sy, w, sz],
    [v, sy, w, sz, u, sx],
    [w, sz, u, sx, v, sy],
  ];
  for (const [out, depth, a, wide, b, high] of sides) {
    for (const sign of [1, -1]) {
      const centre = sum(at, out, (sign * depth) / 2);
      const [na, nb] = [Math.max(1, Math.ceil(wide / CUT)), Math.max(1, Math.ceil(high / CUT))];
      const corner = (i: number, j: number): Vec3 =>
        sum(sum(centre, a, (i / na - 0.5) * wide), b, sign * (j / nb - 0.5) * high);
      for (let i = 0; i < na; i += 1) {
        for (let j = 0; j < nb; j += 1)
          faces.push([corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)]);
      }
    }
  }
  return faces;
}

function cylinderFaces(at: Vec3, [u, v, w]: readonly [Vec3, Vec3, Vec3], radius: number, length: number): Outline[] {
  const ring = (end: number): Vec3[] =>
    Array.from({ length: SIDES }, (_, k) => {
      const angle = (2 * Math.PI * k) / SIDES;
      return sum(sum(sum(at, u, radius * Math.cos(angle)), v, radius * Math.sin(angle)), w, (end * length) / 2);
    });
  const [low, high] = [ring(-1), ring(1)];
  const around = low.map((a, k): Outline => {
    const next = (k + 1) % SIDES;
    return [a, low[next] ?? a, high[next] ?? a, high[k] ?? a];
  });
  return [...around, high, low.toReversed()];
}

function outlines({ solid, at_mm, axis }: Shape): Outline[] {
  const axes = axesOf(axis);
  if ("box" in solid) return boxFaces(at_mm, axes, solid.box.size_mm);
  return cylinderFaces(at_mm, axes, solid.cylinder.radius_mm, solid.cylinder.length_mm);
}

/** Null where a machine has no bodies. */
export function pictureOf(shapes: readonly Shape[]): Picture | null {
  const seen: (Face & { depth: number })[] = [];
  for (const shape of shapes) {
    for (const outline of outlines(shape)) {
      const [a, b, c] = outline;
      if (!a || !b || !c) continue;
      const out = unit(cross(sum(b, a, -1), sum(c, a, -1)));
      if (dot(out, EYE) <= 1e-9) continue;
      const depth = outline.reduce((all, at) => all + dot(at, EYE), 0) / outline.length;
      const light = 0.35 + 0.65 * Math.max(0, dot(out, LIGHT));
      seen.push({ points: outline.map(project), part: shape.part, light, depth });
    }
  }
  if (seen.length === 0) return null;
  seen.sort((a, b) => a.depth - b.depth);
  const all = seen.flatMap(({ points }) => points);
  const [xs, ys] = [all.map(([x]) => x), all.map(([, y]) => y)];
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  return { faces: seen, box: [left, top, Math.max(...xs) - left, Math.max(...ys) - top] };
}
