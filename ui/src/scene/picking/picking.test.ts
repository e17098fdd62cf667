import { expect, it } from "vitest";
import { designOf, drawn, projectionOf } from "../testing";
import { pick, pickEdge, pickVertex } from "./picking";

const front = projectionOf("front");
// Front view: x to the right of 400, z above 300; +y is away from the eye.
const design = drawn(
  designOf(
    [
      [0, 0, 0],
      [100, 0, 0],
      [0, 50, 1.5],
      [100, 50, 100],
    ],
    [
      [0, 1],
      [2, 3],
    ],
  ),
);

const view = {
  design,
  projection: front,
  lines: [
    [
      [0, 0, -10],
      [100, 0, -10],
    ],
  ] as const,
};

it("takes a vertex within reach, and nothing beyond it", () => {
  expect(pickVertex(design, front, 508, 300, 10)?.id).toBe(1);
  expect(pickVertex(design, front, 511, 300, 10)).toBeNull();
});

it("takes the one in front of two that a hand cannot tell apart, also from behind", () => {
  expect(pickVertex(design, front, 400, 299, 10)?.id).toBe(0);
  expect(pickVertex(design, projectionOf("back"), 400, 299, 10)?.id).toBe(2);
});

it("takes a vertex before an edge that runs through the same place", () => {
  expect(pick(view, 495, 301, false)?.kind).toBe("vertex");
  expect(pick(view, 470, 303, false)).toMatchObject({ kind: "edge", id: 0 });
  expect(pick(view, 470, 320, false)).toBeNull();
});

it("takes a construction line where no edge is as near", () => {
  // The edge is 300 pixels from above, the line 310.
  expect(pick(view, 450, 309, false)).toMatchObject({ kind: "line", id: 0, at: [50, 0, -10] });
  expect(pick(view, 450, 306, false)).toMatchObject({ kind: "line" });
  expect(pick(view, 450, 305, false)).toMatchObject({ kind: "edge", id: 0 });
  expect(pick(view, 450, 318, false)).toBeNull();
});

it("reaches farther for a finger", () => {
  expect(pick({ ...view, lines: [] }, 470, 320, true)).toMatchObject({ kind: "edge", id: 0 });
});

it("says where on the edge", () => {
  const picked = pickEdge(design, front, 430, 303, 7);
  expect(picked?.along).toBeCloseTo(0.3);
  expect(picked?.at[0]).toBeCloseTo(30);
});

it("says where on an edge that comes towards the eye: in space, not on the screen", () => {
  const perspective = projectionOf("perspective");
  const long = drawn(
    designOf(
      [
        [0, 0, 0],
        [300, -500, 100],
      ],
      [[0, 1]],
    ),
  );
  // A quarter of the way in space, wherever that is on the screen.
  const { x, y } = perspective.seen([75, -125, 25]);
  expect(pickEdge(long, perspective, x, y, 3)?.along).toBeCloseTo(0.25);
});

it("does not pick what is behind the eye", () => {
  const perspective = projectionOf("perspective");
  const { back } = perspective.axes;
  const far = perspective.depth([0, 0, 0]) * 2;
  const behind = drawn(designOf([[back[0] * far, back[1] * far, back[2] * far]], []));
  expect(pickVertex(behind, perspective, 400, 300, 10)).toBeNull();
});
