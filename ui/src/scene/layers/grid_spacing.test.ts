import { expect, it } from "vitest";
import { INCH, MM } from "../testing";
import { gridSpacing, gridText } from "./grid_spacing";

it.each([
  // A cell of 10 mm is 9 pixels at 10/9 mm a pixel: below that it is fine enough.
  [1.12, 100],
  [1.1, 10],
  [0.2, 10],
  [0.1, 1],
  [20, 1000],
])("at %f mm a pixel has lines every %i mm", (pixel, mm) => {
  expect(gridSpacing(pixel, MM).mm).toBeCloseTo(mm);
});

it("fades fine lines in as they come apart", () => {
  expect(gridSpacing(1.1, MM).fine).toBeLessThan(0.02);
  expect(gridSpacing(0.12, MM).fine).toBeGreaterThan(0.95);
});

it("counts in inches for users who do", () => {
  const spacing = gridSpacing(0.3, INCH);
  expect(spacing.mm).toBeCloseTo(25.4);
  expect(gridText(spacing, INCH)).toBe("Grid 1 in");
});

it("has its lines where the grid is that is drawn on: 7 mm, and every tenth of them from far away", () => {
  expect(gridSpacing(0.1, MM, 5).mm).toBe(5);
  expect(gridSpacing(0.1, MM, 7).mm).toBe(7);
  expect(gridSpacing(1, MM, 7).mm).toBe(70);
  expect(gridSpacing(0.3, INCH, 6.35).mm).toBe(6.35);
});

it("says where clicks go while they snap to it, also where only every tenth of its lines can be seen", () => {
  const spacing = gridSpacing(0.5, MM, 5);
  expect([spacing.mm, spacing.fine]).toEqual([5, expect.closeTo(0.046, 2)]);
  expect(gridText(spacing, MM)).toBe("Grid 50 mm");
  expect(gridText({ ...spacing, clicks: 5 }, MM)).toBe("Grid 5 mm\nLines 50 mm");
  expect(gridText({ ...gridSpacing(0.1, MM, 5), clicks: 5 }, MM)).toBe("Grid 5 mm");
  expect(gridText({ ...gridSpacing(0.1, INCH, 6.35), clicks: 6.35 }, INCH)).toBe("Grid 0.25 in");
});
