// @vitest-environment happy-dom
import { act } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { LiveCheck, PortEntry } from "../../generated/responses";
import { Dialog, DialogHead } from "../../shared/layers/Dialog";
import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { setWire, useRow } from "../../state/machine/row";
import { useRun } from "../../state/machine/run";
import { designState, machineState } from "../../state/testing";
import { useUi } from "../../state/window/ui";
import { RunSection } from "./RunSection";
import { SessionStop } from "./StopButton";

const at = place();

beforeEach(() => {
  platform.ask.mockReset().mockReturnValue(new Promise(() => {}));
  platform.stop.mockClear();
  useUi.setState({ open: ["run"] });
});
afterEach(() => {
  useRun.setState({ state: null });
});

const buttons = (): string[] => [...at.host.querySelectorAll("button")].map((button) => button.textContent ?? "");

it("has a button to connect a machine that has failed again: its problem says to do so", () => {
  useRun.setState({ state: machineState("failed", "home", "disconnect") });
  at.show(<RunSection />);
  expect(buttons()).toEqual(expect.arrayContaining(["Connect again", "Home", "Disconnect"]));
  // A controller that still has power goes on with what it was sent: that nothing moves is not known here.
  expect(at.host.textContent).toContain("Closes the failed connection. Connecting moves nothing.");
  expect(at.host.textContent).not.toContain("Nothing moves.");
  act(() => useRun.setState({ state: machineState("ready", "home", "disconnect") }));
  expect(buttons()).not.toContain("Connect again");
});

it("says how to come to another machine while a wire is in the connected one, which cannot be disconnected then", () => {
  useDesign.setState({ state: designState({ machine: "grbl-bender" }) });
  useRun.setState({ state: machineState("holding", "resume", "speed") });
  at.show(<RunSection />);
  expect(at.host.textContent).toContain("Finish the wire or stop it first, then disconnect to connect the other one.");
  expect(at.host.textContent).not.toContain("Disconnect it to connect the other one.");
  // Nor between two wires of a row.
  act(() => useRun.setState({ state: machineState("moving"), between: true }));
  expect(at.host.textContent).toContain("Finish the wire or stop it first, then disconnect to connect the other one.");
  act(() => useRun.setState({ between: false }));
  // Nor while it homes, or moves without a wire: that is waited for.
  for (const phase of ["homing", "moving"] as const) {
    act(() => useRun.setState({ state: machineState(phase) }));
    expect(at.host.textContent).toContain("Disconnect it once it is done, to connect the other one.");
  }
  act(() => useRun.setState({ state: machineState("ready", "disconnect") }));
  expect(at.host.textContent).toContain("Disconnect it to connect the other one.");
  useDesign.setState({ state: null });
});

it("says while it homes what moves and how to end it, without a figure that nobody knows", () => {
  useRun.setState({ state: machineState("homing") });
  at.show(<RunSection />);
  expect(at.host.querySelector(".run-state")?.textContent).toContain("Axes move to find zero. STOP ends it.");
  const bar = at.host.querySelector<HTMLProgressElement>(".run-state progress");
  expect([bar?.getAttribute("aria-label"), bar?.hasAttribute("value")]).toEqual(["Homing", false]);
  act(() => useRun.setState({ state: machineState("ready", "home") }));
  expect(at.host.querySelector(".run-state progress")).toBeNull();
});

it("stops the machine out of any dialog, which makes STOP in the top bar inert, and only while there is one", () => {
  const about = (
    <DialogHead value={<SessionStop />}>
      <Dialog title="About" onClose={() => {}}>
        words
      </Dialog>
    </DialogHead>
  );
  at.show(about);
  expect(at.host.querySelector("dialog .stop-button")).toBeNull();
  act(() => useRun.setState({ state: machineState("homing") }));
  act(
    () =>
      void at.host
        .querySelector("dialog .stop-button")
        ?.dispatchEvent(new PointerEvent("pointerdown", { button: 0, bubbles: true })),
  );
  expect(platform.stop).toHaveBeenCalledOnce();
});

it("reports a wire that was interrupted before anything is connected, and none that is finished", () => {
  const run = {
    id: "1",
    name: "House",
    machine: "wirebend-kit",
    wire: 0,
    piece: null,
    steps: 10,
    made: 3,
    interruptions: 1,
    pauses: 0,
    material: null,
    problem: null,
    started: null,
    ended: null,
    job_hash: null,
    worst_deviation_mm: null,
  };
  useRun.setState({ state: null, runs: [{ ...run, outcome: "finished" }] });
  at.show(<RunSection />);
  expect(at.host.textContent).not.toContain("interrupted");
  act(() => useRun.setState({ runs: [{ ...run, outcome: "unfinished" }] }));
  expect(at.host.textContent).toContain("A wire was interrupted");
  expect(at.host.textContent).toContain("House, interrupted after step 3 of 10 · 1 interruption · wirebend-kit");
});

