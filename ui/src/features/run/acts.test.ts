// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(async () => ({ state: null })), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { ErrorRemedy } from "../../generated/responses";
import type { Unfinished } from "../../state/machine/operator";
import { machineState } from "../../state/testing";
import { actsOf } from "./acts";
import { buttons } from "./buttons";

beforeEach(() => platform.ask.mockClear());

const RESUME: ErrorRemedy = { remedy: "resume-run", run: { job: null, port: null, wire: 0 } };
const PROSPECT = { program: true, feasible: true };
const state = machineState("stopped", "home", "resume-run");
const acts = (remedies: readonly ErrorRemedy[], of = state) => actsOf(remedies, of, buttons(of, PROSPECT));
const labels = (remedies: readonly ErrorRemedy[], of = state) => acts(remedies, of).acts.map(({ label }) => label);

it("offers what the window can do as a button, each once and with what follows, and leaves the rest to be said", () => {
  const found = acts([{ remedy: "home" }, { remedy: "cut-power" }, { remedy: "connect" }, { remedy: "connect-again" }]);
  expect(found.acts.map(({ label, consequence }) => [label, /\.$/.test(consequence)])).toEqual([
    ["Home", true],
    ["Connect again", true],
  ]);
  expect(found.others).toEqual([{ remedy: "cut-power" }]);
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
