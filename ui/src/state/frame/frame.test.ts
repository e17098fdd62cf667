import { beforeEach, describe, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
vi.mock("../../platform", () => ({ platform: { ask }, Refused: class Refused extends Error {} }));

import { useDesign } from "../design/design";
import { useMachines } from "../machine/machines";
import { usePlayback } from "../program/program";
import { designState } from "../testing";
import { extent, largest, movedOf, usualScale } from "./figures";
import {
  askTolerance,
  cancelFrame,
  chooseFrame,
  computeFrame,
  forgetFrame,
  isFrameStale,
  isToleranceStale,
  keepSupports,
  require,
  setPicking,
  toggleSupports,
  useFrame,
} from "./frame";
import { enlarge, showFrame, swingAt, toggleSwing, useShape } from "./shape";
import { frameShown, movedFrame, smallFrame } from "./testing";

beforeEach(() => {
  ask.mockReset();
  forgetFrame();
  chooseFrame({ material: null, errors: null, gravity: [0, 0, -1], modes: 6, double: false });
  require({ surface: null, force: null, stress: null, vary: "feed", continuum: null });
  usePlayback.setState({ played: null, live: false });
  useDesign.setState({ ...smallFrame(), state: designState(), version: 1 });
});

describe("computing a frame", () => {
  it("asks for what was chosen, and shows what it carries", async () => {
    ask.mockResolvedValue(frameShown());
    toggleSupports([2, 1]);
    chooseFrame({ hold: "chosen", modes: 3, bow: 0.03, errors: "bend-forming" });
    await computeFrame();
    expect(ask).toHaveBeenCalledWith("frame", {
      material: null,
      supports: { vertices: [1, 2] },
      gravity: [0, 0, -1],
      loads: null,
      forces: [],
      modes: 3,
      bow: { share: 0.03, seed: 1 },
      close: { errors: "bend-forming", closing: "aligned", runs: 100, seed: 1, faces: null },
      double: false,
    });
    expect(useShape.getState().view).toEqual({ kind: "loaded" });
  });

  it("leaves the view to a design that is changed while it is computed", async () => {
    ask.mockImplementation(async () => {
      useDesign.setState({ ...movedFrame(), version: 2 });
      return frameShown();
    });
    await computeFrame();
    expect(useFrame.getState().answer).not.toBeNull();
    expect(useShape.getState().view).toBeNull();
  });

  it("shows the first mode that bends of a frame that floats", async () => {
    const shown = frameShown();
    ask.mockResolvedValue({ ...shown, shapes: { ...shown.shapes, loaded: null } });
    chooseFrame({ hold: "free" });
    await computeFrame();
    expect(useShape.getState().view).toEqual({ kind: "mode", mode: 1 });
  });

  it("says why there is no answer, and shows the design", async () => {
    ask.mockRejectedValue(new Error("the material has no shear modulus"));
    await computeFrame();
    expect(useFrame.getState()).toMatchObject({
      answer: null,
      problem: "the material has no shear modulus",
      asking: false,
    });
    expect(useShape.getState().view).toBeNull();
  });

  it("is cancelled at once, and keeps what was computed before", async () => {
    ask.mockResolvedValue(frameShown());
    await computeFrame();
    const before = useFrame.getState().answer;
    let answer = (_: unknown) => {};
    ask.mockReturnValueOnce(new Promise((resolve) => (answer = resolve)));
    const computed = computeFrame();
    cancelFrame();
    expect(ask).toHaveBeenLastCalledWith("stop-frame", {});
    expect(useFrame.getState()).toMatchObject({ asking: false, cancelled: true, answer: before });
    answer(frameShown());
    await computed;
    expect(useFrame.getState()).toMatchObject({ cancelled: true, answer: before });
    await computeFrame();
    expect(useFrame.getState().cancelled).toBe(false);
  });

  it("leaves an answer aside that is of a design that was closed", async () => {
    let answer = (_: unknown) => {};
    ask.mockReturnValue(new Promise((resolve) => (answer = resolve)));
    const computed = computeFrame();
    forgetFrame();
    answer(frameShown());
    await computed;
    expect(useFrame.getState().answer).toBeNull();
  });
});

describe("supports", () => {
  it("are taken and let go, and go with their vertices", () => {
    setPicking(true);
    expect(useFrame.getState().hold).toBe("chosen");
    toggleSupports([0, 2]);
    toggleSupports([0]);
    expect([...useFrame.getState().chosen]).toEqual([2]);
    useDesign.setState({ vertices: new Map() });
    keepSupports();
    expect(useFrame.getState().chosen.size).toBe(0);
  });
});

const changeProfile = () => useMachines.setState(({ changes }) => ({ changes: changes + 1 }));

it("is of the design and the profiles as they were", async () => {
  ask.mockResolvedValue(frameShown());
  const move = () => useDesign.setState({ ...movedFrame(), version: 2 });
  for (const change of [move, changeProfile, () => chooseFrame({ modes: 2 })]) {
    await computeFrame();
    expect(isFrameStale()).toBe(false);
    change();
    expect(isFrameStale()).toBe(true);
  }
});

it("is of a design that was changed and is again as it was, and of one that was changed in what it does not depend on", async () => {
  ask.mockResolvedValue(frameShown());
  await computeFrame();
  const wall = smallFrame();
  const held = new Map(wall.vertices).set(2, { id: 2, at: [0, 0, 100], support: true });
  const heavy = new Map(wall.vertices).set(2, {
    id: 2,
    at: [0, 0, 100],
    support: false,
    joint: { kind: "solder", mass_g: 2 },
  });
  const edges = new Map(wall.edges).set(1, { id: 1, a: 0, b: 1 });
  for (const change of [movedFrame(), { vertices: held }, { vertices: heavy }, { edges }]) {
    useDesign.setState({ ...change, version: 2 });
    expect(isFrameStale()).toBe(true);
    useDesign.setState({ ...smallFrame(), version: 3 });
    expect(isFrameStale()).toBe(false);
  }
  useDesign.setState({ state: designState({ name: "B", reversed: true }), version: 4 });
  expect(isFrameStale()).toBe(false);
  // Its machine decides what the struts are of, where the design does not say it.
  useDesign.setState({ state: designState({ machine: "kit" }) });
  expect(isFrameStale()).toBe(true);
  // Wires that are closed run as the design says, and supports of the design do not count where others are chosen.
  chooseFrame({ errors: "typical", hold: "free" });
  await computeFrame();
  useDesign.setState({ vertices: held });
  expect(isFrameStale()).toBe(false);
  useDesign.setState({ state: designState({ machine: "kit", reversed: true }) });
  expect(isFrameStale()).toBe(true);
});

describe("the tolerance", () => {
  it("is of the profiles as they were", async () => {
    ask.mockResolvedValue({ governed_by: "force" });
    require({ force: 1 });
    await askTolerance();
    expect(isToleranceStale()).toBe(false);
    changeProfile();
    expect(isToleranceStale()).toBe(true);
  });

  it("asks for what is required", async () => {
    ask.mockResolvedValue({ material: "wire", governed_by: "force", achieved: {}, notes: [] });
    require({ force: 5, vary: "both" });
    await askTolerance();
    expect(ask).toHaveBeenCalledWith("tolerance", {
      material: null,
      required: { surface_mm: null, force_n: 5, stress_mpa: null },
      vary: "both",
      closing: "aligned",
      double: false,
      faces: null,
      continuum: null,
    });
    expect(useFrame.getState().tolerance?.value.governed_by).toBe("force");
  });
});

describe("a truss of closed formulas", () => {
  it("is asked for in place of the design, which may change", async () => {
    ask.mockResolvedValue({ material: "wire", governed_by: "surface", achieved: {}, notes: [] });
    const continuum = { rings: 408, depth_mm: 50, diameter_mm: 50_000 };
    chooseFrame({ faces: { file: "/there/faces.json" } });
    require({ surface: 1, continuum });
    await askTolerance();
    expect(ask).toHaveBeenCalledWith("tolerance", expect.objectContaining({ continuum, faces: null }));
    useDesign.setState({ ...movedFrame(), version: 2 });
    expect(isToleranceStale()).toBe(false);
  });
});

describe("what is shown", () => {
  it("gives way to a machine that bends a wire", () => {
    usePlayback.setState({ live: true });
    showFrame({ kind: "loaded" });
    expect(useShape.getState().view).toBeNull();
  });

  it("keeps its scale from mode to mode, and not from a mode to the loaded frame", () => {
    showFrame({ kind: "mode", mode: 0 });
    enlarge(30);
    showFrame({ kind: "mode", mode: 1 });
    expect(useShape.getState().scale).toBe(30);
    showFrame({ kind: "loaded" });
    expect(useShape.getState().scale).toBeNull();
  });

  it("swings modes alone", () => {
    showFrame({ kind: "loaded" });
    toggleSwing();
    expect(useShape.getState().swinging).toBe(false);
    showFrame({ kind: "mode", mode: 1 });
    toggleSwing();
    expect(useShape.getState().swinging).toBe(true);
    expect([0, 0.25, 0.5, 0.75, 1].map(swingAt)).toEqual([1, 0, -1, 0, 1]);
  });

  it("enlarges displacements to a small part of the frame, by a round factor", () => {
    const moved = movedOf(frameShown(), { kind: "loaded" });
    if (!moved) throw new Error("nothing is moved");
    expect(largest(moved.by)).toBe(0.5);
    expect(extent(moved.at)).toBeCloseTo(Math.hypot(100, 100));
    // 6 % of 141.4 mm is 8.5 mm, 17 times as much as 0.5 mm.
    expect(usualScale(moved)).toBe(10);
    expect(movedOf(frameShown(), { kind: "closed" })).toBeNull();
  });
});
