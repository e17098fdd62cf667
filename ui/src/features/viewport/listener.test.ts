// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { type DesignState, useDesign } from "../../state/design/design";
import { closeMenu, useContextMenu } from "../../state/window/context_menu";
import { useView } from "../../state/window/view";
import { drawOf, endOf, listenerOf, strokeOf } from "./listener";

describe("the strand that is shown in the panel", () => {
  const state = { machine: null, next: [0, 0], stencils: [], walks: [] } as unknown as DesignState;
  const made = {
    change: {
      state,
      stencil: false,
      gone_vertices: [],
      gone_edges: [],
      edges: [{ id: 0, a: 0, b: 1 }],
      vertices: [0, 1].map((id) => ({ id, at_mm: [id, 0, 0], support: false })),
    },
  };
  const stroke = {
    from: null,
    through: [
      [0, 0, 0],
      [1, 0, 0],
    ],
    to: null,
    split: null,
  } as const;
  beforeEach(() => {
    useDesign.setState({ vertices: new Map(), edges: new Map(), state });
    useView.setState({ strand: null });
  });

  it("has the edges that were drawn", async () => {
    platform.ask.mockResolvedValue(made);
    expect(await listenerOf(() => ({ left: 0, top: 44 })).stroke(stroke)).toBe(1);
    expect(useView.getState().strand).toBe(1);
  });

  it("is over when it was ended while its stroke was on its way", async () => {
    platform.ask.mockResolvedValue(made);
    const listener = listenerOf(() => ({ left: 0, top: 44 }));
    const drawn = listener.stroke(stroke);
    listener.strandEnded();
    await drawn;
    expect(useView.getState().strand).toBeNull();
  });
});

describe("a stroke", () => {
  it("becomes one change", () => {
    expect(drawOf({ from: 3, through: [[1, 2, 3]], to: null })).toEqual({
      edit: "draw",
      from: 3,
      through_mm: [[1, 2, 3]],
      to: null,
    });
  });

  it("continues from its last new vertex, and is over at one that was there", () => {
    expect(
      endOf(
        {
          from: null,
          through: [
            [0, 0, 0],
            [1, 0, 0],
          ],
          to: null,
        },
        [58, 57],
      ),
    ).toBe(58);
    expect(endOf({ from: 3, through: [[1, 0, 0]], to: 4 }, [58])).toBeNull();
    expect(endOf({ from: 3, through: [[1, 0, 0]], to: null }, [])).toBeNull();
  });

  it("from an edge splits it first, as one thing to undo, and begins at the new vertex", () => {
    const { request, ends } = strokeOf(
      { from: null, through: [[1, 0, 0]], to: null, split: { edge: 7, at: 0.25, end: "from" } },
      60,
    );
    expect(request).toEqual({
      edit: "several",
      label: "draw",
      edits: [{ edit: "split", edge: 7, at: 0.25 }, drawOf({ from: 60, through: [[1, 0, 0]], to: null })],
    });
    expect(endOf(ends, [60, 61])).toBe(61);
  });

  it("to an edge ends at the new vertex", () => {
    const { request, ends } = strokeOf({ from: 3, through: [], to: null, split: { edge: 7, at: 0.5, end: "to" } }, 60);
    expect(request).toMatchObject({ edit: "several", edits: [{ edit: "split" }, { edit: "draw", from: 3, to: 60 }] });
    expect(endOf(ends, [60])).toBeNull();
  });

  it("that only splits an edge continues from there", () => {
    const { request, ends } = strokeOf(
      { from: null, through: [], to: null, split: { edge: 7, at: 0.5, end: "from" } },
      60,
    );
    expect(request).toEqual({ edit: "split", edge: 7, at: 0.5 });
    expect(endOf(ends, [60])).toBe(60);
  });
});

it("shows the menu of a right click where it was, in the window", () => {
  listenerOf(() => ({ left: 10, top: 44 })).menu({ x: 100, y: 200 });
  expect(useContextMenu.getState().opened).toMatchObject({ place: "design", at: { x: 110, y: 244 } });
  closeMenu();
});
