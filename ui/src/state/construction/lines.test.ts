import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { useDesign } from "../design/design";
import { remove } from "../design/operations";
import { keepSelectedLines, select, useSelection } from "../design/selection";
import { designState } from "../testing";
import { editLines, type Line, placesAfter, renumberWaiting } from "./lines";

/** A line of so many mm along x. */
const line = (mm: number): Line => [
  [0, 0, 0],
  [mm, 0, 0],
];
const [A, B, C] = [line(1), line(2), line(3)] as const;

describe("the lines that are named by their places", () => {
  it.each([
    ["one before is deleted", [A, B, C], [B, C], [1, 2], [0, 1]],
    ["one of them is deleted", [A, B, C], [A, C], [1, 2], [1]],
    ["it is there again", [A, C], [A, B, C], [1], [2]],
    ["others are added", [A, B], [A, B, A, C], [0, 1], [0, 1]],
    ["all are moved", [A, B], [B, C], [0, 1], [0, 1]],
    ["one of two alike goes", [A, B, A], [A, B], [2], []],
    ["all go", [A, B], [], [0, 1], []],
  ] as const)("are the same when %s", (_, before, after, named, left) => {
    expect(placesAfter(named, before, after)).toEqual(left);
  });

  it("stay selected, and nothing else is", () => {
    select([4], [], [0, 2]);
    keepSelectedLines([A, B, C], [B, C]);
    expect(useSelection.getState()).toMatchObject({ vertices: new Set([4]), lines: new Set([1]) });
  });
});

describe("a change of lines", () => {
  const asked = () => platform.ask.mock.calls.map(([, { request }]) => request);
  beforeEach(() => {
    platform.ask.mockReset().mockResolvedValue({ change: null, notes: [] });
    useDesign.setState({ state: designState({ construction_mm: [A, B, C] as never }) });
  });

  it("names those that were meant when its turn comes, although one before them went meanwhile", async () => {
    const made = editLines([1, 2], (lines) => ({ edit: "delete", vertices: [], edges: [], lines }));
    renumberWaiting([A, B, C], [B, C]);
    await made;
    expect(asked()).toEqual([{ edit: "delete", vertices: [], edges: [], lines: [0, 1] }]);
  });

  it("deletes lines and edges that are selected together, at once", async () => {
    select([], [7], [2]);
    remove();
    await vi.waitFor(() => expect(asked()).toEqual([{ edit: "delete", vertices: [], edges: [7], lines: [2] }]));
  });
});
