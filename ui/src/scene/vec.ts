/** Arithmetic of places and directions. Lengths in mm unless a function says otherwise. */

import type { Axis, DrawingPlane, Vec3 } from "./interface";

export const ORIGIN: Vec3 = [0, 0, 0];

export const AXES: Readonly<Record<Axis, Vec3>> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, by: number): Vec3 => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Vec3): number => Math.hypot(a[0], a[1], a[2]);
export const distance = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

/** Right-handed. */
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** `a + b * by`. */
export const along = (a: Vec3, b: Vec3, by: number): Vec3 => [a[0] + b[0] * by, a[1] + b[1] * by, a[2] + b[2] * by];

/** Of length 1; null where there is no direction. */
export function direction(a: Vec3): Vec3 | null {
  const size = length(a);
  return size > 1e-12 ? scale(a, 1 / size) : null;
}

/** The direction of length 1 in a plane, so many degrees from its first axis towards its second; quarter turns come out whole. */
export function inPlane({ u, v }: DrawingPlane, deg: number): Vec3 {
  const [cos, sin] = [90 - deg, deg].map((turned) => {
    const quarters = turned / 90;
    if (Number.isInteger(quarters)) return [0, 1, 0, -1][((quarters % 4) + 4) % 4] ?? 0;
    return Math.sin((turned * Math.PI) / 180);
  }) as [number, number];
  return add(scale(u, cos), scale(v, sin));
}

/** Degrees from the first axis of a plane towards its second, from 0 to less than 360. */
export function planeAngle({ u, v }: DrawingPlane, way: Vec3): number {
  const deg = (Math.atan2(dot(way, v), dot(way, u)) * 180) / Math.PI;
  // What is written as 360.0 is 0.
  return deg < -0.05 ? deg + 360 : Math.max(deg, 0);
}

export interface Ray {
  readonly origin: Vec3;
  /** Of length 1. */
  readonly direction: Vec3;
}

/** Where a ray's line meets a plane; null where it runs along it (within about 1°). */
export function onPlane(ray: Ray, origin: Vec3, normal: Vec3): Vec3 | null {
  const slope = dot(ray.direction, normal);
  if (Math.abs(slope) < 0.02) return null;
  return along(ray.origin, ray.direction, dot(subtract(origin, ray.origin), normal) / slope);
}

/** How far along `axis` (of length 1) from `origin` a ray's line passes nearest, mm; null where they are parallel (within about 1°). */
export function alongAxis(ray: Ray, origin: Vec3, axis: Vec3): number | null {
  const shared = dot(ray.direction, axis);
  const apart = 1 - shared * shared;
  if (apart < 4e-4) return null;
  const offset = subtract(ray.origin, origin);
  return (dot(offset, axis) - dot(offset, ray.direction) * shared) / apart;
}

/** The middle of places; the origin where there are none. */
export function middle(places: readonly Vec3[]): Vec3 {
  if (places.length === 0) return ORIGIN;
  return scale(places.reduce(add, ORIGIN), 1 / places.length);
}

/** A ball around places: the middle of their box, and the farthest of them. */
export function ballAround(places: Iterable<Vec3>): { centre: Vec3; radius: number } | null {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  const kept: Vec3[] = [];
  for (const place of places) {
    kept.push(place);
    for (let i = 0; i < 3; i += 1) {
      least[i] = Math.min(least[i] ?? 0, place[i] ?? 0);
      most[i] = Math.max(most[i] ?? 0, place[i] ?? 0);
    }
  }
  if (kept.length === 0) return null;
  const centre = scale(add(least as unknown as Vec3, most as unknown as Vec3), 0.5);
  return { centre, radius: kept.reduce((most, place) => Math.max(most, distance(place, centre)), 0) };
}
