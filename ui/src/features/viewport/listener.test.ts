// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import { drawOf, endOf, strokeOf } from "./listener";

describe("a stroke", () => {
  it("becomes one change", () => {
    expect(drawOf({ from: 3, through: [[1, 2, 3]], to: null })).toEqual({ edit: "draw", from: 3, through_mm: [[1, 2, 3]], to: null });
  });

  it("goes on from its last new vertex, and is over at one that was there", () => {
    expect(endOf({ from: null, through: [[0, 0, 0], [1, 0, 0]], to: null }, [58, 57])).toBe(58);
    expect(endOf({ from: 3, through: [[1, 0, 0]], to: 4 }, [58])).toBeNull();
    expect(endOf({ from: 3, through: [[1, 0, 0]], to: null }, [])).toBeNull();
  });

  it("from an edge splits it first, as one thing to undo, and begins at the new vertex", () => {
    const { request, ends } = strokeOf({ from: null, through: [[1, 0, 0]], to: null, split: { edge: 7, at: 0.25, end: "from" } }, 60);
    expect(request).toEqual({ edit: "several", label: "draw", edits: [{ edit: "split", edge: 7, at: 0.25 }, drawOf({ from: 60, through: [[1, 0, 0]], to: null })] });
    expect(endOf(ends, [60, 61])).toBe(61);
  });

  it("to an edge ends at the new vertex", () => {
    const { request, ends } = strokeOf({ from: 3, through: [], to: null, split: { edge: 7, at: 0.5, end: "to" } }, 60);
    expect(request).toMatchObject({ edit: "several", edits: [{ edit: "split" }, { edit: "draw", from: 3, to: 60 }] });
    expect(endOf(ends, [60])).toBeNull();
  });

  it("that only splits an edge goes on from there", () => {
    const { request, ends } = strokeOf({ from: null, through: [], to: null, split: { edge: 7, at: 0.5, end: "from" } }, 60);
    expect(request).toEqual({ edit: "split", edge: 7, at: 0.5 });
    expect(endOf(ends, [60])).toBe(60);
  });
});
