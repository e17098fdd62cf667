// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { ProgramResponse } from "../generated/responses";
import { useDesign } from "../state/design/design";
import type { MachineState } from "../state/machine/operator";
import { useRun } from "../state/machine/run";
import {
  chooseShown,
  endLive,
  forgetProgram,
  goTo,
  isUpToDate,
  lookAtArmed,
  makeProgram,
  show,
  showLive,
  showMade,
  simulate,
  togglePlay,
  usePlayback,
  useProgram,
} from "../state/program/program";
import { made, program, view, wire } from "../state/program/testing";
import { designState } from "../state/testing";
import { together } from "./changes";
import { followDesign } from "./design";
import { followPlayback } from "./machine";

const state = designState({ machine: "kit", material: "al", name: "U", next: [3, 2] });

let end = () => {};
beforeEach(() => {
  end = together([followDesign(), followPlayback()]);
  forgetProgram();
  endLive();
  useDesign.setState({ state, vertices: new Map(), edges: new Map(), check: null });
  platform.ask.mockReset();
  platform.ask.mockImplementation(async (ask: string) =>
    ask === "program" ? program : ask === "machine-view" ? view : ask === "made" ? made : null,
  );
});

afterEach(() => end());

/** What a machine reports of a wire of the job of `program`. */
const making = (steps: number, in_step = 0) => ({ job_hash: "a1", name: "U", wire: 0, made: steps, in_step });

const asked = (name: string): number => platform.ask.mock.calls.filter(([ask]) => ask === name).length;

