// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { tell, useProblems } from "../asking/problems";
import { machineState } from "../testing";
import type { MachineState, Question } from "./operator";
import { answer, connect, hearOperator, isBending, isOpen, loadPorts, order, stop, useRun } from "./run";

const state = (given: Partial<MachineState> = {}): MachineState => ({
  ...machineState("ready", "home"),
  port: "sim",
  simulated: true,
  ...given,
});

beforeEach(() => {
  vi.useFakeTimers();
  useRun.setState({
    state: null,
    between: false,
    question: null,
    console: [],
    recorded: [],
    ended: null,
    ordering: false,
  });
  useProblems.setState({ problems: [] });
  platform.ask.mockReset();
});
afterEach(() => {
  vi.useRealTimers();
});

describe("hearOperator", () => {
  it("takes the state, and what changes of it between", () => {
    hearOperator({ event: "state", ...state({ phase: "moving" }) });
    hearOperator({ event: "news", news: "position", feed_mm: 10, rotate_deg: 90, bend_deg: 0 });
    expect(useRun.getState().state).toMatchObject({
      phase: "moving",
      position: { feed_mm: 10, rotate_deg: 90, bend_deg: 0 },
    });
    expect(useRun.getState().state).not.toHaveProperty("event");
  });

  it("takes a row of pieces for one run, until its order is done or something stops it", () => {
    const hear = (phase: MachineState["phase"], busy: boolean) => {
      hearOperator({ event: "state", ...state({ phase, busy }) });
      return isBending(useRun.getState());
    };
    // A move by hand is no row.
    expect([hear("armed", false), hear("ready", false), hear("moving", true)]).toEqual([false, false, false]);
    const row = [hear("making", true), hear("moving", true), hear("ready", true), hear("homing", true)];
    expect(row).toEqual([true, true, true, true]);
    expect([hear("making", true), hear("holding", true), hear("moving", true)]).toEqual([true, true, true]);
    expect([hear("ready", false), hear("moving", true)]).toEqual([false, false]);
    expect([hear("making", true), hear("moving", true), hear("stopping", true)]).toEqual([true, true, false]);
    expect(hear("stopped", true)).toBe(false);
  });

  it("does not go back to the state of an answer that a newer one has overtaken", async () => {
    platform.ask.mockImplementation(async () => {
      await Promise.resolve();
      hearOperator({ event: "state", ...state({ phase: "homing", busy: true }) });
      return { state: state({ phase: "connected", busy: true }) };
    });
    await order({ order: "home" });
    expect(useRun.getState().state?.phase).toBe("homing");
    platform.ask.mockResolvedValue({ state: state({ phase: "ready" }) });
    await order({ order: "home" });
    expect(useRun.getState().state?.phase).toBe("ready");
  });

  it("takes back what it said of a connection when the machine is connected again", async () => {
    platform.ask.mockResolvedValue({ state: state({ phase: "ready" }) });
    hearOperator({ event: "stopped", by: "end-of-driver", driver_ended: true, took_ms: 0 });
    tell("warning", "of something else", "other", true);
    const codes = () => useProblems.getState().problems.map(({ code }) => code);
    expect(codes()).toContain("driver-ended");
    await connect("/dev/ttyUSB0");
    expect(codes()).toEqual(["other"]);
    vi.advanceTimersByTime(100);
  });

  it("has a stop among the lines, at the time at which it was pressed", () => {
    hearOperator({ event: "news", news: "console", to_machine: true, text: "M1" });
    hearOperator({ event: "stopped", by: "host", driver_ended: false, took_ms: 100 });
    vi.advanceTimersByTime(100);
    const [stopped, line] = useRun.getState().console;
    expect(stopped).toMatchObject({ toMachine: true, text: "STOP pressed: sent past the driver" });
    expect((line?.at ?? 0) - (stopped?.at ?? 0)).toBe(100);
    // Nothing went to a machine whose driver was ended.
    hearOperator({ event: "stopped", by: "end-of-driver", driver_ended: false, took_ms: 0 });
    vi.advanceTimersByTime(100);
    expect(useRun.getState().console.at(-1)).toMatchObject({ toMachine: null });
  });

  it("collects lines of the console for a moment, in their order", () => {
    hearOperator({ event: "news", news: "console", to_machine: true, text: "M1" });
    hearOperator({ event: "news", news: "console", to_machine: false, text: "ok" });
    expect(useRun.getState().console).toEqual([]);
    vi.runAllTimers();
    expect(useRun.getState().console.map(({ text }) => text)).toEqual(["M1", "ok"]);
  });

  it("shows a question until it is answered, wherever it is answered, and not one that another has replaced", () => {
    hearOperator({
      event: "question",
      id: 7,
      kind: "move",
      lines: [],
      question: "May it move?",
      doubt: null,
      head: null,
    });
    expect(useRun.getState().question?.id).toBe(7);
    hearOperator({ event: "answered", id: 6, answer: "no" });
    expect(useRun.getState().question?.id).toBe(7);
    hearOperator({ event: "answered", id: 7, answer: "yes" });
    expect(useRun.getState().question).toBeNull();
  });

  it("takes the question that a state has, and that it has none", () => {
    const question: Question = { id: 8, kind: "arm", lines: ["5 steps"], question: "Arm?", doubt: null, head: null };
    hearOperator({ event: "state", ...state({ question }) });
    expect(useRun.getState().question?.id).toBe(8);
    hearOperator({ event: "state", ...state({ question: null }) });
    expect(useRun.getState().question).toBeNull();
  });

  it("shows problems and warnings to the person", () => {
    hearOperator({ event: "problem", code: "no-answer", message: "It does not answer." });
    hearOperator({ event: "news", news: "warning", code: "slow", message: "It is slow." });
    expect(useProblems.getState().problems.map(({ severity, code }) => [severity, code])).toEqual([
      ["error", "no-answer"],
      ["warning", "slow"],
    ]);
  });
});

