// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({
  ask: vi.fn(),
  stop: vi.fn(),
  listen: vi.fn(),
  stencilMesh: vi.fn(),
  close: vi.fn(),
  pickSave: vi.fn(),
}));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { useProblems } from "../asking/problems";
import { edit, useDesign } from "../design/design";
import { select, useSelection } from "../design/selection";
import type { MachineState } from "../machine/operator";
import { useRun } from "../machine/run";
import { machineState } from "../testing";
import { useView } from "../window/view";
import { mayClose, quit, useClosing } from "./closing";
import {
  addWireframe,
  mayLeave,
  newDesign,
  openAs,
  openPath,
  restore,
  save,
  saveAs,
  saveJob,
  saveWireframe,
  useFiles,
} from "./files";

/** The Rust side, as far as it is asked here: whether its design is changed, and what it is called. */
const rust: { changed: boolean; name: string; file: string | null } = {
  changed: false,
  name: "A",
  file: "/there/a.wirebend",
};
const view = () => ({
  state: {
    changed: rust.changed,
    name: rust.name,
    file: rust.file,
    notes: "",
    machine: null,
    units: "mm",
    stencils: [],
    walks: [],
    construction_mm: [],
    parts: [],
  },
  vertices: [],
  edges: [],
});
const opened = () => ({ design: view(), notes: [], recent: [] });
const changed = () => ({
  change: { vertices: [], edges: [], gone_vertices: [], gone_edges: [], state: view().state },
  notes: [],
});

/** Questions that are not answered before the test lets them be. */
const held = new Map<string, () => void>();
const hold = (ask: string) => held.set(ask, () => {});

async function answered(ask: string): Promise<unknown> {
  if (held.has(ask)) await new Promise<void>((release) => held.set(ask, release));
  switch (ask) {
    case "edit":
      rust.changed = true;
      return changed();
    case "look":
      return { seen: "document", asks_units: false, format: "wirebend" };
    case "save":
      rust.changed = false;
      return opened();
    case "new":
    case "open":
    case "close":
    case "restore":
      Object.assign(rust, { changed: false, name: "B" });
      return opened();
    default:
      throw new Error(`nobody answers ${ask}`);
  }
}

const asked = () => platform.ask.mock.calls.map(([ask]) => ask as string);
const turns = () => new Promise((resolve) => setTimeout(resolve));
const change = () => edit({ edit: "delete", vertices: [0], edges: [] });

beforeEach(() => {
  Object.assign(rust, { changed: false, name: "A", file: "/there/a.wirebend" });
  held.clear();
  for (const mock of [platform.ask, platform.stop, platform.close, platform.pickSave]) mock.mockReset();
  platform.ask.mockImplementation(answered);
  useDesign.setState({ ...view(), vertices: new Map(), edges: new Map() } as never);
  useFiles.setState({ leaving: null, unsaved: [], busy: null });
  useRun.setState({ state: null });
  useClosing.setState({ asked: null });
  useProblems.setState({ problems: [] });
});

describe("leaving a design", () => {
  it("asks of a change that is still on its way, and does not lose it", async () => {
    void change();
    const left = newDesign();
    await turns();
    expect(asked()).toEqual(["edit"]);
    useFiles.getState().leaving?.("stay");
    expect(await left).toBe(false);
    expect(useFiles.getState().leaving).toBeNull();
  });

  it("asks nothing of a new design in which nothing was drawn, whatever machine was chosen for it", async () => {
    rust.file = null;
    await change();
    expect(await mayLeave()).toBe(true);
    expect(useFiles.getState().leaving).toBeNull();
  });

  it("asks once more for what was changed while it was saved", async () => {
    await change();
    hold("save");
    const left = mayLeave();
    await turns();
    useFiles.getState().leaving?.("save");
    await turns();
    void change();
    held.get("save")?.();
    await turns();
    expect(asked()).toEqual(["edit", "save", "edit"]);
    useFiles.getState().leaving?.("drop");
    expect(await left).toBe(true);
  });

  it("asks one question at a time: the first is answered by staying, the second can be answered", async () => {
    await change();
    const first = mayLeave();
    await turns();
    const second = mayLeave();
    expect(await first).toBe(false);
    await turns();
    expect(useFiles.getState().leaving).not.toBeNull();
    useFiles.getState().leaving?.("drop");
    expect(await second).toBe(true);
    expect(useFiles.getState().leaving).toBeNull();
  });
});