describe("playback", () => {
  it("says of a wire that is armed whether it is of the design as it is, and shows nothing of it", async () => {
    const armed = { job_hash: "a1", name: "U" };
    await lookAtArmed(armed);
    expect(usePlayback.getState()).toMatchObject({ otherWire: null, played: null, live: false });
    platform.ask.mockImplementation(async (ask: string) =>
      ask === "program" ? { ...program, job_hash: "b2" } : ask === "machine-view" ? view : null,
    );
    useDesign.setState({ vertices: new Map() });
    await lookAtArmed(armed);
    expect(usePlayback.getState()).toMatchObject({ otherWire: "U", played: null, live: false });
    // A design of which no wire can be made has none that could be armed.
    platform.ask.mockRejectedValue(new Error("no route"));
    useDesign.setState({ vertices: new Map() });
    await lookAtArmed({ ...armed, job_hash: "b2" });
    expect(usePlayback.getState().otherWire).toBe("U");
  });

  it("goes back to a design that is edited while a machine is armed, and says that another wire is", async () => {
    useRun.setState({ state: { phase: "armed", wire: { job_hash: "a1", name: "U" } } as MachineState });
    await goTo(1);
    platform.ask.mockImplementation(async (ask: string) =>
      ask === "program" ? { ...program, job_hash: "b2" } : ask === "machine-view" ? view : null,
    );
    useDesign.setState({ vertices: new Map() });
    expect(usePlayback.getState().played).toBeNull();
    await vi.waitFor(() => expect(usePlayback.getState()).toMatchObject({ otherWire: "U", played: null }));
    // Where it pauses is a part of the job.
    platform.ask.mockImplementation(async (ask: string) =>
      ask === "program" ? program : ask === "machine-view" ? view : null,
    );
    useDesign.setState({ state: { ...state, pauses: [{ wire: 0, step: 1, text: "" }] as never } });
    await vi.waitFor(() => expect(usePlayback.getState().otherWire).toBeNull());
    useRun.setState({ state: null });
  });

  it("is as designed again with a new program, of which nobody knows yet how it is made", async () => {
    await goTo(1);
    await simulate();
    usePlayback.setState({ shown: "both" });
    useDesign.setState({ vertices: new Map() });
    expect(usePlayback.getState().played).toBeNull();
    await makeProgram();
    expect(usePlayback.getState().shown).toBe("designed");
  });

  it("shows the program as it is sent, with the peg's axis where the profile has it", async () => {
    await goTo(1);
    expect(usePlayback.getState()).toMatchObject({ step: 1, playing: false, live: false });
    expect(usePlayback.getState().played).toMatchObject({ orbitOffset: 12, pegTop: 9, wireDiameter: 3, made: null });
    const { played } = usePlayback.getState();
    expect(played?.designed.poses[0]).toEqual({ turn: [0, 1, 0, 0], bendAxis: [0, 0, 1], bend: 90 });
    expect(played?.steps[0]?.moments.at(-1)).toMatchObject({ head: 0, bendAxis: 110, pegOut: 1 });
  });

  it("goes back to the design when that is another one", async () => {
    await goTo(1);
    useDesign.setState({ vertices: new Map() });
    expect(usePlayback.getState().played).toBeNull();
  });

  it("adds how the machine bends it once that is asked for, and keeps the place", async () => {
    await goTo(1);
    expect(asked("made")).toBe(0);
    expect(await simulate()).toBe(true);
    expect(usePlayback.getState()).toMatchObject({ step: 1, played: { made: { corners: wire.corners_mm } } });
  });

  it("leaves the view to a machine whose program was on its way when a person wanted to play it", async () => {
    const shown = showLive(making(1));
    togglePlay();
    await Promise.all([goTo(0), shown]);
    expect(usePlayback.getState()).toMatchObject({ live: true, playing: false, step: 1 });
  });

  it("keeps the wire of a machine in the view where the design is changed before its program is there", async () => {
    const shown = showLive(making(0));
    useDesign.setState({ vertices: new Map() });
    await Promise.all([showLive(making(1)), shown]);
    await showLive(making(1));
    expect(usePlayback.getState()).toMatchObject({ live: true, otherWire: null, step: 1 });
    expect(asked("program")).toBe(1);
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

  it("plays the program of the design as it is, also where it is changed while that is made", async () => {
    platform.ask.mockImplementationOnce(async () => {
      useDesign.setState({ vertices: new Map() });
      return program;
    });
    await goTo(1);
    expect(usePlayback.getState().played).not.toBeNull();
    expect(isUpToDate()).toBe(true);
    expect(asked("program")).toBe(2);
  });

  it("shows what was chosen last, once it is known how the machine bends it", async () => {
    await goTo(1);
    let known = () => {};
    platform.ask.mockImplementation((ask: string) =>
      ask === "made" ? new Promise((done) => (known = () => done(made))) : Promise.resolve(null),
    );
    const [one, other] = [chooseShown("made"), chooseShown("both")];
    await vi.waitFor(() => expect(asked("made")).toBe(1));
    known();
    await Promise.all([one, other]);
    expect(usePlayback.getState().shown).toBe("both");
    expect(asked("made")).toBe(1);
  });

  it("asks anew how the machine bends a design that was changed meanwhile", async () => {
    await goTo(1);
    const answers: (() => void)[] = [];
    platform.ask.mockImplementation((ask: string) =>
      ask === "made"
        ? new Promise((done) => answers.push(() => done(made)))
        : Promise.resolve(ask === "program" ? program : view),
    );
    const before = chooseShown("made");
    await vi.waitFor(() => expect(answers).toHaveLength(1));
    useDesign.setState({ vertices: new Map() });
    const after = chooseShown("made");
    await vi.waitFor(() => expect(answers).toHaveLength(2));
    for (const answer of answers) answer();
    await Promise.all([before, after]);
    expect(usePlayback.getState().shown).toBe("made");
    expect(useProgram.getState()).toMatchObject({ made, askingMade: false });
  });

  it("follows a machine, and is not moved by a person meanwhile", async () => {
    await showLive(making(1));
    expect(usePlayback.getState()).toMatchObject({ live: true, step: 1 });
    await goTo(0);
    expect(usePlayback.getState()).toMatchObject({ live: true, step: 1 });
    await showLive(making(9));
    expect(usePlayback.getState().step).toBe(2);
  });

  it("follows it within a step, and stays there when it is stopped", async () => {
    await showLive(making(0, 1 / 12));
    expect(usePlayback.getState()).toMatchObject({ live: true, step: 1 / 12 });
    endLive();
    expect(usePlayback.getState().step).toBeCloseTo(1 / 12);
  });

  it("goes to the end with a wire that is made, and nowhere for a person who looks at another step", async () => {
    await showLive(making(1, 0.98));
    endLive();
    showMade();
    expect(usePlayback.getState().step).toBe(2);
    await goTo(0);
    showMade();
    expect(usePlayback.getState().step).toBe(0);
  });

  it("does not show another design as the one that a machine bends, and says which design's wire it is", async () => {
    await showLive(making(1));
    forgetProgram();
    platform.ask.mockImplementation(async (ask: string) => (ask === "program" ? { ...program, job_hash: "b2" } : view));
    await showLive(making(2));
    expect(usePlayback.getState()).toMatchObject({ played: null, live: false, otherWire: "U" });
    endLive();
    expect(usePlayback.getState().otherWire).toBeNull();
  });

  it("does not show a design that was changed meanwhile as the one that a machine bends", async () => {
    await showLive(making(1));
    platform.ask.mockImplementation(async (ask: string) => (ask === "program" ? { ...program, job_hash: "b2" } : view));
    useDesign.setState({ vertices: new Map() });
    await makeProgram();
    await showLive(making(1));
    expect(usePlayback.getState()).toMatchObject({ played: null, live: false, otherWire: "U" });
  });

  it("follows the machine again once the design is again the one that was armed", async () => {
    platform.ask.mockImplementation(async (ask: string) => (ask === "program" ? { ...program, job_hash: "b2" } : view));
    await showLive(making(1));
    expect(usePlayback.getState().live).toBe(false);
    platform.ask.mockImplementation(async (ask: string) => (ask === "program" ? program : view));
    useDesign.setState({ vertices: new Map() });
    await showLive(making(2));
    expect(usePlayback.getState()).toMatchObject({ live: true, otherWire: null, step: 2 });
  });

  it("says so of a design that nothing can be made of, too", async () => {
    platform.ask.mockRejectedValue(new Error("There are no edges."));
    await showLive(making(1));
    expect(usePlayback.getState()).toMatchObject({ live: false, otherWire: "U" });
  });

  it("is not live for ever when the wire ends while its program is asked for", async () => {
    let answer: (program: ProgramResponse) => void = () => {};
    platform.ask.mockImplementation((ask: string) =>
      ask === "program" ? new Promise((resolve) => (answer = resolve)) : Promise.resolve(view),
    );
    const shown = showLive(making(1));
    endLive();
    answer(program);
    await shown;
    expect(usePlayback.getState()).toMatchObject({ live: false, otherWire: null });
  });
});
