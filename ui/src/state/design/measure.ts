/** What is between two things: vertices or edges that are selected, or any two that are measured in the view. */

import type { MeasuredThing, SceneDesign, Selection, Vec3 } from "../../scene/interface";
import type { Line } from "../construction/lines";
import { angleAt, distance } from "./geometry";

export interface Measured {
  /** Where the two are nearest to each other, mm. */
  readonly from: Vec3;
  readonly to: Vec3;
  readonly mm: number;
  /** Between two edges, as lines: from 0° to 90°. */
  readonly deg: number | null;
}

/** Nearest places, angle and distance; null where not just two things are selected. `drawn`: the construction lines. */
export function measured(
  { vertices, edges, lines }: Selection,
  design: SceneDesign,
  drawn: readonly Line[],
): Measured | null {
  if (vertices.size + edges.size + lines.size !== 2) return null;
  const things: (readonly [Vec3 | undefined, Vec3 | undefined])[] = [
    ...[...vertices].map((id) => [design.vertices.get(id)?.at, design.vertices.get(id)?.at] as const),
    ...[...edges].map((id) => {
      const edge = design.edges.get(id);
      return [edge && design.vertices.get(edge.a)?.at, edge && design.vertices.get(edge.b)?.at] as const;
    }),
    ...[...lines].map((place) => drawn[place] ?? ([undefined, undefined] as const)),
  ];
  const [[a, b], [c, d]] = [things[0] ?? [], things[1] ?? []];
  if (!a || !b || !c || !d) return null;
  return between({ from: a, to: b }, { from: c, to: d });
}

/** The same between two things wherever they come from; an angle between two that have a length. */
export function between(one: MeasuredThing, other: MeasuredThing): Measured {
  const [from, to] = nearest([one.from, one.to], [other.from, other.to]);
  const [u, v] = [subtract(one.to, one.from), subtract(other.to, other.from)];
  const turned = angleAt([0, 0, 0], u, v);
  return { from, to, mm: distance(from, to), deg: turned === null ? null : Math.min(turned, 180 - turned) };
}

type Segment = readonly [Vec3, Vec3];

const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = ([a, b]: Segment, share: number): Vec3 => [
  a[0] + (b[0] - a[0]) * share,
  a[1] + (b[1] - a[1]) * share,
  a[2] + (b[2] - a[2]) * share,
];
const within = (share: number): number => Math.min(1, Math.max(0, share));

/** The places of two straight pieces that are nearest to each other; a piece may be a point (Ericson, Real-Time Collision Detection, 5.1.9). */
function nearest(one: Segment, other: Segment): readonly [Vec3, Vec3] {
  const [u, v, w] = [subtract(one[1], one[0]), subtract(other[1], other[0]), subtract(one[0], other[0])];
  const [a, b, c, d, e] = [dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)];
  const apart = a * c - b * b;
  // In parallel any place of the one serves; the other is then the nearest to it.
  let s = apart > 1e-12 * a * c ? within((b * e - c * d) / apart) : 0;
  let t = c > 0 ? (b * s + e) / c : 0;
  if (t !== within(t) || c === 0) {
    t = within(t);
    s = a > 0 ? within((b * t - d) / a) : 0;
  }
  return [along(one, s), along(other, t)];
}
