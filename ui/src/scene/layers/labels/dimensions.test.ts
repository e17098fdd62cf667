import { expect, it } from "vitest";
import { designOf, drawn, INCH, MM } from "../../testing";
import { dimensionLabels, NO_DIMENSIONS } from "./dimensions";

/** A right angle of 30 and 40 mm, then straight on, then back on itself. */
const design = drawn(
  designOf(
    [
      [30, 0, 0],
      [0, 0, 0],
      [0, 40, 0],
      [0, 80, 0],
      [0, 80, 0],
    ],
    [
      [0, 1],
      [1, 2],
      [2, 3],
      [3, 4],
    ],
  ),
);
const texts = (asked: Partial<typeof NO_DIMENSIONS>, lengths = MM) =>
  dimensionLabels(design, { ...NO_DIMENSIONS, ...asked }, lengths).map(({ text }) => text);

it("writes what is asked for, in the unit that is shown", () => {
  expect(texts({})).toEqual([]);
  expect(texts({ edges: [0, 9], corners: [{ vertex: 1, ends: [0, 2] }], stays: 2 })).toEqual([
    "30.0 mm",
    "90.0°",
    "stays",
  ]);
  expect(texts({ edges: [0] }, INCH)).toEqual(["1.181 in"]);
});

it("writes all lengths and angles, each once, those of the selection first", () => {
  expect(texts({ all: true, edges: [1], corners: [{ vertex: 1, ends: [0, 2] }] })).toEqual([
    "40.0 mm",
    "90.0°",
    "30.0 mm",
    "40.0 mm",
    "0.0 mm",
    "180.0°",
  ]);
});

it("writes an angle between its edges, and follows what is dragged", () => {
  const [label] = dimensionLabels(design, { ...NO_DIMENSIONS, corners: [{ vertex: 1, ends: [0, 2] }] }, MM);
  expect(label?.towards).toEqual([1, 1, 0]);
  design.move([{ vertex: 0, at: [30, 30, 0] }]);
  expect(texts({ edges: [0], corners: [{ vertex: 1, ends: [0, 2] }] })).toEqual(["42.4 mm", "45.0°"]);
  design.move([]);
});
