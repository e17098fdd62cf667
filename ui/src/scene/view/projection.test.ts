import { expect, it } from "vitest";
import { nearOnSegment } from "../picking/picking";
import { projectionOf } from "../testing";

it("has x to the right and z up in front view, a pixel for a millimetre", () => {
  const seen = projectionOf("front").seen([30, 17, 100]);
  expect(seen.x).toBeCloseTo(430);
  expect(seen.y).toBeCloseTo(200);
});

it("has y to the right from the right, and y up from the top", () => {
  expect(projectionOf("right").seen([5, 30, 0]).x).toBeCloseTo(430);
  expect(projectionOf("top").seen([0, 30, 5]).y).toBeCloseTo(270);
  expect(projectionOf("top").seen([30, 0, 5]).x).toBeCloseTo(430);
});

it("sends a ray back through the place that it was asked for", () => {
  for (const view of ["front", "top", "perspective"] as const) {
    const projection = projectionOf(view);
    const { x, y } = projection.seen([12, -30, 44]);
    const { origin, direction } = projection.ray(x, y);
    const [dx, dy, dz] = [12 - origin[0], -30 - origin[1], 44 - origin[2]];
    const along = dx * direction[0] + dy * direction[1] + dz * direction[2];
    expect(Math.sqrt(Math.max(dx * dx + dy * dy + dz * dz - along * along, 0))).toBeLessThan(1e-2);
    expect(along).toBeGreaterThan(0);
  }
});

it("knows what a pixel covers: 1 mm at the target, half of that half way to the eye", () => {
  const projection = projectionOf("perspective");
  expect(projection.pixel([0, 0, 0])).toBeCloseTo(1);
  const { back } = projection.axes;
  const half = projection.depth([0, 0, 0]) / 2;
  expect(projection.pixel([back[0] * half, back[1] * half, back[2] * half])).toBeCloseTo(0.5);
  expect(projectionOf("front").pixel([5, 900, 5])).toBeCloseTo(1);
});

it("cuts off what is behind the eye", () => {
  const projection = projectionOf("perspective");
  const { back } = projection.axes;
  const far = 2 * projection.depth([0, 0, 0]);
  const behind = [back[0] * far, back[1] * far, back[2] * far] as const;
  const segment = projection.segment([0, 0, 0], behind);
  expect(segment?.from).toBe(0);
  expect(segment?.to).toBeCloseTo(0.5, 3);
  expect(projection.segment(behind, [behind[0] * 1.1, behind[1] * 1.1, behind[2] * 1.1])).toBeNull();
});

it("cuts nothing off without perspective: what is nearer than the eye is drawn, and can be meant", () => {
  const projection = projectionOf("front");
  const { back } = projection.axes;
  const far = 3 * projection.depth([0, 0, 0]);
  const behind = [40 + back[0] * far, back[1] * far, back[2] * far] as const;
  expect(projection.depth(behind)).toBeLessThan(0);
  expect(projection.sees(projection.seen(behind))).toBe(true);
  expect(projection.segment([0, 0, 0], behind)).toMatchObject({ from: 0, to: 1 });
  // Seen from the front, x is all that is left of it: 20 pixels to the right is its middle.
  const near = nearOnSegment(projection, [0, 0, 0], behind, 420, 300);
  expect(near?.along).toBeCloseTo(0.5);
  expect(near?.off).toBeCloseTo(0);
});
