import { expect, it } from "vitest";
import { projectionOf } from "../testing";
import { ARC, handleAt, turnAt } from "./gizmo_parts";

const front = projectionOf("front");

it("takes hold of an arrow along its length", () => {
  expect(handleAt(front, [0, 0, 0], 450, 303)).toEqual({ kind: "axis", axis: "x" });
  expect(handleAt(front, [0, 0, 0], 398, 250)).toEqual({ kind: "axis", axis: "z" });
  expect(handleAt(front, [0, 0, 0], 480, 300)).toBeNull();
});

it("leaves the middle to the vertex that is there", () => {
  expect(handleAt(front, [0, 0, 0], 402, 299)).toBeNull();
});

it("takes hold of the square between two arrows, and not of those seen edge on", () => {
  expect(handleAt(front, [0, 0, 0], 429, 271)).toEqual({ kind: "plane", normal: "y" });
});

it("is as large on the screen from far away", () => {
  const far = projectionOf("perspective");
  const { x, y } = far.seen([0, 0, 60]);
  expect(handleAt(far, [0, 0, 0], x, y)).toEqual({ kind: "axis", axis: "z" });
  const deep = far.axes.back.map((part) => part * -3000) as unknown as [number, number, number];
  const pixel = far.pixel(deep);
  const seen = far.seen([deep[0], deep[1], deep[2] + 60 * pixel]);
  expect(handleAt(far, deep, seen.x, seen.y)).toEqual({ kind: "axis", axis: "z" });
});

it("takes hold of the arc about the axis that is looked along, and of none that is seen edge on", () => {
  const diagonal = ARC.radius * Math.SQRT1_2;
  expect(turnAt(front, [0, 0, 0], 400 + diagonal, 300 - diagonal)).toEqual({ kind: "turn", axis: "y" });
  expect(handleAt(front, [0, 0, 0], 400 + diagonal, 300 - diagonal)).toBeNull();
  // The other quarters have none, nor the middle of the picture, nor the arrows, where the arcs about x and z are lines.
  for (const [x, y] of [
    [400 - diagonal, 300 - diagonal],
    [400, 300],
    [400 + ARC.radius, 300],
  ] as const)
    expect(turnAt(front, [0, 0, 0], x, y)).toBeNull();
});