describe("orders", () => {
  it("takes the state that comes back; a refusal is shown and changes nothing", async () => {
    platform.ask.mockResolvedValueOnce({ state: state({ phase: "homing" }) });
    expect(await order({ order: "home" })).toBe(true);
    expect(useRun.getState()).toMatchObject({ ordering: false, state: { phase: "homing" } });
    platform.ask.mockRejectedValueOnce(new Error("Wait until it is homed."));
    expect(await order({ order: "start" })).toBe(false);
    expect(useRun.getState()).toMatchObject({ ordering: false, state: { phase: "homing" } });
    expect(useProblems.getState().problems[0]?.message).toBe("Wait until it is homed.");
  });

  it("answers a question by its number", async () => {
    platform.ask.mockResolvedValueOnce({ state: state() });
    await answer(7, "not-made");
    expect(platform.ask).toHaveBeenCalledWith("answer", { question: 7, answer: "not-made" });
  });

  it("stops without waiting for an order that is on its way", () => {
    platform.ask.mockReturnValueOnce(new Promise(() => {}));
    void order({ order: "home" });
    stop();
    expect(platform.stop).toHaveBeenCalledOnce();
  });
});

describe("isOpen", () => {
  it("is so while there may be something to stop", () => {
    expect(isOpen(null)).toBe(false);
    expect(isOpen(state({ phase: "connecting" }))).toBe(true);
    expect(isOpen(state({ phase: "failed" }))).toBe(true);
    expect(isOpen(state({ phase: "closed" }))).toBe(false);
  });
});

it("shows the ports of the machine that was asked for last, whichever answer comes last", async () => {
  const answers: ((ports: unknown) => void)[] = [];
  platform.ask.mockImplementation(() => new Promise((resolve) => answers.push(resolve)));
  const asked = [loadPorts(), loadPorts()];
  answers[1]?.({ ports: [{ port: "/dev/ttyUSB1" }], problems: [] });
  answers[0]?.({ ports: [{ port: "/dev/ttyUSB0" }], problems: ["A driver did not answer."] });
  await Promise.all(asked);
  expect(useRun.getState()).toMatchObject({ ports: [{ port: "/dev/ttyUSB1" }], portProblem: null });
});
