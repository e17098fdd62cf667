import { describe, expect, it } from "vitest";
import { current, GAP, scaleFor, seen, tops } from "./layout";
import type { PageSize } from "./pdf";

const A4: PageSize = [210, 297];
const LYING: PageSize = [297, 210];

describe("pages under each other", () => {
  it("fit into the room as a whole, or as wide as it, and lying pages are as large as upright ones", () => {
    const room = [900, 700] as const;
    const whole = scaleFor("page", [A4, LYING], room);
    expect(whole * 297).toBeLessThanOrEqual(Math.max(700, 900) - 2 * GAP);
    expect(whole).toBeCloseTo((700 - 2 * GAP) / 297);
    expect(scaleFor("width", [A4], room) * 210).toBeCloseTo(900 - 2 * GAP);
    // 96 pixels an inch.
    expect(scaleFor("actual", [A4], room) * 25.4).toBeCloseTo(96);
    expect(scaleFor("page", [A4], [0, 0])).toBeGreaterThan(0);
  });

  it("begin below each other with a gap, and the last entry is how high all are", () => {
    expect(tops([A4, LYING], 2)).toEqual([GAP, GAP + 594 + GAP, GAP + 594 + GAP + 420 + GAP]);
    expect(tops([], 2)).toEqual([GAP]);
  });

  it("are drawn where they are in sight, with one more on both sides", () => {
    const all = tops(Array(9).fill(A4), 1);
    expect(seen(all, 0, 300)).toEqual([0, 2]);
    expect(seen(all, (all[4] ?? 0) + 20, 300)).toEqual([3, 7]);
    expect(seen(all, 1e6, 300)).toEqual([7, 9]);
    expect(seen(tops([], 1), 0, 300)).toEqual([0, 1].map(() => 0));
  });

  it("are counted by the one in the middle", () => {
    const all = tops(Array(3).fill(A4), 1);
    expect([0, 200, 400, 1e6].map((scrolled) => current(all, scrolled, 300))).toEqual([0, 1, 1, 2]);
  });
});
