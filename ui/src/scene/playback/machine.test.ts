import { describe, expect, it } from "vitest";
import { shared } from "../drawing/shading";
import { THEMES } from "../drawing/theme";
import type { MachineBody, Vec3 } from "../interface";
import { edgesOf, Machine } from "./machine";

const box = (at: Vec3, size: Vec3, part: MachineBody["part"] = "frame"): MachineBody => ({
  name: "box",
  part,
  shape: { kind: "box", size },
  at,
  axis: [0, 0, 1],
});
const DOWN: Vec3 = [0, 0, -1];

describe("bodyOn", () => {
  const machine = new Machine(shared());
  // The peg turns about an axis that is 12 mm beyond the bend point, and stands where its profile says all the same.
  machine.show(
    [box([0, 0, -50], [100, 100, 10]), box([0, 0, 0], [10, 10, 10]), box([30, 0, 0], [10, 10, 10], "peg")],
    12,
    5,
    3,
    THEMES.dark,
  );
  const above = (x: number, y: number) => machine.bodyOn({ origin: [x, y, 100], direction: DOWN });

  it("is the nearest body, of whichever part", () => {
    expect(above(0, 0)).toBe(1);
    expect(above(30, 4)).toBe(2);
    expect(above(-30, 30)).toBe(0);
  });

  it("is none beside all of them", () => {
    expect(above(80, 0)).toBeNull();
  });
});

describe("edgesOf", () => {
  it("has the twelve edges of a box where it lies", () => {
    const edges = edgesOf(box([1, 2, 3], [2, 4, 6]));
    expect(edges).toHaveLength(12);
    for (const [from, to] of edges) {
      const length = Math.hypot(from[0] - to[0], from[1] - to[1], from[2] - to[2]);
      expect([2, 4, 6].some((size) => Math.abs(size - length) < 1e-6)).toBe(true);
      expect([0, 2].some((x) => Math.abs(from[0] - x) < 1e-6)).toBe(true);
    }
  });

  it("has the two rims of a cylinder and no line along it", () => {
    const edges = edgesOf({ ...box([0, 0, 0], [1, 1, 1]), shape: { kind: "cylinder", radius: 5, length: 20 } });
    expect(edges.every(([from, to]) => Math.abs(from[2] - to[2]) < 1e-6)).toBe(true);
    expect(edges.length).toBeGreaterThan(20);
  });
});
