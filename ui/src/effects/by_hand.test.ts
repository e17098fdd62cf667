// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { ByHandResponse, MachineViewResponse, PlayedWire } from "../generated/responses";
import type { Played } from "../scene/interface";
import { useDesign } from "../state/design/design";
import { hearByHand, hideByHand, jogBy, useByHand } from "../state/machine/by_hand";
import { useMachines } from "../state/machine/machines";
import type { Move } from "../state/machine/operator";
import { useRun } from "../state/machine/run";
import { usePlayback } from "../state/program/program";
import { machineState } from "../state/testing";
import { together } from "./changes";
import { followDesign } from "./design";
import { followPlayback } from "./machine";

const VIEW = { id: "kit", shapes: [], pivot_mm: [12, 0, 0], peg_top_mm: 9 } as unknown as MachineViewResponse;
const program = (): Played => ({
  steps: [],
  designed: { corners: [], poses: [] },
  made: null,
  bodies: [],
  wireDiameter: 3,
  orbitOffset: 0,
  pegTop: 0,
});

/** What the Rust side has of moves: a step more for each that is done. */
let rust: ByHandResponse;
const stepByHand = (feed_mm: number): PlayedWire["steps"][number] => ({
  designed: { feed_mm, rotate_deg: 0, bend_deg: 0 },
  told: null,
  seconds: [0, 0, 0, 0],
  vertex: null,
  place: null,
  pause: null,
  edges: [],
  pose: { turn: [0, 1, 0, 0], bend_axis: [0, 0, 1], bend_deg: 0 },
  moments: [{ at: 1, fed: 1, bent: 1, head_deg: 0, bend_axis_deg: 0, peg_out: 0 }],
});
const wireOf = (steps: number): PlayedWire => ({
  bend_axis: [0, 0, 1],
  corners_mm: Array.from({ length: steps + 1 }, (_, k) => [k, 0, 0]),
  steps: Array.from({ length: steps }, () => stepByHand(1)),
  stock_mm: null,
  time_s: null,
});

const feed = (mm: number): Move => ({ move: "feed", mm });
const bend = (deg: number): Move => ({ move: "bend", deg });

