// @vitest-environment happy-dom
import { type Quaternion, Vector3 } from "three";
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { MachineViewResponse } from "../generated/responses";
import { machineState } from "./testing";
import programs from "../scene/fixtures/programs.json";
import type { Played, PlayedStep, Vec3 } from "../scene/interface";
import { type Run, runs } from "../scene/poses";
import { beginMove, hearByHand, hideByHand, playedByHand, stepsOf, useByHand } from "./by_hand";
import { useDesign } from "./design";
import { useMachines } from "./machines";
import type { Move } from "./operator";
import { usePlayback } from "./program";
import { useRun } from "./run";

const VIEW = { id: "kit", shapes: [], pivot_mm: [12, 0, 0] } as unknown as MachineViewResponse;
const byHand = (moves: readonly Move[]): Played => playedByHand(moves, VIEW, 3);

const feed = (mm: number): Move => ({ move: "feed", mm });
const rotate = (deg: number): Move => ({ move: "rotate", deg });
const bend = (deg: number): Move => ({ move: "bend", deg });

/** Corners and ends of the wire in the frame of the machine, where `run` begins: the end that was made first is the first of them. */
function atBeginning(path: readonly Vec3[], run: Run): Vector3[] {
  return seenFrom(path, run.first, run.turn);
}
/** The same where it ends. */
function atEnd(path: readonly Vec3[], run: Run): Vector3[] {
  return seenFrom(path, run.last, run.turn);
}
function seenFrom(path: readonly Vec3[], end: number, turn: Quaternion): Vector3[] {
  const origin = new Vector3(...(path[end] ?? [0, 0, 0]));
  return path.slice(0, end + 1).map((at) => new Vector3(...at).sub(origin).applyQuaternion(turn));
}

/** A hair of feed stands for none, and the corners of a path are not always those of its wire. */
const NEAR = 2e-3;

describe.each(programs.flatMap(({ name, path_mm, program, schedule }) => [["program", program] as const, ["schedule", schedule] as const].map(([kind, steps]) => ({ name: `${name}, ${kind}`, path: path_mm as unknown as Vec3[], steps: steps as number[][] }))))(
  "$name, moved by hand",
  ({ path, steps }) => {
    const shown = runs(
      path,
      steps.map(([feed = 0, rotate = 0, bend = 0]): PlayedStep => ({ feed, rotate, bend, bendAxis: bend, seconds: [0, 0, 0, 0] })),
    );
    const moves = steps.map(([mm = 0, turn = 0, angle = 0]) => [feed(mm), rotate(turn), bend(angle)]);

    it("is after each bend, and at the end, the wire that showing the program has there, on a head that is turned as far", () => {
      shown.forEach((run, k) => {
        const last = k === shown.length - 1;
        const made = byHand(moves.slice(0, last ? k + 1 : k).flat());
        const own = runs(made.path, made.steps);
        const now = own.at(-1)!;
        const [mine, theirs] = [atEnd(made.path, now), last ? atEnd(path, run) : atBeginning(path, run)];
        // The corners of the wire; a path may have more points than those.
        const ends = [...shown.slice(0, k).map(({ first }) => first), run.first, ...(last ? [run.last] : [])];
        ends.forEach((point, at) => expect(mine[at]!.distanceTo(theirs[point]!)).toBeLessThan(NEAR));
        expect(now.headAfter).toBeCloseTo(last ? run.headAfter : run.headBefore, 9);
      });
    });
  },
);

describe("moves in any order", () => {
  const ends = (moves: readonly Move[]) => {
    const { path, steps } = byHand(moves);
    const last = runs(path, steps).at(-1)!;
    return atEnd(path, last).map((at) => at.toArray().map((part) => Math.round(part * 100) / 100 + 0));
  };

  it("feed and rotate between bends as if they were one of each", () => {
    expect(ends([feed(10), rotate(30), feed(20), rotate(60), bend(90), feed(5)])).toEqual(ends([feed(30), rotate(90), bend(90), feed(5)]));
  });

  it("draw the wire back as far as its last bend", () => {
    expect(ends([feed(30), bend(90), feed(20), feed(-5)])).toEqual(ends([feed(30), bend(90), feed(15)]));
    expect(ends([feed(30), bend(90), feed(-5)])).toEqual(ends([feed(30), bend(90)]));
  });

  it("bend twice at one place, the second time to the side that the head was turned to", () => {
    // Out along +x, 90° to +y; turned by 90° the head's z is +y, about which what lies along +y stays.
    expect(ends([feed(10), bend(90)])[0]).toEqual([0, 10, 0]);
    expect(ends([feed(10), bend(90), rotate(90), bend(90)])[0]).toEqual([0, 10, 0]);
    expect(ends([feed(10), bend(90), bend(45)])[0]).toEqual([-7.07, 7.07, 0]);
  });

  it("begin with nothing", () => {
    expect(stepsOf([]).length).toBe(1);
    expect(ends([rotate(45)])[0]).toEqual([0, 0, 0]);
  });
});

