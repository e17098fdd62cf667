/** What is under the pointer, by distance on the screen: thin things could not be hit with a ray. */

import type { Vec3 } from "../interface";
import type { DrawnDesign } from "../layers/drawn_design";
import type { Projection } from "../view/projection";

export interface PickedVertex {
  readonly kind: "vertex";
  readonly id: number;
  readonly at: Vec3;
}

export interface PickedEdge {
  readonly kind: "edge";
  readonly id: number;
  /** Where on it: 0 at `a`, 1 at `b`. */
  readonly along: number;
  readonly at: Vec3;
}

/** A construction line, by its place in the list. */
interface PickedLine {
  readonly kind: "line";
  readonly id: number;
  readonly at: Vec3;
}

export type Picked = PickedVertex | PickedEdge | PickedLine;

/** CSS pixels. A finger needs more. */
const REACH = { vertex: 10, edge: 7, touch: 22 } as const;

/** Of two things that are as near as a hand can point, the one in front is meant. */
const AS_NEAR = 2;

interface Candidate {
  readonly off: number;
  readonly depth: number;
}

/** The nearest to the pointer; in front among those that are about as near. */
export function nearest<T extends Candidate>(candidates: readonly T[]): T | null {
  let least = Infinity;
  for (const { off } of candidates) least = Math.min(least, off);
  let best: T | null = null;
  for (const candidate of candidates) {
    if (candidate.off <= least + AS_NEAR && (best === null || candidate.depth < best.depth)) best = candidate;
  }
  return best;
}

export function pickVertex(
  design: DrawnDesign,
  projection: Projection,
  x: number,
  y: number,
  reach: number,
  without: (id: number) => boolean = () => false,
): PickedVertex | null {
  const found: (Candidate & PickedVertex)[] = [];
  design.vertices.forEach(({ id }, row) => {
    const at = design.at[row];
    if (!at || without(id)) return;
    const seen = projection.seen(at);
    const off = Math.hypot(seen.x - x, seen.y - y);
    if (projection.sees(seen) && off <= reach) found.push({ kind: "vertex", id, at, off, depth: seen.depth });
  });
  const best = nearest(found);
  return best && { kind: "vertex", id: best.id, at: best.at };
}

export function pickEdge(
  design: DrawnDesign,
  projection: Projection,
  x: number,
  y: number,
  reach: number,
  without: (row: number) => boolean = () => false,
): PickedEdge | null {
  const found: (Candidate & PickedEdge)[] = [];
  design.edges.forEach(({ id }, row) => {
    if (without(row)) return;
    const [a, b] = design.segment(row);
    const near = nearOnSegment(projection, a, b, x, y);
    if (near && near.off <= reach) found.push({ kind: "edge", id, ...near });
  });
  const best = nearest(found);
  return best && { kind: "edge", id: best.id, along: best.along, at: best.at };
}

/** What there is to be clicked on. */
export interface Pickable {
  readonly design: DrawnDesign;
  readonly projection: Projection;
  /** Construction lines by their two ends. */
  readonly lines: readonly (readonly [Vec3, Vec3])[];
}

/** A vertex before an edge: it is smaller, and edges end in it. An edge before a construction line that is about as near. */
export function pick({ design, projection, lines }: Pickable, x: number, y: number, touch: boolean): Picked | null {
  const reach = touch ? { vertex: REACH.touch, edge: REACH.touch } : REACH;
  const vertex = pickVertex(design, projection, x, y, reach.vertex);
  if (vertex) return vertex;
  const edge = pickEdge(design, projection, x, y, reach.edge);
  const line = pickLine(lines, projection, x, y, reach.edge);
  if (!line || !edge) return edge ?? line;
  const seen = projection.seen(edge.at);
  return Math.hypot(seen.x - x, seen.y - y) <= line.off + AS_NEAR ? edge : line;
}

function pickLine(
  lines: Pickable["lines"],
  projection: Projection,
  x: number,
  y: number,
  reach: number,
): (Candidate & PickedLine) | null {
  const found = lines.flatMap(([a, b], id) => {
    const near = nearOnSegment(projection, a, b, x, y);
    return near && near.off <= reach ? [{ kind: "line" as const, id, ...near }] : [];
  });
  return nearest(found);
}

/** The place of a segment that is nearest to the pointer on the screen; null where all of it is behind the eye. */
export function nearOnSegment(
  projection: Projection,
  a: Vec3,
  b: Vec3,
  x: number,
  y: number,
): { along: number; at: Vec3; off: number; depth: number } | null {
  const seen = projection.segment(a, b);
  if (!seen) return null;
  const [dx, dy] = [seen.b.x - seen.a.x, seen.b.y - seen.a.y];
  const size = dx * dx + dy * dy;
  const fraction = size > 0 ? Math.min(Math.max(((x - seen.a.x) * dx + (y - seen.a.y) * dy) / size, 0), 1) : 0;
  const off = Math.hypot(seen.a.x + dx * fraction - x, seen.a.y + dy * fraction - y);
  const along = projection.onSegment(seen, fraction);
  const at: Vec3 = [a[0] + (b[0] - a[0]) * along, a[1] + (b[1] - a[1]) * along, a[2] + (b[2] - a[2]) * along];
  return { along, at, off, depth: projection.depth(at) };
}
