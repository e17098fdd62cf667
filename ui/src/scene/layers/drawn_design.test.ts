import { expect, it } from "vitest";
import type { SceneDesign } from "../interface";
import { designOf, drawn } from "../testing";
import { DrawnDesign } from "./drawn_design";

const design = designOf(
  [
    [0, 0, 0],
    [1, 0, 0],
    [2, 0, 0],
    [9, 9, 9],
  ],
  [
    [0, 1],
    [1, 2],
  ],
);
const withVertex = (id: number, x: number): SceneDesign => ({
  ...design,
  vertices: new Map(
    [...design.vertices].map(([key, vertex]) => [key, key === id ? { ...vertex, at: [x, 0, 0] as const } : vertex]),
  ),
});

it("draws only the vertex that has moved", () => {
  expect(drawn(design).update(withVertex(1, 5))).toEqual({ rows: [1] });
  expect(drawn(design).update(design)).toEqual({ rows: [] });
});

it("draws everything when an edge comes or goes", () => {
  expect(drawn(design).update({ ...design, edges: new Map() })).toEqual({ rows: "all" });
});

it("shows a drop until the design has it, and the old place when it does not", () => {
  const shown = drawn(design);
  shown.move([{ vertex: 1, at: [7, 7, 7] }]);
  expect(shown.place(1)).toEqual([7, 7, 7]);
  expect(shown.update(design)).toEqual({ rows: [1] });
  expect(shown.place(1)).toEqual([1, 0, 0]);
});

it("puts vertices back that the next move leaves out", () => {
  const shown = drawn(design);
  shown.move([
    { vertex: 0, at: [7, 7, 7] },
    { vertex: 1, at: [8, 8, 8] },
  ]);
  shown.move([{ vertex: 1, at: [9, 8, 8] }]);
  expect(shown.place(0)).toEqual([0, 0, 0]);
  expect(shown.place(1)).toEqual([9, 8, 8]);
});

it("moves the ends of a selected edge", () => {
  expect([...drawn(design).moving({ vertices: new Set([3, 77]), edges: new Set([1]) })]).toEqual([3, 1, 2]);
});

it("finds what hangs together", () => {
  const { vertices, edges } = drawn(design).connected(2);
  expect([...vertices].toSorted()).toEqual([0, 1, 2]);
  expect([...edges].toSorted()).toEqual([0, 1]);
});

it("survives an edge whose vertex is missing", () => {
  const shown = new DrawnDesign();
  shown.update(designOf([[0, 0, 0]], [[0, 5]]));
  expect(shown.edges).toEqual([]);
});
