import { describe, expect, it } from "vitest";
import type { SceneDesign } from "../../scene/interface";
import { connected, edgesOf, inverted, stillThere, surroundings, verticesOf } from "./selecting";

/** Two parts: 0-1-2 and 3-4, and 5 alone; edge ids 10, 11, 12. */
const design: SceneDesign = {
  vertices: new Map([0, 1, 2, 3, 4, 5].map((id) => [id, { id, at: [id, 0, 0] as const, support: false }])),
  edges: new Map([
    [10, { id: 10, a: 0, b: 1 }],
    [11, { id: 11, a: 1, b: 2 }],
    [12, { id: 12, a: 3, b: 4 }],
  ]),
};
const of = (vertices: number[], edges: number[] = []) => ({ vertices: new Set(vertices), edges: new Set(edges) });

describe("selection", () => {
  it("moves the ends of selected edges too, in the order of selecting", () => {
    expect(verticesOf(of([2], [10]), design)).toEqual([2, 0, 1]);
    expect(verticesOf(of([], [99]), design)).toEqual([]);
  });

  it("takes edges with it whose ends are both selected", () => {
    expect(edgesOf(of([0, 1]), design)).toEqual([10]);
    expect(edgesOf(of([1], [12]), design)).toEqual([12]);
  });

  it("selects what hangs together, and nothing else", () => {
    expect(connected(of([2]), design)).toEqual(of([2, 1, 0], [10, 11]));
    expect(connected(of([5]), design)).toEqual(of([5]));
  });

  it("is seen with its neighbours, but not with theirs", () => {
    expect([...surroundings(of([0]), design)].sort()).toEqual([0, 1]);
    expect([...surroundings(of([], [12]), design)].sort()).toEqual([3, 4]);
    expect([...surroundings(of([5]), design)]).toEqual([5]);
  });

  it("inverts", () => {
    expect(inverted(of([0, 1, 2], [10]), design)).toEqual(of([3, 4, 5], [11, 12]));
  });

  it("forgets what is gone, and stays the same object where nothing is", () => {
    const all = of([0, 5], [12]);
    expect(stillThere(all, design)).toBe(all);
    expect(stillThere(of([0, 77], [10, 99]), design)).toEqual(of([0], [10]));
  });
});
