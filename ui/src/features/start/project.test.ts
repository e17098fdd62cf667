import { describe, expect, it } from "vitest";
import { project } from "./project";

describe("small pictures", () => {
  it("fill their frame and stay inside the margin", () => {
    const lines = project(
      [
        [
          [0, 0, 0],
          [100, 0, 0],
        ],
        [
          [0, 0, 0],
          [0, 0, 40],
        ],
      ],
      160,
      120,
      10,
    );
    const xs = lines.flatMap(({ from, to }) => [from[0], to[0]]);
    const ys = lines.flatMap(({ from, to }) => [from[1], to[1]]);
    expect(Math.min(...xs)).toBeCloseTo(10, 9);
    expect(Math.max(...xs)).toBeCloseTo(150, 9);
    expect(Math.min(...ys)).toBeGreaterThanOrEqual(10);
    expect(Math.max(...ys)).toBeLessThanOrEqual(110);
  });

  it("have up above: z grows towards the top", () => {
    const [line] = project(
      [
        [
          [0, 0, 0],
          [0, 0, 10],
        ],
      ],
      100,
      100,
    );
    expect(line?.to[1]).toBeLessThan(line?.from[1] ?? 0);
  });

  it("draw what is farther away first: +y is away from the front", () => {
    const [first, last] = project(
      [
        [
          [0, -50, 0],
          [10, -50, 0],
        ],
        [
          [0, 50, 0],
          [10, 50, 0],
        ],
      ],
      100,
      100,
    );
    expect(first?.near).toBeLessThan(last?.near ?? 0);
    // Seen from above, what is farther away is higher up.
    expect(first?.from[1]).toBeLessThan(last?.from[1] ?? 0);
  });

  it("of nothing and of a point do not fail", () => {
    expect(project([], 10, 10)).toEqual([]);
    expect(
      project(
        [
          [
            [1, 1, 1],
            [1, 1, 1],
          ],
        ],
        10,
        10,
      )[0]?.from,
    ).toEqual([5, 5]);
  });
});
