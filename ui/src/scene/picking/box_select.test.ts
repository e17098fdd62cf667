import { expect, it } from "vitest";
import type { Selection } from "../interface";
import { designOf, drawn, projectionOf } from "../testing";
import { combine, inBox } from "./box_select";

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
const ids = ({ vertices, edges }: Selection): number[][] => [[...vertices], [...edges]];

it("takes what lies in a box drawn to the right", () => {
  // Vertices 0 and 1 and the edge between them; the edge 3-4 only crosses the box.
  expect(ids(inBox(design, front, { x0: 390, y0: 220, x1: 510, y1: 310 }))).toEqual([[0, 1], [0]]);
});

it("takes what a box drawn to the left touches, also an edge with both ends outside", () => {
  expect(ids(inBox(design, front, { x0: 510, y0: 310, x1: 390, y1: 220 }))).toEqual([
    [0, 1],
    [0, 1, 2],
  ]);
});

it("does not take an edge whose line only passes the box", () => {
  expect(ids(inBox(design, front, { x0: 395, y0: 320, x1: 390, y1: 310 }))).toEqual([[], []]);
});

it("adds with one key and toggles with the other", () => {
  const before = { vertices: new Set([1, 2]), edges: new Set([5]) };
  const found = { vertices: new Set([2, 3]), edges: new Set([5, 6]) };
  expect(ids(combine(before, found, "add"))).toEqual([
    [1, 2, 3],
    [5, 6],
  ]);
  expect(ids(combine(before, found, "toggle"))).toEqual([[1, 3], [6]]);
  expect(ids(combine(before, found, "replace"))).toEqual([
    [2, 3],
    [5, 6],
  ]);
});
