/** Places off a surface instead of on it: where a wire has its middle that lies on it. Pure; mm. */

import { Triangle, Vector3 } from "three";
import type { Vec3 } from "../interface";
import { along, cross, dot, length, ORIGIN, scale } from "../vec";
import type { Candidate } from "./stencil_targets";

/** So near to a triangle a place is on it, as a share of how far it is from the origin. */
const ON = 1e-6;
/** Normals that differ by less are those of one face: cosine of 0.8°. */
const SAME = 0.9999;
/** A spike would take its place to infinity: no farther than so many times the distance. */
const FARTHEST = 3;

/**
 * A place on a surface taken `by` off each face that it is on. `side`: the normal of a face there, towards the side that is seen; the
 * triangles are all wound as that one is where `flipped` is false, else all the other way.
 */
export function lifted(at: Vec3, triangles: readonly Candidate[], side: Vec3, flipped: boolean, by: number): Vec3 {
  const normals: Vec3[] = [];
  for (const { corners, normal } of triangles) {
    if (length(normal) === 0 || !isOn(corners, at)) continue;
    const facing = flipped ? scale(normal, -1) : normal;
    if (!normals.some((known) => dot(known, facing) > SAME)) normals.push(facing);
  }
  const way = off(normals.length > 0 ? normals : [side]) ?? side;
  return along(at, way, by);
}

/** The shortest way that leads at least 1 off every face; null where faces that look against each other leave none. */
function off(normals: readonly Vec3[]): Vec3 | null {
  const [first] = normals;
  if (first && normals.length === 1) return first;
  const way = leastSquares(normals);
  const least = Math.min(...normals.map((normal) => dot(normal, way)));
  if (least < 0.2) return null;
  const longer = scale(way, 1 / least);
  return length(longer) > FARTHEST ? scale(longer, FARTHEST / length(longer)) : longer;
}

/** The shortest of the vectors whose products with all normals are nearest to 1. */
function leastSquares(normals: readonly Vec3[]): Vec3 {
  // Two faces leave a direction open: next to nothing on the diagonal keeps that at zero.
  const row = (i: 0 | 1 | 2): Vec3 => {
    const sums = normals.reduce((sum, normal) => along(sum, normal, normal[i]), ORIGIN);
    return [sums[0] + (i === 0 ? 1e-9 : 0), sums[1] + (i === 1 ? 1e-9 : 0), sums[2] + (i === 2 ? 1e-9 : 0)];
  };
  const [a, b, c] = [row(0), row(1), row(2)];
  const sum = normals.reduce((all, normal) => along(all, normal, 1), ORIGIN);
  const whole = dot(a, cross(b, c));
  // The matrix is its own transpose: its columns are its rows.
  return [dot(sum, cross(b, c)) / whole, dot(a, cross(sum, c)) / whole, dot(a, cross(b, sum)) / whole];
}

function isOn(corners: Candidate["corners"], at: Vec3): boolean {
  const [a, b, c] = corners.map((corner) => new Vector3(...corner));
  if (!a || !b || !c) return false;
  const place = new Vector3(...at);
  const near = new Triangle(a, b, c).closestPointToPoint(place, new Vector3());
  return near.distanceTo(place) <= ON * Math.max(1, length(at));
}
