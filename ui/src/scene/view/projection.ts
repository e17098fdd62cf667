/** From places to the screen and back, as the camera sees them. CSS pixels from the upper left corner. */

import { Matrix4, type Matrix4Tuple, Vector4 } from "three";
import type { Vec3 } from "../interface";
import { direction, type Ray, subtract } from "../vec";

/** A place on the screen. */
export interface Seen {
  readonly x: number;
  readonly y: number;
  /** mm in front of the eye; see `Projection.sees` for what is on the screen. */
  readonly depth: number;
}

/** Part of a segment that is in front of the eye. */
export interface SeenSegment {
  readonly a: Seen;
  readonly b: Seen;
  /** Where the part begins and ends on the segment: 0 at its first end, 1 at its second. */
  readonly from: number;
  readonly to: number;
}

/** Nearer than this a segment is cut off, mm. */
const NEAR = 1e-3;

export class Projection {
  private readonly view: Readonly<Matrix4Tuple>;
  private readonly all: Readonly<Matrix4Tuple>;
  private readonly back: Matrix4;

  /** `view` goes from the world to the eye, `projection` from the eye to the clip cube. */
  constructor(
    view: Matrix4,
    projection: Matrix4,
    readonly width: number,
    readonly height: number,
  ) {
    const all = new Matrix4().multiplyMatrices(projection, view);
    this.view = [...view.elements];
    this.all = [...all.elements];
    this.back = all.clone().invert();
  }

  seen([x, y, z]: Vec3): Seen {
    const m = this.all;
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    const right = (m[0] * x + m[4] * y + m[8] * z + m[12]) / w;
    const up = (m[1] * x + m[5] * y + m[9] * z + m[13]) / w;
    return {
      x: (right + 1) * 0.5 * this.width,
      y: (1 - up) * 0.5 * this.height,
      depth: this.depth([x, y, z]),
    };
  }

  /** mm in front of the eye. */
  depth([x, y, z]: Vec3): number {
    const m = this.view;
    return -(m[2] * x + m[6] * y + m[10] * z + m[14]);
  }

  /** Whether a place is in front of the eye. Without perspective nothing is behind it: the view has no nearest plane there. */
  sees({ depth }: Pick<Seen, "depth">): boolean {
    return !this.perspective || depth > 0;
  }

  /** Null where all of it is behind the eye. */
  segment(a: Vec3, b: Vec3): SeenSegment | null {
    if (!this.perspective) return { a: this.seen(a), b: this.seen(b), from: 0, to: 1 };
    const [da, db] = [this.depth(a), this.depth(b)];
    if (da < NEAR && db < NEAR) return null;
    const cut = (NEAR - da) / (db - da);
    const from = da < NEAR ? cut : 0;
    const to = db < NEAR ? cut : 1;
    const at = (t: number): Vec3 => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
    return { a: this.seen(at(from)), b: this.seen(at(to)), from, to };
  }

  /** Where a fraction of a seen segment on the screen lies on the segment in space: 0 at its first end, 1 at its second. */
  onSegment(segment: SeenSegment, fraction: number): number {
    const [wa, wb] = this.perspective ? [1 / segment.a.depth, 1 / segment.b.depth] : [1, 1];
    const within = (fraction * wb) / ((1 - fraction) * wa + fraction * wb);
    return segment.from + (segment.to - segment.from) * within;
  }

  /** Through a place on the screen, away from the eye. */
  ray(x: number, y: number): Ray {
    const [px, py] = [(x / this.width) * 2 - 1, 1 - (y / this.height) * 2];
    const near = this.unseen(px, py, -1);
    return { origin: near, direction: direction(subtract(this.unseen(px, py, 1), near)) ?? [0, 0, -1] };
  }

  /** mm that a pixel covers at a place. */
  pixel(at: Vec3): number {
    // The row for y scales by half a viewport for 1 mm: at a depth of 1 mm in perspective, anywhere otherwise.
    const m = this.all;
    const scale = Math.hypot(m[1], m[5], m[9]);
    return (2 * (this.perspective ? Math.max(this.depth(at), NEAR) : 1)) / (scale * this.height);
  }

  /** The way to the eye at a place, of length 1. */
  towardsEye(at: Vec3): Vec3 {
    const m = this.view;
    const back: Vec3 = [m[2], m[6], m[10]];
    if (!this.perspective) return back;
    const eye: Vec3 = [
      -(m[0] * m[12] + m[1] * m[13] + m[2] * m[14]),
      -(m[4] * m[12] + m[5] * m[13] + m[6] * m[14]),
      -(m[8] * m[12] + m[9] * m[13] + m[10] * m[14]),
    ];
    return direction(subtract(eye, at)) ?? back;
  }

  /** Directions of the picture, of length 1: to the right, up, and out of it towards the eye. */
  get axes(): { right: Vec3; up: Vec3; back: Vec3 } {
    const m = this.view;
    return { right: [m[0], m[4], m[8]], up: [m[1], m[5], m[9]], back: [m[2], m[6], m[10]] };
  }

  get perspective(): boolean {
    const m = this.all;
    return Math.hypot(m[3], m[7], m[11]) > 1e-9;
  }

  private unseen(px: number, py: number, pz: number): Vec3 {
    const at = new Vector4(px, py, pz, 1).applyMatrix4(this.back);
    return [at.x / at.w, at.y / at.w, at.z / at.w];
  }
}
