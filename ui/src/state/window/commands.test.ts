// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(async (_: string) => null), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { type DesignState, edit, useDesign } from "../design/design";
import { useSelection } from "../design/selection";
import { replacingDesign } from "../design/turns";
import { usePlayback } from "../program/program";
import { run, whyNot } from "./commands";
import type { CommandId } from "./keys";
import { useUi } from "./ui";
import { useUnits } from "./units";
import { useView } from "./view";

const CHANGES: readonly CommandId[] = [
  "undo",
  "redo",
  "cut",
  "paste",
  "duplicate",
  "delete",
  "straighten",
  "mirror",
  "array",
  "move",
  "extrude",
  "split",
  "merge",
  "connect",
];

beforeEach(() => {
  platform.ask.mockClear();
  const at = (id: number) => [id, { id, at: [id * 10, 0, 0] as const, support: false }] as const;
  useDesign.setState({
    state: { undo: "move", redo: "move", units: "mm" } as DesignState,
    vertices: new Map([at(1), at(2)]),
    edges: new Map([[3, { id: 3, a: 1, b: 2 }]]),
  });
  useSelection.setState({ vertices: new Set([1, 2]), edges: new Set([3]) });
  usePlayback.setState({ live: false });
  useUi.setState({ unit: null });
  useUnits.setState({ unit: "mm" });
});

describe("changes", () => {
  it("can be made of what is selected", () => {
    expect(CHANGES.filter((id) => whyNot(id) !== null)).toEqual([]);
  });

  it("are refused while a machine bends the wire that is shown", () => {
    usePlayback.setState({ live: true });
    expect(CHANGES.map(whyNot)).toEqual(CHANGES.map(() => "A machine is bending the wire."));
    expect(run("delete")).toBe(false);
    expect(platform.ask).not.toHaveBeenCalled();
    expect(whyNot("stop")).toBeNull();
    expect(whyNot("save")).toBeNull();
  });

  it("are refused while another design is being read", async () => {
    let there: () => void = () => {};
    const replaced = replacingDesign(() => new Promise<void>((resolve) => (there = resolve)));
    expect(whyNot("delete")).toBe("A file is being read.");
    await Promise.resolve();
    there();
    await replaced;
    expect(whyNot("delete")).toBeNull();
  });
});

describe("undo", () => {
  it("takes back a change that is on its way, as soon as it is made", async () => {
    useDesign.setState({ state: { undo: null, redo: null, units: "mm" } as DesignState });
    expect(whyNot("undo")).toBe("There is nothing to undo.");
    const made = edit({ edit: "delete", vertices: [1], edges: [] });
    expect(run("undo")).toBe(true);
    await made;
    await vi.waitFor(() => expect(platform.ask.mock.calls.map(([ask]) => ask)).toEqual(["edit", "undo"]));
    await vi.waitFor(() => expect(whyNot("undo")).toBe("There is nothing to undo."));
  });
});

describe("the unit of lengths", () => {
  it("is how they are shown, and nothing that the design has or that could be undone", () => {
    run("units");
    expect(useUi.getState().unit).toBe("inch");
    expect(platform.ask).not.toHaveBeenCalled();
  });
});

describe("the plane that is drawn on", () => {
  const seen: string[] = [];
  beforeEach(() => {
    seen.length = 0;
    const handle = { view: (side: string) => seen.push(side) } as unknown as NonNullable<
      ReturnType<typeof useView.getState>["handle"]
    >;
    useView.setState({ handle, tool: "draw", plane: "xy", strand: null });
  });

  it.each([
    ["view-front", "front", "xz"],
    ["view-back", "back", "xz"],
    ["view-right", "right", "yz"],
    ["view-left", "left", "yz"],
    ["view-top", "top", "xy"],
    ["view-bottom", "bottom", "xy"],
  ] as const)("goes with %s, which would show another one from its edge", (command, side, plane) => {
    expect(run(command)).toBe(true);
    expect([seen, useView.getState().plane]).toEqual([[side], plane]);
  });

  it("stays while a strand is drawn on it, and the view with it", () => {
    useView.setState({ strand: 1 });
    expect(whyNot("view-front")).toMatch(/end the strand first/);
    expect(run("view-front")).toBe(false);
    expect(run("view-bottom")).toBe(true);
    expect([seen, useView.getState().plane]).toEqual([["bottom"], "xy"]);
  });

  it("stays as it is while nothing is drawn", () => {
    useView.setState({ tool: "select", strand: null });
    run("view-right");
    expect([seen, useView.getState().plane]).toEqual([["right"], "xy"]);
  });
});
