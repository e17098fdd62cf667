import { describe, expect, it } from "vitest";
import { smallerParts } from "./parts";

const edges = (...ends: [number, number][]) => ({ edges: new Map(ends.map(([a, b], id) => [id, { id, a, b }])) });

describe("the smaller parts", () => {
  it("are all but the one with the most edges, each vertex once", () => {
    // A triangle with a tail, a chain whose halves are joined last, and a single edge.
    const { vertices, edges: found } = smallerParts(
      edges([1, 2], [10, 11], [2, 3], [12, 13], [3, 1], [3, 4], [20, 21], [11, 12]),
    );
    expect(vertices.toSorted((a, b) => a - b)).toEqual([10, 11, 12, 13, 20, 21]);
    expect(found.toSorted((a, b) => a - b)).toEqual([1, 3, 6, 7]);
  });

  it("leave the first of those that have as many edges", () => {
    expect(smallerParts(edges([5, 6], [1, 2]))).toEqual({ vertices: [1, 2], edges: [1] });
  });

  it("are none of one part, and of none", () => {
    expect(smallerParts(edges([1, 2], [2, 3]))).toEqual({ vertices: [], edges: [] });
    expect(smallerParts(edges())).toEqual({ vertices: [], edges: [] });
  });
});
