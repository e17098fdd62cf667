import { describe, expect, it } from "vitest";
import type { HeadReport } from "../../../generated/responses";
import { drawingOf } from "./drawing";

// The published head, with the wire bent to a right angle: docs/physics.md.
const HEAD: HeadReport = {
  wire_mm: 3,
  pin_radius_mm: 1.5,
  peg: {
    radius_mm: 3.175,
    orbit_radius_mm: 20.4,
    orbit_offset_mm: 12,
    at_mm: [7.675, Math.sqrt(20.4 ** 2 - (7.675 - 12) ** 2)],
    axis_deg: 102.24,
  },
};

describe("drawingOf", () => {
  it("has every dimension as long as it is, in one scale", () => {
    const drawing = drawingOf(HEAD, 320, 300);
    for (const { name, from, to, mm } of drawing.dimensions)
      expect(Math.hypot(to[0] - from[0], to[1] - from[1]) / drawing.scale, name).toBeCloseTo(mm, 3);
    expect(drawing.dimensions.map(({ name }) => name)).toEqual(["pin", "R", "s", "peg"]);
  });

  it("lets the peg touch the outside of the bent leg", () => {
    const { peg, pin, scale } = drawingOf(HEAD, 320, 300);
    // From the pin to the peg: the pin's radius, the wire, the peg's radius.
    expect(((peg?.at[0] ?? 0) - pin.at[0]) / scale).toBeCloseTo(1.5 + 3 + 3.175, 9);
  });

  it("keeps all within the picture, for small pegs and large ones", () => {
    for (const factor of [0.2, 1, 3]) {
      const peg = { ...HEAD.peg, radius_mm: 3.175 * factor } as NonNullable<HeadReport["peg"]>;
      const { orbit, peg: drawn, dimensions } = drawingOf({ ...HEAD, peg }, 320, 300);
      for (const circle of [drawn, orbit]) {
        expect((circle?.at[0] ?? 0) - (circle?.radius ?? 0)).toBeGreaterThan(0);
        expect((circle?.at[0] ?? 0) + (circle?.radius ?? 0)).toBeLessThan(320);
      }
      expect(Math.max(...dimensions.map(({ text }) => text[1]))).toBeLessThan(300);
    }
  });

  it("draws a machine whose axis is the bend without a peg", () => {
    const drawing = drawingOf({ wire_mm: 2, pin_radius_mm: 4 }, 320, 300);
    expect(drawing.peg).toBeNull();
    expect(drawing.dimensions).toHaveLength(1);
  });
});
