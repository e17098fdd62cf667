// @vitest-environment happy-dom
import { describe, expect, it, vi } from "vitest";

vi.mock("../../../platform", () => ({
  platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {},
}));

import type { Collisions, Fix, LiveCheck } from "../../../generated/responses";
import { platform } from "../../../platform";
import type { SceneDesign } from "../../../scene/interface";
import { useDesign } from "../design";
import { avoidCollisions, useAvoiding } from "./avoiding";
import { applyFix, fixesOf, otherWires, previewOf } from "./fixes";

const design: SceneDesign = {
  vertices: new Map([0, 1, 2].map((id) => [id, { id, at: [id * 10, 0, 0] as const, support: false }])),
  edges: new Map([
    [5, { id: 5, a: 0, b: 1 }],
    [6, { id: 6, a: 1, b: 2 }],
  ]),
};
const nothing = { moved: [], doubled: [], gone_edges: [], new_edges: [], detached: [] };

describe("the preview of a fix", () => {
  it("shows the edges at a moved vertex where they would be, and not where they are", () => {
    const { edges, removed } = previewOf({ ...nothing, moved: [{ vertex: 2, at_mm: [30, 0, 0] }] }, design);
    expect(edges).toEqual([
      [
        [10, 0, 0],
        [30, 0, 0],
      ],
    ]);
    expect([...removed]).toEqual([6]);
  });

  it("shows doubled edges where they are, new ones where they come, and takes away what goes", () => {
    const { edges, removed } = previewOf(
      {
        ...nothing,
        doubled: [5],
        gone_edges: [6],
        new_edges: [
          [
            [0, 0, 0],
            [0, 0, 9],
          ],
        ],
      },
      design,
    );
    expect(edges).toEqual([
      [
        [0, 0, 0],
        [0, 0, 9],
      ],
      [
        [0, 0, 0],
        [10, 0, 0],
      ],
    ]);
    expect([...removed]).toEqual([6]);
  });

  it("shows the wires that would be split off", () => {
    expect(previewOf({ ...nothing, detached: [[6]] }, design).edges).toEqual([
      [
        [10, 0, 0],
        [20, 0, 0],
      ],
    ]);
  });

  it("draws nothing of a moved edge that goes", () => {
    expect(previewOf({ ...nothing, moved: [{ vertex: 2, at_mm: [1, 1, 1] }], gone_edges: [6] }, design).edges).toEqual(
      [],
    );
  });
});

it("a fix belongs to the diagnostic of its place", () => {
  const report = {
    code: "edge_too_short" as const,
    severity: "error" as const,
    edge: 3,
    step: 9,
    message: "",
    help: "",
  };
  const fix = { mends: { ...report, vertex: null } } as unknown as Fix;
  expect(fixesOf(report, [fix])).toEqual([fix]);
  expect(fixesOf({ ...report, edge: 4 }, [fix])).toEqual([]);
});

describe("a way without collisions that takes more wires", () => {
  const collisions = { contacts: [{}], checked: true, stopped: false } as unknown as Collisions;
  const way = {
    title: "Bend it in another order",
    mends: { code: "meets_stock" },
    edit: { edit: "walks" },
    after: { wires: 3 },
    preview: nothing,
  } as unknown as Fix;

  it("is offered with how many it makes, and made only when a person takes it, who is told so once more", async () => {
    const ask = vi.mocked(platform.ask);
    const outcome = { found: true, ended: false, best: way, unfound: [], helps: [] };
    ask
      .mockReset()
      .mockImplementation((async (name: string) => (name === "avoid-collisions" ? outcome : null)) as never);
    const limits = { wires: [{}] } as unknown as LiveCheck;
    useDesign.setState({ limits, collisions: { found: collisions, version: 1, profiles: 0, dragged: false } });
    await avoidCollisions();
    expect(ask).not.toHaveBeenCalledWith("edit", expect.anything());
    expect(useAvoiding.getState().avoiding?.outcome?.best).toBe(way);
    expect(otherWires(way)).toBe("3 wires instead of 1");
    expect(otherWires({ ...way, after: { ...way.after, wires: 1 } })).toBeNull();
    await applyFix(way);
    expect(ask).toHaveBeenCalledWith("edit", expect.objectContaining({ request: { edit: "walks" } }));
  });
});