describe("what is heard of a machine", () => {
  const state = (phase: Parameters<typeof machineState>[0]) => hearByHand({ event: "state", ...machineState(phase) });
  const jogged = async (made: Move) => {
    hearByHand({ event: "jogged", made });
    await vi.waitFor(() => undefined);
  };
  const shown = (): number | undefined => useByHand.getState().played?.steps.length;

  beforeEach(() => {
    platform.ask.mockReset().mockReturnValue(new Promise(() => {}));
    useRun.setState({ state: { ...machineState("moving"), machine: "kit" } });
    useMachines.setState({ views: new Map([["kit", VIEW]]), machines: [], materials: [] });
    usePlayback.setState({ played: null, live: false });
    useByHand.setState({ moves: [], played: null, step: 0 });
  });

  it("is drawn move by move, and forgotten when it is homed or parted from", async () => {
    await jogged(feed(10));
    await jogged(bend(45));
    expect(shown()).toBe(2);
    for (const end of [() => jogged({ move: "home" }), async () => state("homing"), async () => state("closed"), async () => state("making")]) {
      await jogged(feed(10));
      expect(shown()).toBeDefined();
      await end();
      expect(useByHand.getState()).toEqual({ moves: [], played: null, step: 0 });
    }
  });

  it("stays drawn while the machine rests, and goes when something else is shown or the design is changed", async () => {
    await jogged(feed(10));
    state("ready");
    expect(shown()).toBe(1);
    usePlayback.setState({ played: byHand([feed(1)]) });
    expect(shown()).toBeUndefined();
    await jogged(feed(10));
    expect(shown()).toBe(1);
    expect(usePlayback.getState().played).toBeNull();
    useDesign.setState({ vertices: new Map() });
    expect(shown()).toBeUndefined();
    hideByHand();
    await jogged(bend(20));
    expect(stepsOf(useByHand.getState().moves)[0]).toEqual({ feed: 20, rotate: 0, bend: 20 });
    expect(shown()).toBe(2);
  });

  it("is drawn while it is made, as far as the machine tells where its axes are", async () => {
    const at = async (feed_mm: number, rotate_deg: number, bend_deg: number) => {
      hearByHand({ event: "news", news: "position", feed_mm, rotate_deg, bend_deg });
      await new Promise((resolve) => setTimeout(resolve));
      const { played, step } = useByHand.getState();
      return { step, steps: played?.steps.map(({ feed, bend, bendAxis }) => [feed, bend, bendAxis]) };
    };
    useRun.setState({ state: { ...machineState("moving"), machine: "kit", position: { feed_mm: 100, rotate_deg: 0, bend_deg: 0 } } });
    await jogged(feed(10));
    beginMove(feed(20));
    expect(await at(105, 0, 0)).toEqual({ step: 1, steps: [[15, 0, 0]] });
    await jogged(feed(20));
    expect(useByHand.getState().played?.steps[0]?.feed).toBe(30);
    useRun.setState(({ state }) => ({ state: state && { ...state, position: { feed_mm: 120, rotate_deg: 0, bend_deg: 0 } } }));
    beginMove(bend(-60));
    // The peg comes from the other side, bends, and goes back: the wire stays as it is.
    expect(await at(120, 0, 12)).toEqual({ step: 1, steps: [[30, 0, 0]] });
    const hair = [1e-3, 0, 0];
    expect(await at(120, 0, -30)).toEqual({ step: 0.5, steps: [[30, -30, -30], hair] });
    expect(await at(120, 0, -15)).toEqual({ step: 0.5, steps: [[30, -30, -15], hair] });
    // What was not ordered here, such as moves of a file, is drawn when it is made.
    await jogged(bend(-60));
    expect(await at(150, 0, 0)).toEqual({ step: 2, steps: [[30, -60, -60], hair] });
  });

  it("does not take the place of a wire that is being made", async () => {
    usePlayback.setState({ played: byHand([feed(1)]), live: true });
    await jogged(feed(10));
    expect(shown()).toBeUndefined();
  });
});