it("does not arm a wire that collides unless a person wants it all the same, knowing what follows", () => {
  const limits = { feasible: true, diagnostics: [], wires: [{ time_s: 60 }] } as unknown as LiveCheck;
  const hit = { severity: "error", code: "meets_stock" } as LiveCheck["diagnostics"][number];
  useDesign.setState({
    edges: new Map([[0, { id: 0, a: 0, b: 1 }]]),
    limits,
    check: { ...limits, feasible: false, diagnostics: [hit] },
  });
  useRun.setState({ state: machineState("ready", "arm", "dry-run", "disconnect") });
  platform.ask.mockClear();
  at.show(<RunSection />);
  const arm = () => [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === "Arm…");
  const orders = () => platform.ask.mock.calls.filter(([name]) => name === "order");
  act(() => arm()?.click());
  expect(orders()).toEqual([]);
  const box = [...at.host.querySelectorAll("label")].find(({ textContent }) => textContent === "Bend it anyway");
  act(() => box?.querySelector("input")?.click());
  expect(at.host.textContent).toContain("The wire will hit the machine or itself");
  act(() => arm()?.click());
  expect(orders()).toMatchObject([["order", { request: { order: "arm", despite_errors: true } }]]);
  useDesign.setState({ edges: new Map(), limits: null, check: null });
});

it("keeps the chosen port when the machine is disconnected, and goes back to no simulated one", async () => {
  const port = (name: string, simulated: boolean): PortEntry =>
    ({ name, simulated, description: "", likely_for: [], usb: null }) as unknown as PortEntry;
  useDesign.setState({ state: designState({ machine: "wirebend-kit" }) });
  useRun.setState({ state: null, ports: [port("sim", true), port("/dev/ttyACM7", false)] });
  const chosen = () => at.host.querySelector<HTMLSelectElement>("select")?.value;
  at.show(<RunSection />);
  expect(chosen()).toBe("sim");
  act(() => {
    const select = at.host.querySelector("select");
    Object.getOwnPropertyDescriptor(HTMLSelectElement.prototype, "value")?.set?.call(select, "/dev/ttyACM7");
    select?.dispatchEvent(new Event("change", { bubbles: true }));
  });
  act(() => useRun.setState({ state: machineState("ready", "disconnect") }));
  act(() => useRun.setState({ state: machineState("closed") }));
  expect(chosen()).toBe("/dev/ttyACM7");
});

it("has the machine cut the pieces off where it has a cutter, unless a person does it", () => {
  const limits = {
    feasible: true,
    diagnostics: [],
    wires: [{ time_s: 60, stock_mm: 302 }],
  } as unknown as LiveCheck;
  useDesign.setState({ edges: new Map([[0, { id: 0, a: 0, b: 1 }]]), limits, check: limits });
  const ready = machineState("ready", "arm", "disconnect");
  useRun.setState({ state: ready });
  platform.ask.mockClear();
  at.show(<RunSection />);
  const box = () =>
    [...at.host.querySelectorAll("label")].find(({ textContent }) => textContent === "Cut each piece off");
  const stands = () => {
    const input = box()?.querySelector("input");
    return [input?.checked, input?.disabled];
  };
  const arm = () => {
    platform.ask.mockClear();
    act(() => [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === "Arm…")?.click());
    return platform.ask.mock.calls.find(([name]) => name === "order")?.[1].request.repeat;
  };
  expect(stands()).toEqual([false, true]);
  expect(at.host.textContent).toContain("load 302.0 mm");
  expect(box()?.title).toContain("no cutter");
  expect(arm()).toMatchObject({ cut: false });
  act(() => useRun.setState({ state: { ...ready, cutter_mm: 12.5 } }));
  expect(stands()).toEqual([true, false]);
  // 12.5 mm more are fed to the cutter.
  expect(at.host.textContent).toContain("load 314.5 mm");
  expect(arm()).toMatchObject({ cut: true });
  act(() => box()?.querySelector("input")?.click());
  expect(arm()).toMatchObject({ cut: false });
  useDesign.setState({ edges: new Map(), limits: null, check: null });
});

it("bends all wires of a design, one after the other, unless a person chooses one", () => {
  const wires = [
    { time_s: 60, length_mm: 200, stock_mm: 600 },
    { time_s: 60, length_mm: 300, stock_mm: 700 },
  ];
  const limits = { feasible: true, diagnostics: [], wires } as unknown as LiveCheck;
  useDesign.setState({ edges: new Map([[0, { id: 0, a: 0, b: 1 }]]), limits, check: limits });
  useRow.setState(useRow.getInitialState(), true);
  useRun.setState({ state: machineState("ready", "arm", "dry-run", "disconnect") });
  at.show(<RunSection />);
  const button = (text: string) =>
    [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === text);
  const armed = () => {
    platform.ask.mockClear();
    act(() => button("Arm…")?.click());
    return platform.ask.mock.calls.find(([name]) => name === "order")?.[1].request;
  };
  expect(at.host.textContent).toContain("load up to 700.0 mm");
  expect(armed()).toMatchObject({ order: "arm", wire: null, repeat: { pieces: 1 } });
  expect(button("Dry run…")?.getAttribute("aria-disabled") ?? button("Dry run…")?.disabled).toBeTruthy();
  act(() => useRow.setState({ rest: [1], pieces: 4 }));
  expect(at.host.textContent).toContain("Wire 2 of the piece remains.");
  expect(armed(), "the rest of a piece is bent once").toMatchObject({ wire: 1, repeat: { pieces: 1 } });
  act(() => setWire(0));
  expect(at.host.textContent).toContain("load 600.0 mm");
  expect(armed()).toMatchObject({ wire: 0, repeat: { pieces: 4 } });
  useDesign.setState({ edges: new Map(), limits: null, check: null });
  useRow.setState(useRow.getInitialState(), true);
});
