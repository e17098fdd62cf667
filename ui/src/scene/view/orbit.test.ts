import { describe, expect, it } from "vitest";
import type { Vec3 } from "../interface";
import { cross, direction, dot } from "../vec";
import { Camera } from "./camera";
import {
  axes,
  FIRST,
  facingPlane,
  framedAspect,
  framing,
  looking,
  type Orbit,
  pixelAtTarget,
  shifted,
  squareness,
  turned,
  viewOf,
  zoomed,
} from "./orbit";

const seen = (orbit: Orbit, at: Vec3): { x: number; y: number } => {
  const camera = new Camera();
  [camera.width, camera.height] = [800, 600];
  camera.orbit = orbit;
  return camera.update().seen(at);
};

it("has right-handed axes from every side, level with the horizon", () => {
  for (const view of ["front", "back", "left", "right", "top", "bottom", "perspective"] as const) {
    const { right, up, back } = axes(looking(FIRST, view));
    expect(dot(cross(right, up), back)).toBeCloseTo(1);
    expect(right[2]).toBeCloseTo(0);
  }
});

it("turns no farther than straight down, and leaves the axis view", () => {
  const top = turned(looking(FIRST, "front"), 0, 5000);
  expect(top.pitch).toBeCloseTo(Math.PI / 2);
  expect(top.orthographic).toBe(false);
});

it("shifts so that what was taken hold of stays under the pointer", () => {
  const before = seen(FIRST, [0, 0, 0]);
  const after = seen(shifted(FIRST, 40, -25, 600), [0, 0, 0]);
  expect(after.x - before.x).toBeCloseTo(40);
  expect(after.y - before.y).toBeCloseTo(-25);
});

it("zooms to the pointer: what is under it stays", () => {
  for (const orbit of [FIRST, looking(FIRST, "top")]) {
    const { right, up } = axes(orbit);
    const pixel = pixelAtTarget(orbit, 600);
    const at: Vec3 = [
      (right[0] * 150 + up[0] * 90) * pixel,
      (right[1] * 150 + up[1] * 90) * pixel,
      (right[2] * 150 + up[2] * 90) * pixel,
    ];
    const after = seen(zoomed(orbit, 0.5, 150, 90, 600), at);
    expect(after.x).toBeCloseTo(550);
    expect(after.y).toBeCloseTo(210);
  }
});

it("framing leaves room for the tools, but not all of a narrow view", () => {
  expect(framedAspect(1112, 500)).toBe(2);
  expect(framedAspect(200, 100)).toBe(1);
  expect(framedAspect(0, 0)).toBe(0);
});

describe("framing", () => {
  const places: Vec3[] = [
    [100, 0, 0],
    [400, 50, 0],
    [100, 80, 300],
    [250, -60, 120],
  ];
  it.each(["front", "top", "perspective"] as const)("shows everything, and fills the view, from %s", (view) => {
    const orbit = framing(looking(FIRST, view), places, 800 / 600);
    const at = places.map((place) => seen(orbit, place));
    const off = at.map(({ x, y }) => Math.max(Math.abs(x - 400) / 400, Math.abs(y - 300) / 300));
    expect(Math.max(...off)).toBeLessThan(1);
    expect(Math.max(...off)).toBeGreaterThan(0.7);
  });

  it("does not go closer to a single vertex than a hand's breadth", () => {
    expect(pixelAtTarget(framing(FIRST, [[5, 5, 5]], 1), 600) * 600).toBeGreaterThanOrEqual(20);
  });

  it("leaves the view of nothing as it is", () => {
    expect(framing(FIRST, [], 1)).toBe(FIRST);
  });
});

describe("a plane that is drawn on", () => {
  const PLANES = [
    ["xy", [0, 0, 1], "top", "bottom"],
    ["xz", [0, -1, 0], "front", "back"],
    ["yz", [1, 0, 0], "right", "left"],
  ] as const;

  it.each(PLANES)("%s is faced from the side that the eye is on, else from its own", (_, normal, own, other) => {
    for (const view of ["front", "back", "right", "left", "top", "bottom"] as const) {
      const faced = facingPlane(looking(FIRST, view), normal);
      expect(viewOf(faced)).toBe(view === other ? other : own);
      expect(squareness(faced, normal)).toBeCloseTo(1);
    }
  });

  it("is faced wherever it lies, with the horizon level", () => {
    const normal = direction([1, 2, 3]) ?? [0, 0, 1];
    const faced = facingPlane(FIRST, normal);
    expect(squareness(faced, normal)).toBeCloseTo(1);
    expect(axes(faced).right[2]).toBe(0);
    expect(viewOf(faced)).toBeNull();
  });
});
