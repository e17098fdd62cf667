import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { SceneDesign, Vec3 } from "../../scene/interface";
import { useDesign } from "./design";
import { canFollow, cornerOf, edgeOf, setAngle, setLength, useExact } from "./exact";
import { select } from "./selection";

/** A triangle 1, 2, 3 with a tail from 3 to 4; edges 11, 12, 13 and 14. */
const places: readonly Vec3[] = [
  [0, 0, 0],
  [40, 0, 0],
  [40, 30, 0],
  [40, 60, 0],
];
const design: SceneDesign = {
  vertices: new Map(places.map((at, k) => [k + 1, { id: k + 1, at, support: false }])),
  edges: new Map(
    [
      { id: 11, a: 1, b: 2 },
      { id: 12, a: 2, b: 3 },
      { id: 13, a: 3, b: 1 },
      { id: 14, a: 3, b: 4 },
    ].map((edge) => [edge.id, edge]),
  ),
};
const selection = (vertices: number[], edges: number[] = []) => ({
  vertices: new Set(vertices),
  edges: new Set(edges),
});

describe("what has a length or an angle to type", () => {
  it("is one edge, or its two ends", () => {
    const expected = { id: 11, ends: [1, 2], mm: 40 };
    expect(edgeOf(selection([], [11]), design)).toEqual(expected);
    expect(edgeOf(selection([1, 2]), design)).toEqual(expected);
    expect(edgeOf(selection([], [11, 12]), design)).toBe("Select one edge");
    expect(edgeOf(selection([4], [11]), design)).toBe("Select one edge");
    expect(edgeOf(selection([1, 4]), design)).toBe("Select one edge");
  });

  it("is a vertex with two edges, or two edges that meet", () => {
    // 3-4-5: the angle at the vertex with 40 and 50 beside it.
    expect(cornerOf(selection([1]), design)).toMatchObject({ vertex: 1, edges: [11, 13], ends: [2, 3] });
    const angle = cornerOf(selection([1]), design);
    expect(typeof angle === "string" ? null : angle.deg).toBeCloseTo((Math.atan2(30, 40) * 180) / Math.PI, 10);
    expect(cornerOf(selection([], [12, 14]), design)).toMatchObject({ vertex: 3, deg: 180 });
    expect(cornerOf(selection([3]), design)).toBe("Select two of its 3 edges");
    expect(cornerOf(selection([4]), design)).toBe("The vertex has no corner");
    expect(cornerOf(selection([], [11, 14]), design)).toBe("Select a vertex or two edges");
    expect(cornerOf(selection([]), design)).toBe("Select a vertex or two edges");
  });

  it("has a rest that follows, but in a closed loop", () => {
    const what = (found: ReturnType<typeof edgeOf> | ReturnType<typeof cornerOf>) => {
      if (typeof found === "string") throw new Error(found);
      return canFollow(found, design);
    };
    expect(what(edgeOf(selection([], [11]), design))).toBe(false);
    expect(what(edgeOf(selection([], [14]), design))).toBe(true);
    expect(what(cornerOf(selection([1]), design))).toBe(false);
    expect(what(cornerOf(selection([], [12, 14]), design))).toBe(true);
  });
});

describe("what is asked for", () => {
  beforeEach(() => {
    platform.ask.mockReset().mockResolvedValue({ change: null });
    useDesign.setState(design);
    useExact.setState({ end: 0, side: 0, follows: true });
  });
  const asked = () => platform.ask.mock.calls.filter(([name]) => name === "edit").map(([, { request }]) => request);

  it("names what stays, and lets the rest follow where it can", async () => {
    select([], [14]);
    await setLength(25);
    useExact.setState({ end: 1, follows: false });
    await setLength(25);
    useExact.setState({ follows: true });
    select([], [11]);
    await setLength(25);
    const length = { edit: "length", length_mm: 25 };
    expect(asked()).toEqual([
      { ...length, edge: 14, stays: 3, rest: "follows" },
      { ...length, edge: 14, stays: 4, rest: "stays" },
      { ...length, edge: 11, stays: 2, rest: "stays" },
    ]);
  });

  it("turns edges in line in the plane that is drawn on", async () => {
    useExact.setState({ side: 1 });
    select([], [12, 14]);
    await setAngle(120);
    expect(asked()[0]).toEqual({
      edit: "angle",
      vertex: 3,
      between: [14, 12],
      angle_deg: 120,
      normal: [0, 0, 1],
      rest: "follows",
    });
  });
});
