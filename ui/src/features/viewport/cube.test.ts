import { expect, it } from "vitest";
import type { ViewAxes } from "../../scene/interface";
import type { Side } from "../../state/window/view";
import { facesOf, SIDE_NAMES, sideOf, zoneName } from "./cube";

/** Directions of the picture where the eye is at an angle about z, and above the horizon: z is up. */
const seen = (yaw: number, pitch: number): ViewAxes => {
  const [sy, cy, sp, cp] = [Math.sin(yaw), Math.cos(yaw), Math.sin(pitch), Math.cos(pitch)];
  return { right: [-sy, cy, 0], up: [-sp * cy, -sp * sy, cp], back: [cp * cy, cp * sy, sp] };
};

const QUARTER = Math.PI / 2;
/** The front is -y. */
const STRAIGHT: Readonly<Record<Side, ViewAxes>> = {
  front: seen(-QUARTER, 0),
  back: seen(QUARTER, 0),
  right: seen(0, 0),
  left: seen(Math.PI, 0),
  top: seen(-QUARTER, QUARTER),
  bottom: seen(-QUARTER, -QUARTER),
};

const numbers = (points: string) => points.split(" ").map((corner) => corner.split(",").map(Number));

it("shows a side alone, upright and to its scale, when it is looked at straight on", () => {
  for (const side of SIDE_NAMES) {
    const [face, ...others] = facesOf(STRAIGHT[side], 30);
    expect(others).toEqual([]);
    expect(face?.side).toBe(side);
    // Letters run to the right and stand upright, in the middle.
    expect(face?.transform).toBe("matrix(1 0 0 1 0 0)");
    expect(numbers(face?.points ?? "")).toEqual([
      [-30, 30],
      [30, 30],
      [30, -30],
      [-30, -30],
    ]);
  }
});

it("shows three faces from a corner, as regular as the projection of a cube along its diagonal is", () => {
  const faces = facesOf(seen(-Math.PI / 4, Math.asin(1 / Math.sqrt(3))), 30);
  expect(faces.map(({ side }) => side)).toEqual(["front", "right", "top"]);
  // The outer corners lie on a circle of the cube's edge times the root of 2/3; the nearest is in the middle.
  for (const { points, square } of faces) {
    const radii = numbers(points).map(([x = 0, y = 0]) => Math.hypot(x, y));
    expect(square).toBeCloseTo(1 / Math.sqrt(3), 9);
    expect(radii.toSorted((a, b) => a - b).map((radius) => Math.round(radius))).toEqual(
      [0, 1, 1, 1].map((out) => Math.round(out * 60 * Math.sqrt(2 / 3))),
    );
  }
});

it("has 26 zones: each face with the edges and corners around it, and a name for each", () => {
  const zones = new Map<string, number>();
  for (const side of SIDE_NAMES)
    for (const { zone } of facesOf(STRAIGHT[side], 30)[0]?.patches ?? [])
      zones.set(zoneName(zone), (zones.get(zoneName(zone)) ?? 0) + 1);
  expect(zones.size).toBe(26);
  // A face is seen once, an edge on two faces, a corner on three.
  for (const [name, count] of zones) expect(name.split(", ")).toHaveLength(count);
  expect(zoneName([1, -1, 1])).toBe("Top, front, right");
  expect([sideOf([0, 0, -1]), sideOf([0, 1, 0]), sideOf([1, 0, 1])]).toEqual(["bottom", "back", null]);
});