describe("what is heard of a machine", () => {
  const state = (phase: Parameters<typeof machineState>[0]) => hearByHand({ event: "state", ...machineState(phase) });
  const settled = () => new Promise((resolve) => setTimeout(resolve));
  const jogged = async (made: Move) => {
    rust = { moves: rust.moves + 1, wire: wireOf(rust.moves + 1) };
    hearByHand({ event: "jogged", made });
    await settled();
  };
  const asked = (): number => platform.ask.mock.calls.filter(([name]) => name === "by-hand").length;
  const shown = (): number | undefined => useByHand.getState().played?.steps.length;

  let refuses = false;
  let end = () => {};
  beforeEach(() => {
    refuses = false;
    rust = { moves: 0, wire: wireOf(1) };
    platform.ask.mockReset().mockImplementation((name: string) => {
      if (name === "order" && refuses) return Promise.reject(new Error("no"));
      return name === "by-hand" ? Promise.resolve(rust) : new Promise(() => {});
    });
    useRun.setState({ state: { ...machineState("moving"), machine: "kit" } });
    useMachines.setState({ views: new Map([["kit", VIEW]]), machines: [], materials: [] });
    usePlayback.setState({ played: null, live: false });
    useByHand.setState({ moves: 0, played: null });
    end = together([followDesign(), followPlayback()]);
  });
  afterEach(() => end());

  it("is drawn move by move, and forgotten when it is homed or parted from", async () => {
    await jogged(feed(10));
    await jogged(bend(45));
    expect(useByHand.getState()).toMatchObject({ moves: 2, played: { orbitOffset: 12, pegTop: 9 } });
    expect(shown()).toBe(2);
    for (const end of [
      () => jogged({ move: "home" }),
      async () => state("homing"),
      async () => state("closed"),
      async () => state("making"),
    ]) {
      await jogged(feed(10));
      expect(shown()).toBeDefined();
      await end();
      expect(useByHand.getState()).toEqual({ moves: 0, played: null });
    }
  });

  it("stays drawn while the machine rests, and goes when something else is shown or the design is changed", async () => {
    await jogged(feed(10));
    state("ready");
    expect(shown()).toBe(1);
    usePlayback.setState({ played: program() });
    expect(shown()).toBeUndefined();
    await jogged(feed(10));
    expect(shown()).toBe(2);
    expect(usePlayback.getState().played).toBeNull();
    useDesign.setState({ vertices: new Map() });
    expect(shown()).toBeUndefined();
    hideByHand();
    await jogged(bend(20));
    expect(shown()).toBe(3);
  });

  it("is drawn while a move runs that was ordered here, as often as the machine reports where its axes are", async () => {
    const at = async (feed_mm: number) => {
      hearByHand({ event: "news", news: "position", feed_mm, rotate_deg: 0, bend_deg: 0 });
      await settled();
    };
    await at(100);
    expect(asked()).toBe(0);
    void jogBy([feed(20)], false);
    await at(105);
    await at(106);
    expect([asked(), shown()]).toEqual([2, 1]);
    await jogged(feed(20));
    // What was not ordered here, such as moves of a file, is drawn when it is done.
    await at(150);
    expect(asked()).toBe(3);
    for (const end of [hideByHand, () => state("ready"), () => state("stopped")]) {
      void jogBy([feed(20)], false);
      end();
      await at(160);
      expect(asked()).toBe(3);
    }
    refuses = true;
    await jogBy([feed(20)], false);
    await at(160);
    expect(asked()).toBe(3);
  });

  it("is drawn on when a second move is refused while the first runs, and not beyond its end", async () => {
    const at = async (feed_mm: number) => {
      hearByHand({ event: "news", news: "position", feed_mm, rotate_deg: 0, bend_deg: 0 });
      await settled();
    };
    void jogBy([feed(20)], false);
    await at(5);
    refuses = true;
    await jogBy([feed(20)], false);
    await at(10);
    expect(asked()).toBe(2);
    const second = jogBy([feed(20)], false);
    // The first is done before the second is refused.
    hearByHand({ event: "jogged", made: feed(20) });
    await second;
    await settled();
    expect(asked()).toBe(3);
    await at(20);
    expect(asked()).toBe(3);
  });

  it("is asked for once at a time, and once more for what was reported meanwhile", async () => {
    const answers: ((wire: ByHandResponse) => void)[] = [];
    platform.ask.mockImplementation((name: string) =>
      name === "by-hand" ? new Promise((resolve) => answers.push(resolve)) : new Promise(() => {}),
    );
    await jogged(feed(10));
    await jogged(feed(10));
    await jogged(feed(10));
    expect(asked()).toBe(1);
    answers[0]?.({ moves: 1, wire: wireOf(1) });
    await settled();
    expect([asked(), shown()]).toEqual([2, 1]);
    answers[1]?.({ moves: 3, wire: wireOf(3) });
    await settled();
    expect([asked(), shown()]).toEqual([2, 3]);
  });

  it("is not drawn when the answer comes after it was hidden or forgotten", async () => {
    for (const end of [hideByHand, () => state("homing")]) {
      let answer: (wire: ByHandResponse) => void = () => {};
      platform.ask.mockImplementation((name: string) =>
        name === "by-hand" ? new Promise((resolve) => (answer = resolve)) : new Promise(() => {}),
      );
      await jogged(feed(10));
      end();
      answer({ moves: 1, wire: wireOf(1) });
      await settled();
      expect(shown()).toBeUndefined();
    }
  });

  it("does not take the place of a wire that is being bent", async () => {
    usePlayback.setState({ played: program(), live: true });
    await jogged(feed(10));
    expect(shown()).toBeUndefined();
  });
});
