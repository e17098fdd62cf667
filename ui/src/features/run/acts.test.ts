// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({
  ask: vi.fn(async () => ({ state: null })),
  stop: vi.fn(async () => {}),
  listen: vi.fn(),
}));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { ErrorRemedy } from "../../generated/responses";
import type { MachineState, Order, Unfinished } from "../../state/machine/operator";
import { useRow } from "../../state/machine/row";
import { machineState } from "../../state/testing";
import { actsOf } from "./acts";
import { buttons } from "./buttons";

beforeEach(() => platform.ask.mockClear());

const RESUME: ErrorRemedy = {
  remedy: "resume-run",
  run: { job: null, port: null, wire: 0, machine: null, material: null },
};
const PROSPECT = { machine: "wirebend-kit", program: true, feasible: true, file: null };
const state = machineState("stopped", "home", "resume-run");
const toArm = { why: null, arm: vi.fn() };
const acts = (remedies: readonly ErrorRemedy[], of = state) => actsOf(remedies, of, buttons(of, PROSPECT), toArm);
const labels = (remedies: readonly ErrorRemedy[], of = state) => acts(remedies, of).acts.map(({ label }) => label);

it("offers what the window can do as a button, each once and with what follows, and leaves the rest to be said", () => {
  const found = acts([{ remedy: "home" }, { remedy: "cut-power" }, { remedy: "connect" }, { remedy: "connect-again" }]);
  expect(found.acts.map(({ label, consequence }) => [label, /\.$/.test(consequence)])).toEqual([
    ["Home", true],
    ["Connect again", true],
  ]);
  expect(found.others).toEqual([{ remedy: "cut-power" }]);
});

it("says of connecting again what the button does, and nothing of a machine that may still move", () => {
  const again: ErrorRemedy[] = [{ remedy: "connect-again" }, { remedy: "connect-at", port: "/dev/ttyACM1" }];
  expect(acts(again).acts.map(({ consequence }) => consequence)).toEqual([
    "Closes this connection and makes another one. Connecting moves nothing.",
    "Closes this connection and connects the machine at that port. Connecting moves nothing.",
  ]);
});

it("orders what its button says, where the machine takes that order", () => {
  const [home] = acts([{ remedy: "home" }]).acts;
  expect(home?.why).toBeNull();
  home?.run();
  expect(platform.ask).toHaveBeenCalledWith("order", { request: { order: "home" } });
  expect(acts([{ remedy: "home" }], machineState("homing")).acts[0]?.why).toMatch(/\.$/);
});

it("resumes a wire only where there is one", () => {
  expect(labels([RESUME])).toEqual([]);
  const unfinished = { job_hash: "a1", wire: 0, made: 2, of: 5, resumable: true } as Unfinished;
  expect(labels([RESUME], { ...state, unfinished })).toEqual(["Resume…"]);
});

it("arms again, gives a wire up, and leaves the cutter alone at a button", () => {
  const again = acts([{ remedy: "arm-again" }, { remedy: "plan-again" }]);
  expect([again.acts.map(({ label }) => label), again.others]).toEqual([["Arm…"], []]);
  again.acts[0]?.run();
  expect(toArm.arm).toHaveBeenCalledOnce();

  expect(labels([{ remedy: "begin-anew" }]), "there is none").toEqual([]);
  const unfinished = { job_hash: "a1", wire: 1, made: 2, of: 5, resumable: false } as Unfinished;
  const [giveUp] = acts([{ remedy: "begin-anew" }, { remedy: "abandon-run", run: RESUME.run }], {
    ...state,
    unfinished,
  }).acts;
  giveUp?.run();
  expect(platform.ask).toHaveBeenCalledWith("order", { request: { order: "abandon", job_hash: "a1", wire: 1 } });

  expect(useRow.getState().cut).toBe(true);
  acts([{ remedy: "cut-by-hand" }]).acts[0]?.run();
  expect(useRow.getState().cut).toBe(false);
});

it("still says what a person has to look at or do themselves, where its button is only half of it", () => {
  for (const half of [
    { remedy: "check-power-and-port" },
    { remedy: "update-driver" },
    { remedy: "change-driver-setting" },
    { remedy: "trust-driver", file: "/drivers/a.so", again: true },
    { remedy: "restrict-access", path: "/drivers" },
    { remedy: "arm-or-jog" },
  ] satisfies ErrorRemedy[]) {
    const { acts: buttons, others } = acts([half]);
    expect([half.remedy, buttons.length, others]).toEqual([half.remedy, 1, [half]]);
  }
  expect(labels([{ remedy: "check-power-and-port" }])).toEqual(["Connect again"]);
});

it.each<readonly [ErrorRemedy["remedy"], MachineState, readonly (readonly [string, Order | "stop"])[]]>([
  [
    "pause-or-stop",
    machineState("making", "pause"),
    [
      ["Pause", { order: "pause" }],
      ["STOP", "stop"],
    ],
  ],
  [
    "continue-or-stop",
    machineState("holding", "resume"),
    [
      ["Resume", { order: "resume" }],
      ["STOP", "stop"],
    ],
  ],
  [
    "start-or-disarm",
    machineState("armed", "start", "disarm"),
    [
      ["Start", { order: "start" }],
      ["Disarm", { order: "disarm" }],
    ],
  ],
])("has a button for either choice of %s, and not for one alone", (remedy, of, expected) => {
  const found = acts([{ remedy } as ErrorRemedy], of);
  expect(found.others).toEqual([]);
  expect(found.acts.map(({ label, consequence, why }) => [label, /\.$/.test(consequence), why])).toEqual(
    expected.map(([label]) => [label, true, null]),
  );
  for (const [index, [, does]] of expected.entries()) {
    platform.ask.mockClear();
    platform.stop.mockClear();
    found.acts[index]?.run();
    expect(platform.stop).toHaveBeenCalledTimes(does === "stop" ? 1 : 0);
    expect(platform.ask.mock.calls).toEqual(does === "stop" ? [] : [["order", { request: does }]]);
  }
});