describe("a file that is being read", () => {
  it("lets nothing be changed or saved, which would be another design by then", async () => {
    hold("open");
    const open = openPath("/there/b.wirebend");
    await turns();
    expect(await change()).toBeNull();
    expect(await save()).toBe(false);
    expect(useProblems.getState().problems.map(({ code }) => code)).toContain("being-read");
    held.get("open")?.();
    await open;
    expect(asked()).toEqual(["look", "open"]);
    expect(useDesign.getState().state?.name).toBe("B");
    expect(await change()).not.toBeNull();
  });

  it("that cannot be opened leaves the design as it was, to be changed again", async () => {
    platform.ask.mockImplementation(async (ask: string) =>
      ask === "open" ? Promise.reject(new Error("Line 3 is cut off.")) : answered(ask),
    );
    await openPath("/there/b.wirebend");
    expect(useDesign.getState().state?.name).toBe("A");
    expect(useFiles.getState().busy).toBeNull();
    expect(await change()).not.toBeNull();
  });
});

describe("what is added to the design that is open", () => {
  const vertex = (id: number) => ({ id, at_mm: [id, 0, 0], support: false });
  const add = (change: object) =>
    platform.ask.mockImplementation(async (ask: string) =>
      ask.startsWith("put-") ? { change: { ...changed().change, ...change }, notes: [] } : answered(ask),
    );

  beforeEach(() => {
    useDesign.setState({ vertices: new Map([[1, { id: 1, at: [0, 0, 0], support: false }]]) });
    useView.setState({ tool: "trace", chosenStencil: null });
    select([1]);
  });

  it("is selected with the tool that moves it, and what was there before is not", async () => {
    // The first is there already, and is joined to what comes.
    add({ vertices: [vertex(1), vertex(7), vertex(8)], edges: [{ id: 4, a: 7, b: 8 }] });
    expect(await addWireframe({ input: { file: "/there/b.obj" } })).toBe(true);
    const { vertices, edges } = useSelection.getState();
    expect([[...vertices], [...edges], useView.getState().tool]).toEqual([[7, 8], [4], "select"]);
  });

  it("is chosen where it is a stencil, and a person who traces goes on to trace", async () => {
    add({ state: { ...view().state, stencils: [{ id: 3, name: "b.stl", surface: null }] } });
    expect(await openAs({ input: { file: "/there/b.stl" } }, "stencil")).toBe(true);
    const { chosenStencil, tool } = useView.getState();
    expect([chosenStencil, tool, [...useSelection.getState().vertices]]).toEqual([3, "trace", []]);
  });

  it("leaves the selection as it is where it is refused", async () => {
    platform.ask.mockRejectedValue(new Error("Line 3 is cut off."));
    expect(await addWireframe({ input: { file: "/there/b.obj" } })).toBe(false);
    expect([[...useSelection.getState().vertices], useView.getState().tool]).toEqual([[1], "trace"]);
  });
});

it("does not save another design under the name that was chosen for the one before", async () => {
  let pick: (path: string) => void = () => {};
  platform.pickSave.mockImplementation(() => new Promise((resolve) => (pick = resolve)));
  const saved = saveAs();
  await openPath("/there/b.wirebend");
  pick("/there/a2.wirebend");
  expect(await saved).toBe(false);
  expect(asked()).not.toContain("save");
});

it.each([
  ["a job", saveJob],
  ["a wireframe", saveWireframe],
])("does not save %s of another design there, either", async (_, saves) => {
  let pick: (path: string) => void = () => {};
  platform.pickSave.mockImplementation(() => new Promise((resolve) => (pick = resolve)));
  const saved = saves();
  await openPath("/there/b.wirebend");
  pick("/there/a2");
  await saved;
  expect(asked()).toEqual(["look", "open"]);
  expect(useProblems.getState().problems.map(({ code }) => code)).toEqual(["not-saved"]);
});

