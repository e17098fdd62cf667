// @vitest-environment happy-dom
import { act } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../../shared/testing";
import type { Because, MachineState, Phase } from "../../../state/machine/operator";
import { useRun } from "../../../state/machine/run";
import { machineState } from "../../../state/testing";
import { ConsoleInput } from "./ConsoleInput";

const at = place();

beforeEach(() => {
  platform.ask.mockReset().mockImplementation(async () => ({ state: useRun.getState().state }));
  useRun.setState({ state: machineState("ready", "console"), typed: [], ordering: false });
});
afterEach(() => {
  useRun.setState({ state: null, typed: [] });
});

const field = () => at.host.querySelector("input") as HTMLInputElement;
const type = (text: string) =>
  act(() => {
    const set = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set;
    set?.call(field(), text);
    field().dispatchEvent(new Event("input", { bubbles: true }));
  });
const press = (key: string) =>
  act(async () => {
    field().dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    await new Promise((done) => setTimeout(done, 0));
  });
const refusing = (phase: Phase, because: Because): MachineState => ({
  ...machineState(phase),
  busy: phase !== "ready" && phase !== "armed",
  cannot: [{ order: "console", because }],
});
const sent = () => platform.ask.mock.calls.map(([, given]) => given.request?.line);

it("sends a line with Enter, and recalls those before with the arrows", async () => {
  at.show(<ConsoleInput />);
  for (const line of ["$$", "$#", "$#"]) {
    type(line);
    await press("Enter");
    expect(field().value).toBe("");
  }
  expect(sent()).toEqual(["$$", "$#", "$#"]);
  type("half");
  const seen: string[] = [];
  for (const key of ["ArrowUp", "ArrowUp", "ArrowUp", "ArrowDown", "ArrowDown", "ArrowDown"]) {
    await press(key);
    seen.push(field().value);
  }
  // What was being typed is there again in the end.
  expect(seen).toEqual(["$#", "$$", "$$", "$#", "half", "half"]);
});

it("keeps a line that was not taken", async () => {
  platform.ask.mockRejectedValue(new Error("no"));
  at.show(<ConsoleInput />);
  type("$X");
  await press("Enter");
  expect(field().value).toBe("$X");
});

it("sends a line once what is on its way is answered, and keeps what is typed meanwhile", async () => {
  let answer = () => {};
  platform.ask.mockImplementationOnce(
    () => new Promise((done) => (answer = () => done({ state: useRun.getState().state }))),
  );
  at.show(<ConsoleInput />);
  type("$$");
  await press("Enter");
  type("$#");
  await press("Enter");
  expect([field().value, sent()]).toEqual(["$#", ["$$"]]);
  expect(at.host.querySelector("button")?.title).toMatch(/sent once the machine is done/);
  await act(async () => answer());
  expect([field().value, sent()]).toEqual(["", ["$$", "$#"]]);
});

it.each([
  ["is changed", () => type("$$ ")],
  ["is given up", () => press("Escape")],
  ["cannot be sent any more", () => act(() => useRun.setState({ state: refusing("armed", "wire-armed") }))],
])("sends no line that %s while it waits", async (_, meanwhile) => {
  useRun.setState({ state: refusing("homing", "homing") });
  at.show(<ConsoleInput />);
  type("$$");
  await press("Enter");
  await meanwhile();
  act(() => useRun.setState({ state: machineState("ready") }));
  expect(field().value.trim()).toBe("$$");
  expect(platform.ask).not.toHaveBeenCalled();
});

it("says why nothing can be typed", async () => {
  for (const [state, why] of [
    [null, "Connect a machine first."],
    [refusing("making", "wire-under-way"), "A wire is being bent."],
    [refusing("ready", "unable"), "This machine's driver takes no typed lines."],
  ] as const) {
    useRun.setState({ state });
    at.show(<ConsoleInput />);
    expect(field().placeholder).toBe(why);
    expect(field().readOnly).toBe(true);
    await press("Enter");
  }
  expect(platform.ask).not.toHaveBeenCalled();
});
