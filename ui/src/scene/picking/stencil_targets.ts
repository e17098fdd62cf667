/** Which corner and which edge of triangles near the pointer are meant. Pure. */

import type { Vec3 } from "../interface";
import { dot } from "../vec";
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

/** Within `reach` CSS pixels of the pointer, by distance on the screen. Diagonals of flat faces are no edges. */
export function nearestTargets(
  triangles: readonly Candidate[],
  projection: Projection,
  x: number,
  y: number,
  reach: number,
): { vertex: Vec3 | null; edge: Vec3 | null; side: readonly [Vec3, Vec3] | null } {
  const vertices: Found[] = [];
  const edges: (Found & { readonly side: readonly [Vec3, Vec3] })[] = [];
  const sides = new Map<string, { ends: [Vec3, Vec3]; normals: Vec3[] }>();
  for (const { corners, normal } of triangles) {
    corners.forEach((corner, i) => {
      const seen = projection.seen(corner);
      const off = Math.hypot(seen.x - x, seen.y - y);
      if (off <= reach) vertices.push({ at: corner, off, depth: seen.depth });
      const next = corners[(i + 1) % 3] ?? corner;
      const [a, b] = [corner.join(), next.join()];
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      const side = sides.get(key);
      if (side) side.normals.push(normal);
      else sides.set(key, { ends: [corner, next], normals: [normal] });
    });
  }
  for (const { ends, normals } of sides.values()) {
    const [first, second] = normals;
    if (normals.length === 2 && first && second && Math.abs(dot(first, second)) > FLAT) continue;
    const near = nearOnSegment(projection, ends[0], ends[1], x, y);
    if (near && near.off <= reach) edges.push({ ...near, side: ends });
  }
  // A side that is seen edge-on has its far corner where its near one is: that one is behind the surface.
  const edge = nearest(edges);
  return { vertex: nearest(vertices)?.at ?? null, edge: edge?.at ?? null, side: edge?.side ?? null };
}