it("opens the file that was opened last, although one before is read for longer", async () => {
  let read: (answer: unknown) => void = () => {};
  platform.ask.mockImplementationOnce(() => new Promise((resolve) => (read = resolve)));
  const large = openPath("/there/large.wirebend");
  await openPath("/there/b.wirebend");
  read(await answered("look"));
  await large;
  expect(platform.ask.mock.calls.filter(([ask]) => ask === "open").map(([, given]) => given)).toEqual([
    { design: { input: { file: "/there/b.wirebend" } } },
  ]);
});

it("adds each of several files, and none to a design that was opened meanwhile", async () => {
  const reads: (() => void)[] = [];
  platform.ask.mockImplementation(async (ask: string) => {
    if (ask === "put-wireframe") return changed();
    if (ask !== "look" || reads.length === 3) return answered(ask);
    await new Promise<void>((read) => reads.push(read));
    return answered("look");
  });
  const both = [openPath("/there/b.wirebend", "add"), openPath("/there/c.wirebend", "add")];
  for (const read of reads) read();
  await Promise.all(both);
  expect(asked().filter((ask) => ask === "put-wireframe")).toHaveLength(2);
  const late = openPath("/there/d.wirebend", "add");
  await openPath("/there/e.wirebend");
  reads[2]?.();
  await late;
  expect(asked().filter((ask) => ask === "put-wireframe")).toHaveLength(2);
  expect(useProblems.getState().problems.map(({ code }) => code)).toEqual(["not-added"]);
});

it("keeps the other unsaved designs on offer when one is restored", async () => {
  const [one, other] = ["/k/1", "/k/2"].map((journal) => ({ journal, name: "", changes: 1, changed_s: 0, file: null }));
  useFiles.setState({ unsaved: [one, other] as never });
  await restore("/k/1");
  expect(useFiles.getState().unsaved).toEqual([other]);
});

describe("closing the window", () => {
  const machine = (phase: MachineState["phase"]) => useRun.setState({ state: machineState(phase) });

  it("ends what is kept of the design, also where nothing is changed", async () => {
    expect(await mayClose()).toBe(true);
    expect(asked()).toEqual(["close"]);
  });

  it("ends it only after the person has given it up", async () => {
    await change();
    const closing = quit();
    await turns();
    expect(asked()).toEqual(["edit"]);
    useFiles.getState().leaving?.("drop");
    await closing;
    expect(asked()).toEqual(["edit", "close"]);
    expect(platform.close).toHaveBeenCalledOnce();
  });

  it("asks while a wire is being bent, and stops the machine first", async () => {
    machine("making");
    const order: string[] = [];
    platform.stop.mockImplementation(async () => void order.push("stop"));
    platform.close.mockImplementation(async () => void order.push("close"));
    const closing = quit();
    await turns();
    expect([useClosing.getState().asked?.phase, order]).toEqual(["making", []]);
    useClosing.getState().asked?.answer(true);
    await closing;
    expect(order).toEqual(["stop", "close"]);
  });

  it("asks about a machine that may still run what it has taken of an interrupted wire", async () => {
    useRun.setState({ state: { ...machineState("connecting"), may_move: true } });
    const closing = mayClose();
    await turns();
    expect(useClosing.getState().asked?.phase).toBe("connecting");
    useClosing.getState().asked?.answer(false);
    expect(await closing).toBe(false);
  });

  it("stays open when the person says no, or when the machine cannot be stopped", async () => {
    machine("homing");
    for (const yes of [false, true]) {
      platform.stop.mockRejectedValue(new Error("The driver does not answer."));
      const closing = mayClose();
      await turns();
      useClosing.getState().asked?.answer(yes);
      expect(await closing).toBe(false);
      expect(useClosing.getState().asked).toBeNull();
    }
    expect(platform.stop).toHaveBeenCalledOnce();
    expect(asked()).toEqual([]);
  });
});
