import { describe, expect, it } from "vitest";
import type { Vec3 } from "../interface";
import { projectionOf } from "../testing";
import { type Candidate, nearestTargets, wholeSide } from "./stencil_targets";

/** A corner where the front of a box meets its side, which is seen edge-on from the front. */
const FRONT: Candidate = {
  corners: [
    [0, 0, 0],
    [10, 0, 0],
    [0, 0, 10],
  ],
  normal: [0, -1, 0],
};
const SIDE: Candidate = {
  corners: [
    [0, 0, 0],
    [0, 10, 0],
    [0, 10, 10],
  ],
  normal: [-1, 0, 0],
};

describe("nearestTargets", () => {
  it.each([
    ["front first", [FRONT, SIDE]],
    ["side first", [SIDE, FRONT]],
  ])("takes the corner in front of one that lies behind it: %s", (_, triangles) => {
    const projection = projectionOf("front");
    const at: Vec3 = [0, 0, 0];
    const { x, y } = projection.seen(at);
    expect(nearestTargets(triangles, projection, x + 2, y + 1, 12).vertex).toEqual(at);
  });

  it("takes the nearer of two corners, and none out of reach", () => {
    const projection = projectionOf("front");
    const { x, y } = projection.seen([10, 0, 0]);
    expect(nearestTargets([FRONT], projection, x, y, 12).vertex).toEqual([10, 0, 0]);
    expect(nearestTargets([FRONT], projection, x + 40, y, 12)).toEqual({ vertex: null, edge: null, side: null });
  });
});

describe("wholeSide", () => {
  /** A face in the plane z = 0 as a fan from a place inside of it, so that its border is cut at every corner that is given. */
  const fan = (border: readonly Vec3[]): Candidate[] =>
    border.map((corner, i) => ({
      corners: [[3, 2, 0], corner, border[(i + 1) % border.length] ?? corner],
      normal: [0, 0, 1],
    }));
  const around = (all: readonly Candidate[]) => (corner: Vec3) =>
    all.filter(({ corners }) => corners.some((other) => other.join() === corner.join()));
  const RECTANGLE: readonly Vec3[] = [
    [0, 0, 0],
    [1, 0, 0],
    [4, 0, 0],
    [10, 0, 0],
    [10, 5, 0],
    [6, 5, 0],
    [0, 5, 0],
  ];

  it.each([
    [0, 0, 10],
    [1, 0, 10],
    [2, 0, 10],
    [4, 10, 0],
  ])("is the whole border of a flat face that is cut into pieces: from piece %i", (piece, from, to) => {
    const side = [RECTANGLE[piece], RECTANGLE[piece + 1]] as [Vec3, Vec3];
    const whole = wholeSide(side, around(fan(RECTANGLE)));
    expect([whole[0][0], whole[1][0]]).toEqual([from, to]);
  });

  it("ends at a corner, however blunt it is", () => {
    // A ring of 360 corners: each is 1° off straight.
    const ring = Array.from({ length: 360 }, (_, i): Vec3 => {
      const angle = (i * Math.PI) / 180;
      return [100 * Math.cos(angle), 100 * Math.sin(angle), 0];
    });
    const side = [ring[8], ring[9]] as [Vec3, Vec3];
    expect(wholeSide(side, around(fan(ring)))).toEqual(side);
  });

  it("does not run along a diagonal of a flat face", () => {
    const [a, b, c, d]: readonly Vec3[] = [
      [0, 0, 0],
      [4, 0, 0],
      [4, 4, 0],
      [8, 0, 0],
    ] as const;
    if (!a || !b || !c || !d) throw new Error("four corners");
    const normal: Vec3 = [0, 0, 1];
    // The border from a to b goes on to d only as a diagonal between two triangles.
    const flat: Candidate[] = [
      { corners: [a, b, c], normal },
      { corners: [b, d, c], normal },
      { corners: [b, [6, -4, 0], d], normal },
    ];
    expect(wholeSide([a, b], around(flat))).toEqual([a, b]);
  });
});
