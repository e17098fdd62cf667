// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { DesignState } from "../generated/responses";
import type { WindowEvent } from "../platform";
import type { SceneVertex } from "../scene/interface";
import { checked, useDesign } from "../state/design/design";
import type { MachineState } from "../state/machine/operator";
import { useRun } from "../state/machine/run";
import { machineState } from "../state/testing";
import { followMachine } from "./machine";

/** Sends the window an event of the Rust side. */
let tell: (event: WindowEvent) => void = () => {};
let end = () => {};
beforeEach(() => {
  useRun.setState({ state: null });
  platform.ask.mockReset();
  platform.listen.mockImplementation((hear: typeof tell) => {
    tell = hear;
    return () => {
      tell = () => {};
    };
  });
  end = followMachine();
});
afterEach(() => end());

it("has the design checked when a machine is connected, set otherwise, or gone", async () => {
  useDesign.setState({
    state: { machine: "kit" } as DesignState,
    vertices: new Map([[0, { id: 0, at: [0, 0, 0], support: false } as SceneVertex]]),
  });
  platform.ask.mockResolvedValue({ feasible: true, diagnostics: [], wires: [], limits_unknown: null });
  const asked = async (given: Partial<MachineState>): Promise<number> => {
    platform.ask.mockClear();
    tell({
      event: "operator",
      value: { event: "state", ...machineState("ready", "home"), port: "sim", simulated: true, ...given },
    });
    await checked();
    return platform.ask.mock.calls.filter(([what]) => what === "check").length;
  };
  expect(await asked({ phase: "connecting" })).toBe(0);
  expect(await asked({ phase: "connected" })).toBe(1);
  expect(await asked({ phase: "ready" })).toBe(0);
  const settings = [{ name: "bend_limit", machine: "80", expected: "120", matters: true }];
  expect(await asked({ phase: "ready", settings })).toBe(1);
  expect(await asked({ phase: "closed", settings })).toBe(1);
  useDesign.setState({ state: null, vertices: new Map() });
});
