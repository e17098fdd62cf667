/**
 * Where the wire is in the frame of the machine while it is made.
 *
 * Frame of the machine: mm, right-handed, the origin is the bend point, +x the way the wire leaves, z the bend axis of the head at
 * its reference. The end that was made first leads, so the direction of travel along the path is -x there. A positive bend turns
 * the wire that is out about the head's z, right-handed; a rotation by φ turns the head about the direction of travel, which is by
 * -φ about +x, and leaves the wire as it is. The two together are the turtle of the program, seen from its own frame.
 *
 * Poses follow the points of the path; the program tells where its corners are, which way its first bend goes, and how to fold
 * back, where the path alone leaves it open. So a wire as made is shown as made although the program asked for something else.
 */

import { Quaternion, Vector3 } from "three";
import type { PlayedStep, Vec3 } from "./interface";
import { cross, direction, distance, dot, scale, subtract } from "./vec";

/** The straight part that a step feeds, and its bend at the end. */
export interface Run {
  /** Points of the path at which it begins and ends. */
  readonly first: number;
  readonly last: number;
  /** mm. */
  readonly length: number;
  /** Along the path, of length 1. */
  readonly way: Vec3;
  /** From the frame of the design to the frame of the machine while it is fed. */
  readonly turn: Quaternion;
  /** The bend of the wire that is out: about this axis of the machine, by this angle in radians. */
  readonly bendAxis: Vec3;
  readonly bendAngle: number;
  /** Radians by which the head has turned about +x before and after this step's rotation. */
  readonly headBefore: number;
  readonly headAfter: number;
}

const RADIANS = Math.PI / 180;
const OUT = new Vector3(1, 0, 0);
const IN = new Vector3(-1, 0, 0);

/** The head's z, when it has turned by `angle` about +x. */
const headZ = (angle: number): Vec3 => [0, -Math.sin(angle), Math.cos(angle)];

/** Indices at which the steps' straight parts begin and end: the sharpest corners of the path, one fewer than there are steps. */
export function corners(path: readonly Vec3[], steps: number): number[] {
  const last = path.length - 1;
  const sharp: { at: number; turn: number }[] = [];
  for (let at = 1; at < last; at += 1) {
    const [a, b] = [directionFrom(path, at - 1), directionFrom(path, at)];
    sharp.push({ at, turn: a && b ? Math.atan2(Math.hypot(...cross(a, b)), dot(a, b)) : 0 });
  }
  const taken = sharp.toSorted((a, b) => b.turn - a.turn || a.at - b.at).slice(0, Math.max(steps - 1, 0));
  return [0, ...taken.map((corner) => corner.at).toSorted((a, b) => a - b), ...(last > 0 ? [last] : [])];
}

/** One run a step; fewer where the path has fewer corners than the program has bends. `at` from `corners`. */
export function runs(path: readonly Vec3[], steps: readonly PlayedStep[], at: readonly number[] = corners(path, steps.length)): Run[] {
  const ways: Vec3[] = [];
  for (let k = 0; k + 1 < at.length; k += 1) {
    const [from, to] = [path[at[k] ?? 0], path[at[k + 1] ?? 0]];
    // A part without length has no direction of its own: the wire goes on as it did.
    ways.push((from && to && direction(subtract(to, from))) ?? ways.at(-1) ?? [1, 0, 0]);
  }
  const made: Run[] = [];
  let turn = firstTurn(ways, steps);
  let head = 0;
  ways.forEach((way, k) => {
    const after = head - (steps[k]?.rotate ?? 0) * RADIANS;
    const next = ways[k + 1];
    const bend = next ? bendBetween(turn, next, after, steps[k]?.bend ?? 0) : { axis: headZ(after), angle: 0 };
    const [first, last] = [at[k] ?? 0, at[k + 1] ?? 0];
    const length = distance(path[first] ?? way, path[last] ?? way);
    made.push({ first, last, length, way, turn, bendAxis: bend.axis, bendAngle: bend.angle, headBefore: head, headAfter: after });
    turn = bendTurn(bend.axis, bend.angle).multiply(turn);
    head = after;
  });
  return made;
}

/** Turn by an angle in radians about an axis. */
export function bendTurn(axis: Vec3, angle: number): Quaternion {
  return new Quaternion().setFromAxisAngle(new Vector3(...axis), angle);
}

/** The turn of the design with which the first bend lies in the plane that the program gives it. */
function firstTurn(ways: readonly Vec3[], steps: readonly PlayedStep[]): Quaternion {
  const [first] = ways;
  if (!first) return new Quaternion();
  let head = 0;
  for (const [k, step] of steps.entries()) {
    head -= step.rotate * RADIANS;
    const [way, next] = [ways[k], ways[k + 1]];
    if (!way || !next) break;
    const binormal = direction(cross(way, next));
    if (!binormal || Math.hypot(...cross(way, next)) < 1e-6) continue;
    // The turtle's binormal is the head's -z: the wire that is out turns against the turtle.
    const seen = scale(headZ(head), step.bend < 0 ? 1 : -1);
    return basis(way, binormal)
      .invert()
      .premultiply(basis([-1, 0, 0], seen));
  }
  return new Quaternion().setFromUnitVectors(new Vector3(...first), IN);
}

/** Takes x to `x` and z to `z`, which are at right angles. */
function basis(x: Vec3, z: Vec3): Quaternion {
  const along = new Quaternion().setFromUnitVectors(OUT, new Vector3(...x));
  const side = new Vector3(0, 0, 1).applyQuaternion(along);
  const goal = new Vector3(...z);
  const angle = Math.atan2(new Vector3().crossVectors(side, goal).dot(new Vector3(...x)), side.dot(goal));
  return along.premultiply(bendTurn(x, angle));
}

/** What takes the next direction of travel to -x the shortest way; a fold back goes the way that the program says. */
function bendBetween(turn: Quaternion, next: Vec3, head: number, bend: number): { axis: Vec3; angle: number } {
  const coming = new Vector3(...next).applyQuaternion(turn);
  const across = new Vector3().crossVectors(coming, IN);
  const angle = Math.atan2(across.length(), coming.dot(IN));
  if (across.length() > 1e-6) {
    const axis = across.normalize();
    return { axis: [axis.x, axis.y, axis.z], angle };
  }
  return { axis: headZ(head), angle: angle > 1 ? Math.sign(bend || 1) * angle : 0 };
}

function directionFrom(path: readonly Vec3[], at: number): Vec3 | null {
  const [from, to] = [path[at], path[at + 1]];
  return from && to ? direction(subtract(to, from)) : null;
}
