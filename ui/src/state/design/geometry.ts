import type { Axis, DrawingPlane, SceneDesign, Vec3 } from "../../scene/interface";

/** A matrix of 4 rows and 4 columns, row by row, on positions in mm. */
export type Matrix = [Row, Row, Row, Row];
type Row = [number, number, number, number];

export const AXES: readonly Axis[] = ["x", "y", "z"];
/** Places that are nearer are one, mm. */
const NOTHING = 1e-6;
const INDEX: Readonly<Record<Axis, 0 | 1 | 2>> = { x: 0, y: 1, z: 2 };
const UNITS: Readonly<Record<Axis, Vec3>> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

export const axisIndex = (axis: Axis): 0 | 1 | 2 => INDEX[axis];
/** A vector of length 1. */
export const axisUnit = (axis: Axis): Vec3 => UNITS[axis];

export function translation([x, y, z]: Vec3): Matrix {
  return [
    [1, 0, 0, x],
    [0, 1, 0, y],
    [0, 0, 1, z],
    [0, 0, 0, 1],
  ];
}

/** By `factor` from a point that stays where it is. */
export function scaling(factor: number, [x, y, z]: Vec3): Matrix {
  const stays = 1 - factor;
  return [
    [factor, 0, 0, x * stays],
    [0, factor, 0, y * stays],
    [0, 0, factor, z * stays],
    [0, 0, 0, 1],
  ];
}

const QUARTERS = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
] as const;

/** Cosine and sine of degrees; quarter turns come out whole. */
function cosSin(deg: number): readonly [number, number] {
  const turned = ((deg % 360) + 360) % 360;
  const whole = QUARTERS[turned / 90];
  return whole ?? [Math.cos((deg * Math.PI) / 180), Math.sin((deg * Math.PI) / 180)];
}

/** Right-handed by degrees about the line from a place to another; null where they are one. */
export function turning(from: Vec3, to: Vec3, deg: number): Matrix | null {
  const size = distance(from, to);
  if (size < NOTHING) return null;
  const [x, y, z] = [0, 1, 2].map((k) => ((to[k] ?? 0) - (from[k] ?? 0)) / size) as [number, number, number];
  const [c, s] = cosSin(deg);
  const rows: readonly Vec3[] = [
    [c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
    [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
    [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)],
  ];
  const row = (k: 0 | 1 | 2): Row => {
    const [a, b, d] = rows[k] ?? [0, 0, 0];
    return [a, b, d, from[k] - a * from[0] - b * from[1] - d * from[2]];
  };
  return [row(0), row(1), row(2), [0, 0, 0, 1]];
}

/** The plane through three places: from the first, its first axis towards the second, its second axis to the side of the third; null where they are in line. */
export function planeThrough(a: Vec3, b: Vec3, c: Vec3): DrawingPlane | null {
  const way = (from: Vec3): Vec3 => [from[0] - a[0], from[1] - a[1], from[2] - a[2]];
  const unit = (of: Vec3): Vec3 | null => {
    const size = Math.hypot(...of);
    return size < NOTHING ? null : [of[0] / size, of[1] / size, of[2] / size];
  };
  const [u, w] = [unit(way(b)), way(c)];
  if (!u) return null;
  const along = u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
  const v = unit([w[0] - along * u[0], w[1] - along * u[1], w[2] - along * u[2]]);
  return v && { origin: a, u, v };
}

/** Right-handed by degrees about an axis through a point, and on along the axis by mm. */
export function rotation(axis: Axis, deg: number, through: Vec3, along = 0): Matrix {
  const [c, s] = cosSin(deg);
  const k = INDEX[axis];
  const [i, j] = [(k + 1) % 3, (k + 2) % 3];
  const matrix = translation([0, 0, 0]);
  const set = (row: number, column: number, value: number) => {
    const cells = matrix[row];
    if (cells) cells[column] = value;
  };
  set(i, i, c);
  set(i, j, -s);
  set(j, i, s);
  set(j, j, c);
  const [pi, pj] = [through[i] ?? 0, through[j] ?? 0];
  set(i, 3, pi - c * pi + s * pj);
  set(j, 3, pj - s * pi - c * pj);
  set(k, 3, along);
  return matrix;
}

/** A box, mm. */
export interface Bounds {
  readonly low: Vec3;
  readonly high: Vec3;
  readonly size: Vec3;
  readonly centre: Vec3;
}

/** The box around places; null of none. */
export function boundsOf(places: Iterable<Vec3>): Bounds | null {
  let low: Vec3 | null = null;
  let high: Vec3 | null = null;
  for (const at of places) {
    const [a, b]: [Vec3, Vec3] = [low ?? at, high ?? at];
    low = [Math.min(a[0], at[0]), Math.min(a[1], at[1]), Math.min(a[2], at[2])];
    high = [Math.max(b[0], at[0]), Math.max(b[1], at[1]), Math.max(b[2], at[2])];
  }
  if (!low || !high) return null;
  return {
    low,
    high,
    size: [high[0] - low[0], high[1] - low[1], high[2] - low[2]],
    centre: [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2],
  };
}

export function distance(a: Vec3, b: Vec3): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** The angle at a place between the ways to two others, from 0° to 180°; null where one of them is that place. */
export function angleAt(at: Vec3, from: Vec3, to: Vec3): number | null {
  const way = (end: Vec3): Vec3 | null => {
    const size = distance(at, end);
    return size > 1e-9 ? [(end[0] - at[0]) / size, (end[1] - at[1]) / size, (end[2] - at[2]) / size] : null;
  };
  const [a, b] = [way(from), way(to)];
  if (!a || !b) return null;
  // Of the half angle, which is exact for small and for large ones.
  const apart = Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  const together = Math.hypot(a[0] + b[0], a[1] + b[1], a[2] + b[2]);
  return (2 * Math.atan2(apart, together) * 180) / Math.PI;
}

/** The length of edges, mm, each counted once. */
export function lengthOf(edges: Iterable<number>, design: SceneDesign): number {
  let sum = 0;
  for (const id of edges) {
    const edge = design.edges.get(id);
    const [a, b] = [edge && design.vertices.get(edge.a), edge && design.vertices.get(edge.b)];
    if (a && b) sum += distance(a.at, b.at);
  }
  return sum;
}

/** How many edges meet at each vertex. */
export function degrees(edges: SceneDesign["edges"]): Map<number, number> {
  const all = new Map<number, number>();
  for (const { a, b } of edges.values()) {
    all.set(a, (all.get(a) ?? 0) + 1);
    all.set(b, (all.get(b) ?? 0) + 1);
  }
  return all;
}
