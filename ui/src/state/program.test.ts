// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { MachineViewResponse, MadeResponse, PlayedWire, ProgramResponse } from "../generated/responses";
import { useDesign } from "./design";
import { endLive, forgetProgram, goTo, isUpToDate, makeProgram, show, showLive, simulate, usePlayback, useProgram } from "./program";
import { designState } from "./testing";

const step = (feed: number, bend: number): PlayedWire["steps"][number] => ({
  designed: { feed_mm: feed, rotate_deg: 0, bend_deg: bend },
  told: { feed_mm: feed, rotate_deg: 0, bend_deg: bend + 20 },
  seconds: [1, 0, 4, 1],
  vertex: null,
  edges: [],
});

const wire: PlayedWire = {
  bend_axis: [0, 0, 1],
  corners_mm: [
    [0, 0, 0],
    [30, 0, 0],
    [30, 30, 0],
  ],
  steps: [step(30, 90), step(30, 0)],
  stock_mm: 460,
  time_s: 12,
};
const program: ProgramResponse = { job_hash: "a1", diameter_mm: 3, feasible: true, machine: "kit", material: "al", wires: [wire], without: 0 };
const view = { id: "kit", shapes: [], pivot_mm: [12, 0, 0] } as unknown as MachineViewResponse;
const made: MadeResponse = { by_machine: true, notes: [], wires: [{ corners_mm: wire.corners_mm, wire_mm: [], deviations_mm: [0, 0.1, 0.2], worst_mm: 0.2 }] };
const state = designState({ machine: "kit", material: "al", name: "U", next: [3, 2] });

beforeEach(() => {
  forgetProgram();
  endLive();
  useDesign.setState({ state, vertices: new Map(), edges: new Map(), check: null });
  platform.ask.mockReset();
  platform.ask.mockImplementation(async (ask: string) => (ask === "program" ? program : ask === "machine-view" ? view : ask === "made" ? made : null));
});

/** What a machine tells of a wire of the job of `program`. */
const making = (steps: number) => ({ job_hash: "a1", name: "U", wire: 0, made: steps });

const asked = (name: string): number => platform.ask.mock.calls.filter(([ask]) => ask === name).length;

describe("makeProgram", () => {
  it("asks once for the same design, and again for another", async () => {
    expect(await makeProgram()).toBe(true);
    expect(await makeProgram()).toBe(true);
    expect(asked("program")).toBe(1);
    useDesign.setState({ vertices: new Map() });
    expect(isUpToDate()).toBe(false);
    await makeProgram();
    expect(asked("program")).toBe(2);
  });

  it("takes a design for the same when only its notes or its file have changed", async () => {
    await makeProgram();
    useDesign.setState({ state: { ...state, notes: "for Ada", file: "/there/u.wirebend", changed: false } });
    expect(isUpToDate()).toBe(true);
    useDesign.setState({ state: { ...state, doublings: [1] } });
    expect(isUpToDate()).toBe(false);
  });

  it("keeps why there is none", async () => {
    platform.ask.mockRejectedValue(new Error("No machine is chosen."));
    expect(await makeProgram()).toBe(false);
    expect(useProgram.getState()).toMatchObject({ program: null, problem: "No machine is chosen.", asking: false });
  });
});

describe("playback", () => {
  it("shows the program as it is told, with the peg's axis where the profile has it", async () => {
    await goTo(1);
    expect(usePlayback.getState()).toMatchObject({ step: 1, playing: false, live: false });
    expect(usePlayback.getState().played).toMatchObject({ orbitOffset: 12, wireDiameter: 3, made: null });
    expect(usePlayback.getState().played?.steps[0]).toMatchObject({ bend: 90, bendAxis: 110 });
  });

  it("goes back to the design when that is another one", async () => {
    await goTo(1);
    useDesign.setState({ vertices: new Map() });
    expect(usePlayback.getState().played).toBeNull();
  });

  it("adds how the machine makes it once somebody asks, and keeps the place", async () => {
    await goTo(1);
    expect(asked("made")).toBe(0);
    expect(await simulate()).toBe(true);
    expect(usePlayback.getState()).toMatchObject({ step: 1, played: { made: wire.corners_mm } });
  });

  it("keeps what is played while a person slides, so that the machine is not built anew at every place", async () => {
    await goTo(0);
    const { played } = usePlayback.getState();
    show(0.5);
    show(1);
    expect(usePlayback.getState()).toMatchObject({ step: 1 });
    expect(usePlayback.getState().played).toBe(played);
    await simulate();
    expect(usePlayback.getState().played).not.toBe(played);
  });

  it("follows a machine, and is not moved by a person meanwhile", async () => {
    await showLive(making(1), null);
    expect(usePlayback.getState()).toMatchObject({ live: true, step: 1 });
    await goTo(0);
    expect(usePlayback.getState()).toMatchObject({ live: true, step: 1 });
    await showLive(making(9), null);
    expect(usePlayback.getState().step).toBe(2);
  });

  it("follows it within a step, and stays there when it is stopped", async () => {
    const fed = (feed_mm: number) => ({ feed_mm, rotate_deg: 0, bend_deg: 0 });
    await showLive(making(0), fed(0));
    await showLive(making(0), fed(15));
    // Half of the feed, which is one of six seconds.
    expect(usePlayback.getState().step).toBeCloseTo(1 / 12);
    endLive();
    expect(usePlayback.getState().step).toBeCloseTo(1 / 12);
  });

  it("does not show another design as the one that a machine makes, and says whose wire it is", async () => {
    await showLive(making(1), null);
    forgetProgram();
    platform.ask.mockImplementation(async (ask: string) => (ask === "program" ? { ...program, job_hash: "b2" } : view));
    await showLive(making(2), null);
    expect(usePlayback.getState()).toMatchObject({ played: null, live: false, otherWire: "U" });
    endLive();
    expect(usePlayback.getState().otherWire).toBeNull();
  });

  it("does not show a design that was changed meanwhile as the one that a machine makes", async () => {
    await showLive(making(1), null);
    platform.ask.mockImplementation(async (ask: string) => (ask === "program" ? { ...program, job_hash: "b2" } : view));
    useDesign.setState({ vertices: new Map() });
    await makeProgram();
    await showLive(making(1), null);
    expect(usePlayback.getState()).toMatchObject({ played: null, live: false, otherWire: "U" });
  });

  it("follows the machine again once the design is again the one that was armed", async () => {
    platform.ask.mockImplementation(async (ask: string) => (ask === "program" ? { ...program, job_hash: "b2" } : view));
    await showLive(making(1), null);
    expect(usePlayback.getState().live).toBe(false);
    platform.ask.mockImplementation(async (ask: string) => (ask === "program" ? program : view));
    useDesign.setState({ vertices: new Map() });
    await showLive(making(2), null);
    expect(usePlayback.getState()).toMatchObject({ live: true, otherWire: null, step: 2 });
  });

  it("says so of a design that nothing can be made of, too", async () => {
    platform.ask.mockRejectedValue(new Error("There are no edges."));
    await showLive(making(1), null);
    expect(usePlayback.getState()).toMatchObject({ live: false, otherWire: "U" });
  });

  it("is not live for ever when the wire ends while its program is asked for", async () => {
    let answer: (program: ProgramResponse) => void = () => {};
    platform.ask.mockImplementation((ask: string) => (ask === "program" ? new Promise((resolve) => (answer = resolve)) : Promise.resolve(view)));
    const shown = showLive(making(1), null);
    endLive();
    answer(program);
    await shown;
    expect(usePlayback.getState()).toMatchObject({ live: false, otherWire: null });
  });
});
