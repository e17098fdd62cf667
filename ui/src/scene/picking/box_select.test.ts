import { expect, it } from "vitest";
import type { Selection } from "../interface";
import { designOf, drawn, projectionOf } from "../testing";
import { combine, inBox } from "./box_select";
import type { Line } from "./snap";

const front = projectionOf("front");
const design = drawn(
  designOf(
    [
      [0, 0, 0],
      [100, 0, 0],
      [100, 0, 100],
      [-200, 0, 50],
      [300, 0, 50],
    ],
    [
      [0, 1],
      [1, 2],
      [3, 4],
    ],
  ),
);
/** Construction lines: inside of the box that is drawn to the right, and crossing it. */
const lines: readonly Line[] = [
  [
    [0, 0, 10],
    [90, 0, 70],
  ],
  [
    [50, 0, -90],
    [50, 0, 60],
  ],
];
const view = { design, projection: front, lines };
const ids = ({ vertices, edges }: Selection): number[][] => [[...vertices], [...edges]];

it("takes what lies in a box drawn to the right", () => {
  // Vertices 0 and 1 and the edge between them; the edge 3-4 only crosses the box.
  expect(ids(inBox(view, { x0: 390, y0: 220, x1: 510, y1: 310 }))).toEqual([[0, 1], [0]]);
});

it("takes what a box drawn to the left touches, also an edge with both ends outside", () => {
  expect(ids(inBox(view, { x0: 510, y0: 310, x1: 390, y1: 220 }))).toEqual([
    [0, 1],
    [0, 1, 2],
  ]);
});

it("takes construction lines as it takes edges", () => {
  expect([...inBox(view, { x0: 390, y0: 220, x1: 510, y1: 310 }).lines]).toEqual([0]);
  expect([...inBox(view, { x0: 510, y0: 310, x1: 390, y1: 220 }).lines]).toEqual([0, 1]);
});

it("does not take an edge whose line only passes the box", () => {
  expect(ids(inBox(view, { x0: 395, y0: 320, x1: 390, y1: 310 }))).toEqual([[], []]);
});

it("adds with one key and toggles with the other", () => {
  const before = { vertices: new Set([1, 2]), edges: new Set([5]), lines: new Set([1]) };
  const found = { vertices: new Set([2, 3]), edges: new Set([5, 6]), lines: new Set([0]) };
  expect(ids(combine(before, found, "add"))).toEqual([
    [1, 2, 3],
    [5, 6],
  ]);
  expect(ids(combine(before, found, "toggle"))).toEqual([[1, 3], [6]]);
  expect([...combine(before, found, "add").lines]).toEqual([1, 0]);
  expect(ids(combine(before, found, "replace"))).toEqual([
    [2, 3],
    [5, 6],
  ]);
});
