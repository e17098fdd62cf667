/** Which corner and which edge of triangles near the pointer are meant. Pure. */

import type { Vec3 } from "../interface";
import { cross, direction, dot, length, scale, subtract } from "../vec";
import type { Projection } from "../view/projection";
import { nearest, nearOnSegment } from "./picking";

/** A triangle near the pointer. */
export interface Candidate {
  readonly corners: readonly [Vec3, Vec3, Vec3];
  /** Of length 1; zero where the triangle has no area. */
  readonly normal: Vec3;
}

/** A place near the pointer: CSS pixels from it, mm in front of the eye. */
interface Found {
  readonly at: Vec3;
  readonly off: number;
  readonly depth: number;
}

/** Two triangles that are flatter than this (1°) have no edge between them that a person could see. */
const FLAT = Math.cos(Math.PI / 180);

/** A side of triangles, from end to end. */
type Side = readonly [Vec3, Vec3];

/** Sides of triangles that are seen as such: not those between two that are flat. */
function sidesOf(triangles: readonly Candidate[]): Side[] {
  const sides = new Map<string, { ends: Side; normals: Vec3[] }>();
  for (const { corners, normal } of triangles) {
    corners.forEach((corner, i) => {
      const next = corners[(i + 1) % 3] ?? corner;
      const [a, b] = [corner.join(), next.join()];
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      const side = sides.get(key);
      if (side) side.normals.push(normal);
      else sides.set(key, { ends: [corner, next], normals: [normal] });
    });
  }
  const isFlat = ([first, second, ...more]: readonly Vec3[]): boolean =>
    first !== undefined && second !== undefined && more.length === 0 && Math.abs(dot(first, second)) > FLAT;
  return [...sides.values()].flatMap(({ ends, normals }) => (isFlat(normals) ? [] : [ends]));
}

/** Sides that differ less in their directions go on straight: sine of 0.06°, which a surface read in single precision keeps to. */
const STRAIGHT = 1e-3;

/** No straight border of a surface is cut into more pieces. */
const MOST_PIECES = 2000;

/**
 * A side with all that goes on straight from its ends: a border of a flat face may be cut into pieces by the triangles on it.
 * `around`: the triangles at a corner.
 */
export function wholeSide(side: Side, around: (corner: Vec3) => readonly Candidate[]): Side {
  const way = direction(subtract(side[1], side[0]));
  if (!way) return side;
  const farthest = (from: Vec3, ahead: Vec3): Vec3 => {
    let end = from;
    for (let pieces = 0; pieces < MOST_PIECES; pieces += 1) {
      const next = sidesOf(around(end)).flatMap(([a, b]) => (isAt(a, end) ? [b] : isAt(b, end) ? [a] : []));
      const on = next.find((place) => {
        const off = direction(subtract(place, end));
        return off !== null && dot(off, ahead) > 0 && length(cross(off, ahead)) < STRAIGHT;
      });
      if (!on) break;
      end = on;
    }
    return end;
  };
  return [farthest(side[0], scale(way, -1)), farthest(side[1], way)];
}

const isAt = (one: Vec3, other: Vec3): boolean => one.join() === other.join();

/** Within `reach` CSS pixels of the pointer, by distance on the screen. Diagonals of flat faces are no edges. */
export function nearestTargets(
  triangles: readonly Candidate[],
  projection: Projection,
  x: number,
  y: number,
  reach: number,
): { vertex: Vec3 | null; edge: Vec3 | null; side: Side | null } {
  const vertices: Found[] = [];
  const edges: (Found & { readonly side: Side })[] = [];
  for (const { corners } of triangles) {
    for (const corner of corners) {
      const seen = projection.seen(corner);
      const off = Math.hypot(seen.x - x, seen.y - y);
      if (off <= reach) vertices.push({ at: corner, off, depth: seen.depth });
    }
  }
  for (const side of sidesOf(triangles)) {
    const near = nearOnSegment(projection, side[0], side[1], x, y);
    if (near && near.off <= reach) edges.push({ ...near, side });
  }
  // A side that is seen edge-on has its far corner where its near one is: that one is behind the surface.
  const edge = nearest(edges);
  return { vertex: nearest(vertices)?.at ?? null, edge: edge?.at ?? null, side: edge?.side ?? null };
}
