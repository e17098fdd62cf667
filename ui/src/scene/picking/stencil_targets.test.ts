import { describe, expect, it } from "vitest";
import type { Vec3 } from "../interface";
import { projectionOf } from "../testing";
import { type Candidate, nearestTargets } from "./stencil_targets";

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
