// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { SceneEdge, SceneVertex } from "../../scene/interface";
import { useDesign } from "../design/design";
import { designState } from "../testing";
import { changePart, colourOf, coloursOf, partsOf, shownDesign } from "./parts";

/** Two triangles, one of them drawn after an edge of the other, and a vertex without edges. */
const ENDS = [
  [0, 1],
  [4, 5],
  [1, 2],
  [5, 6],
  [2, 0],
  [6, 4],
] as const;
const edges = new Map(ENDS.map(([a, b], id) => [id, { id, a, b } satisfies SceneEdge] as const));
const vertices = new Map(
  [0, 1, 2, 3, 4, 5, 6].map((id) => [id, { id, at: [id, 0, 0], support: false } satisfies SceneVertex] as const),
);
const design = (parts: ReturnType<typeof designState>["parts"] = []) => ({
  vertices,
  edges,
  state: designState({ parts }),
});

beforeEach(() => void platform.ask.mockReset());

describe("parts", () => {
  it("are the edges that hang together, in the order in which they were drawn", () => {
    const parts = partsOf(design());
    expect(parts.map(({ id }) => id)).toEqual([0, 1]);
    expect(parts.map((part) => part.edges.toSorted())).toEqual([
      [0, 2, 4],
      [1, 3, 5],
    ]);
    expect(parts[1]?.vertices.toSorted()).toEqual([4, 5, 6]);
  });

  it("have the look of whichever of their edges has one; the first counts where they were joined", () => {
    const looks = [
      { edge: 5, look: { name: "hook" } },
      { edge: 3, look: { name: "eye" } },
    ];
    expect(partsOf(design(looks)).map(({ look }) => look.name)).toEqual(["", "eye"]);
  });

  it("are left out of what is shown where they are hidden, and nothing else is", () => {
    const shown = shownDesign(design([{ edge: 4, look: { hidden: true } }]));
    expect([...shown.edges.keys()]).toEqual([1, 3, 5]);
    expect([...shown.vertices.keys()]).toEqual([3, 4, 5, 6]);
    const all = design([{ edge: 4, look: { name: "frame" } }]);
    expect(shownDesign(all)).toBe(all);
  });

  it("colour their edges", () => {
    const colours = coloursOf(design([{ edge: 2, look: { colour: "#ff0080" } }]));
    expect([...colours.keys()].toSorted()).toEqual([0, 2, 4]);
    expect(colours.get(0)).toEqual([1, 0, 128 / 255]);
    expect(colourOf({ colour: "#ff0080" })).toBe(colours.get(4));
  });

  it("keep the rest of their look when a part of it is changed", async () => {
    platform.ask.mockResolvedValue({ change: null, notes: [] });
    const named = design([{ edge: 2, look: { name: "frame", colour: "#112233" } }]);
    useDesign.setState(named);
    const [part] = partsOf(named);
    if (part) await changePart(part, { hidden: true });
    const request = { edit: "part-look", edge: 0, look: { name: "frame", colour: "#112233", hidden: true } };
    expect(platform.ask).toHaveBeenCalledWith("edit", { request });
  });
});
