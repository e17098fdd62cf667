import { describe, expect, it } from "vitest";
import type { Vec3 } from "../interface";
import { dot, scale, subtract } from "../vec";
import { lifted } from "./lift";
import type { Candidate } from "./stencil_targets";

/** The three faces at the corner of a box, which lies on the far side of all of them. */
const [X, Y, Z]: Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;
const face = (normal: Vec3, a: Vec3, b: Vec3): Candidate => ({ corners: [[0, 0, 0], a, b], normal });
const FACES = [
  face(X as Vec3, [0, -10, 0], [0, 0, -10]),
  face(Y as Vec3, [0, 0, -10], [-10, 0, 0]),
  face(Z as Vec3, [-10, 0, 0], [0, -10, 0]),
];
const round = (at: Vec3) => at.map((mm) => Math.round(mm * 1e5) / 1e5);

describe("a place that is taken off a surface", () => {
  it("is off each of the faces that meet there", () => {
    expect(round(lifted([0, 0, 0], FACES, [0, 0, 1], false, 1.5))).toEqual([1.5, 1.5, 1.5]);
    expect(round(lifted([0, 0, -4], FACES, [1, 0, 0], false, 1.5))).toEqual([1.5, 1.5, -4]);
    expect(round(lifted([-2, -2, 0], FACES, [0, 0, 1], false, 1.5))).toEqual([-2, -2, 1.5]);
  });

  it("is inside a surface that is seen from inside", () => {
    expect(round(lifted([0, 0, 0], FACES, [0, 0, -1], true, 1.5))).toEqual([-1.5, -1.5, -1.5]);
  });

  it("is at least as far from every facet of a cone, and no nearer to its axis", () => {
    const at = (k: number): Vec3 => [10 * Math.cos((k * Math.PI) / 6), 10 * Math.sin((k * Math.PI) / 6), -10];
    const cone = Array.from({ length: 12 }, (_, k): Candidate => {
      const [a, b] = [at(k), at(k + 1)];
      const n: Vec3 = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
      return { corners: [[0, 0, 0], a, b], normal: scale(n, -1 / Math.hypot(...n)) };
    });
    const up = cone.map(({ corners, normal }) => ({ corners, normal: normal[2] < 0 ? scale(normal, -1) : normal }));
    const tip = lifted([0, 0, 0], up, up[0]?.normal ?? [0, 0, 1], false, 2);
    for (const { normal } of up) expect(dot(normal, tip)).toBeGreaterThanOrEqual(2 - 1e-9);
    expect(round(subtract(tip, [0, 0, tip[2]]))).toEqual([0, 0, 0]);
    // From its axis a facet is turned by an angle whose tangent is cos(15°).
    expect(tip[2]).toBeCloseTo(2 * Math.hypot(1, 1 / Math.cos(Math.PI / 12)), 5);
  });

  it("goes straight off the seen face where the others look against it", () => {
    const against = [...FACES.slice(2), face([0, 0, -1], [-10, 0, 0], [0, -10, 0])];
    expect(round(lifted([0, 0, 0], against, [0, 0, 1], false, 1.5))).toEqual([0, 0, 1.5]);
  });
});
