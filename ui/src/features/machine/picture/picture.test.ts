import { describe, expect, it } from "vitest";
import type { Shape } from "../../../generated/responses";
import { axesOf, pictureOf, project } from "./picture";

const shape = (given: Partial<Shape>): Shape => ({
  name: "body",
  part: "frame",
  solid: { box: { size_mm: [10, 20, 30] } },
  at_mm: [0, 0, 0],
  axis: [0, 0, 1],
  measured: false,
  source: "here",
  ...given,
});

/** Twice the area, above 0 where the corners go against the clock on a page whose y goes up. */
const area = (points: readonly (readonly [number, number])[]): number =>
  points.reduce((all, [x, y], k) => {
    const [nx, ny] = points[(k + 1) % points.length] ?? [x, y];
    return all + (x * -ny - nx * -y);
  }, 0);

describe("project", () => {
  it("shows height upwards, unchanged in direction", () => {
    const [x, y] = project([0, 0, 100]);
    expect(x).toBeCloseTo(0);
    expect(y).toBeLessThan(0);
  });

  it("keeps handedness: seen from outside, x to y to z of a corner that looks at the eye goes against the clock", () => {
    // The eye is at +x, -y, +z: its axes are x, -y and z. Their order x, z, -y is right-handed as x, y, z is.
    expect(area([project([1, 0, 0]), project([0, 0, 1]), project([0, -1, 0])])).toBeGreaterThan(0);
  });
});

describe("axesOf", () => {
  it.each([[[0, 0, 1]], [[1, 0, 0]], [[0, -2, 0]], [[0, 0, -1]], [[1, 2, -3]]] as const)(
    "gives right-handed axes for %j",
    (axis) => {
      const [x, y, z] = axesOf(axis);
      const size = Math.hypot(...axis);
      z.forEach((part, k) => expect(part).toBeCloseTo((axis[k] ?? 0) / size));
      const cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
      cross.forEach((part, k) => expect(part).toBeCloseTo(z[k] ?? 0));
      expect(Math.hypot(...x)).toBeCloseTo(1);
    },
  );
});

describe("pictureOf", () => {
  it("shows the three faces of a box that look at the eye, with their areas foreshortened", () => {
    const picture = pictureOf([shape({})]);
    expect(picture?.faces).toHaveLength(3);
    // Cauchy: the shadow of a box is the sum of its faces, each by the cosine to the eye (0.62, -0.68, 0.46)/1.0291.
    const size = Math.hypot(0.62, 0.68, 0.46);
    const shadow = (20 * 30 * 0.62 + 10 * 30 * 0.68 + 10 * 20 * 0.46) / size;
    const shown = picture?.faces.reduce((all, face) => all + Math.abs(area(face.points)) / 2, 0);
    expect(shown).toBeCloseTo(shadow, 6);
  });

  it("draws what is nearer to the eye later", () => {
    const far = shape({ name: "far", part: "head", at_mm: [-100, 100, 0] });
    const near = shape({ name: "near", part: "peg", at_mm: [100, -100, 0] });
    const parts = pictureOf([near, far])?.faces.map(({ part }) => part);
    expect(parts).toEqual(["head", "head", "head", "peg", "peg", "peg"]);
  });

  it("draws a plate below a body first although it is much larger", () => {
    const plate = shape({ solid: { box: { size_mm: [460, 200, 12] } }, at_mm: [-190, 0, -81] });
    const body = shape({ part: "head", solid: { box: { size_mm: [60, 60, 60] } }, at_mm: [-380, 60, -45] });
    const faces = pictureOf([body, plate])?.faces ?? [];
    const top = project([-380, 60, -75]);
    // The part of the plate under the body, which the body hides, comes before all of the body.
    const under = faces.findIndex(({ part, points }) => part === "frame" && inside(points, top));
    expect(under).toBeGreaterThanOrEqual(0);
    expect(under).toBeLessThan(faces.findIndex(({ part }) => part === "head"));
  });

  it("shows the rim and one end of a cylinder, in a box around all of it", () => {
    const picture = pictureOf([shape({ solid: { cylinder: { radius_mm: 5, length_mm: 40 } }, axis: [1, 0, 0] })]);
    const ends = picture?.faces.filter(({ points }) => points.length > 4);
    expect(ends).toHaveLength(1);
    const [, , width, height] = picture?.box ?? [0, 0, 0, 0];
    expect(width).toBeGreaterThan(10);
    expect(height).toBeGreaterThan(10);
  });

  it("has nothing to show of a machine without bodies", () => {
    expect(pictureOf([])).toBeNull();
  });
});

function inside(points: readonly (readonly [number, number])[], [px, py]: readonly [number, number]): boolean {
  let within = false;
  points.forEach(([ax, ay], k) => {
    const [bx, by] = points[(k + 1) % points.length] ?? [ax, ay];
    if (ay > py !== by > py && px < ax + ((py - ay) / (by - ay)) * (bx - ax)) within = !within;
  });
  return within;
}
