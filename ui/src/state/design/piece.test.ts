import { describe, expect, it } from "vitest";
import type { SceneDesign } from "../../scene/interface";
import { fromText, moved, pieceOf, toText } from "./piece";

const design: SceneDesign = {
  vertices: new Map([3, 5, 9].map((id) => [id, { id, at: [id, 0, 1] as const, support: id === 5 }])),
  edges: new Map([
    [1, { id: 1, a: 9, b: 3 }],
    [2, { id: 2, a: 3, b: 5 }],
  ]),
};
const of = (vertices: number[], edges: number[] = []) => ({ vertices: new Set(vertices), edges: new Set(edges) });

describe("copying", () => {
  it("takes what is selected, with the edges between", () => {
    const piece = pieceOf(of([3, 9]), design);
    expect(piece?.vertices).toEqual([
      { at_mm: [3, 0, 1], support: false },
      { at_mm: [9, 0, 1], support: false },
    ]);
    expect(piece?.edges).toEqual([[1, 0]]);
    expect(pieceOf(of([]), design)).toBeNull();
  });

  it("takes joints with it", () => {
    const joint = { kind: "zip-tie", mass_g: 0.3 } as const;
    const jointed = { ...design, vertices: new Map([[3, { id: 3, at: [3, 0, 1] as const, support: true, joint }]]) };
    const piece = pieceOf(of([3]), jointed);
    if (!piece) throw new Error("nothing was copied");
    expect(piece.vertices).toEqual([{ at_mm: [3, 0, 1], support: true, joint }]);
    expect(fromText(toText(piece))).toEqual(piece);
    const other = toText(piece).replace("zip-tie", "rivet");
    expect(fromText(other)).toMatch(/damaged/);
  });

  it("comes back from the clipboard as it was", () => {
    const piece = pieceOf(of([], [1, 2]), design);
    if (!piece) throw new Error("nothing was copied");
    expect(fromText(toText(piece))).toEqual(piece);
    expect(moved(piece, [1, 2, 3]).vertices[0]?.at_mm).toEqual([10, 2, 4]);
  });

  it.each([
    ["hello", /no part of a wireframe/],
    ["", /no part of a wireframe/],
    ["[1]", /no part of a wireframe/],
    ["null", /no part of a wireframe/],
    ['{"format":"wirebend-piece","version":2,"vertices":[],"edges":[]}', /another version/],
    ['{"format":"wirebend-piece","version":1,"vertices":[{"at_mm":[0,0,null]}],"edges":[]}', /damaged/],
    ['{"format":"wirebend-piece","version":1,"vertices":[{"at_mm":[0,0,0]}],"edges":[[0,1]]}', /damaged/],
    ['{"format":"wirebend-piece","version":1,"vertices":[],"edges":[]}', /damaged/],
  ])("refuses %s", (text, why) => expect(fromText(text)).toMatch(why));
});
