import { expect, it } from "vitest";
import type { SceneDesign, Vec3 } from "../../scene/interface";
import { measured } from "./measure";

const places: readonly Vec3[] = [
  [0, 0, 0],
  [100, 0, 0],
  [50, 30, 40],
  [50, 80, 40],
  [130, 40, 0],
  [0, 20, 0],
  [100, 20, 0],
];
const ends = [
  [0, 1],
  [2, 3],
  [5, 6],
] as const;
const design: SceneDesign = {
  vertices: new Map(places.map((at, id) => [id, { id, at, support: false }])),
  edges: new Map(ends.map(([a, b], id) => [id, { id, a, b }])),
};
const between = (vertices: number[], edges: number[] = []) =>
  measured({ vertices: new Set(vertices), edges: new Set(edges) }, design);

it("measures between vertices, a vertex and an edge, and two edges", () => {
  expect(between([0, 1])).toEqual({ from: [0, 0, 0], to: [100, 0, 0], mm: 100, deg: null });
  // Across from the edge, and beside its end.
  expect(between([2], [0])).toMatchObject({ from: [50, 30, 40], to: [50, 0, 0], mm: 50, deg: null });
  expect(between([4], [0])).toMatchObject({ to: [100, 0, 0], mm: 50 });
  // At right angles, nearest at an end of one; and in parallel.
  expect(between([], [0, 1])).toMatchObject({ from: [50, 0, 0], to: [50, 30, 40], mm: 50 });
  expect(between([], [0, 1])?.deg).toBeCloseTo(90, 9);
  expect(between([], [0, 2])).toMatchObject({ mm: 20, deg: 0 });
});

it("measures nothing of one thing or of three", () => {
  expect([between([0]), between([], [0]), between([0, 1, 2]), between([0, 1], [0])]).toEqual([null, null, null, null]);
});
