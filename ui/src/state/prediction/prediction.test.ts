import { beforeEach, describe, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
vi.mock("../../platform", () => ({ platform: { ask }, Refused: class Refused extends Error {} }));

import type { Prediction } from "../../generated/responses";
import { useDesign } from "../design/design";
import { useFrame } from "../frame/frame";
import { movedFrame, smallFrame } from "../frame/testing";
import { useMachines } from "../machine/machines";
import { designState } from "../testing";
import {
  choosePrediction,
  forgetPrediction,
  noiseOf,
  noiseTaken,
  predict,
  predictedNow,
  stopPrediction,
  usePrediction,
} from "./prediction";

const found: Prediction = { noise: "typical", runs: 2000, wires: [], tolerance: null };
const errors = [
  { id: "none", name: "No errors" },
  { id: "typical", name: "Typical" },
];

beforeEach(() => {
  ask.mockReset();
  ask.mockResolvedValue({});
  forgetPrediction();
  choosePrediction({ noise: null, within: 1, shown: true });
  useFrame.setState({ choices: { errors, strut_builders: [] } });
  useDesign.setState({ ...smallFrame(), state: designState(), version: 1 });
});

describe("the errors that are taken", () => {
  it("are those that were chosen, else those of the machine, else the first that are errors", () => {
    const own = [...errors, { id: "mine", name: "Mine" }];
    expect(noiseTaken("mine", "mine", own)).toBe("mine");
    expect(noiseTaken(null, "mine", own)).toBe("mine");
    const machines = [
      { id: "kit", noise: "mine" },
      { id: "plain", noise: null },
    ];
    expect(noiseTaken(null, noiseOf(machines, "kit"), own)).toBe("mine");
    expect([noiseOf(machines, "plain"), noiseOf(machines, null), noiseOf(null, "kit")]).toEqual([null, null, null]);
    expect(noiseTaken("gone", "other", own)).toBe("typical");
    expect(noiseTaken(null, null, [])).toBeNull();
  });
});

describe("predicting", () => {
  it("asks with what was chosen, and shows the answer as long as nothing is changed", async () => {
    ask.mockResolvedValue({ found });
    choosePrediction({ within: 0.5 });
    await predict();
    expect(ask).toHaveBeenCalledWith("predict", { noise: "typical", runs: 2000, seed: 1, within_mm: 0.5 });
    expect(predictedNow()).toEqual(found);
    choosePrediction({ shown: false });
    expect(predictedNow()).toBeNull();
    choosePrediction({ shown: true });
    useDesign.setState({ ...movedFrame(), version: 2 });
    expect(predictedNow()).toBeNull();
  });

  it("shows the answer again once the design is as it was, or was changed in what has no part in it", async () => {
    ask.mockResolvedValue({ found });
    await predict();
    const { vertices } = smallFrame();
    const held = new Map(vertices).set(2, { id: 2, at: [0, 0, 100], support: true });
    for (const change of [{ state: designState({ reversed: true }) }, movedFrame()]) {
      useDesign.setState({ ...change, version: 2 });
      expect(predictedNow()).toBeNull();
      useDesign.setState({ ...smallFrame(), state: designState(), version: 3 });
      expect(predictedNow()).toEqual(found);
    }
    useDesign.setState({ vertices: held, state: designState({ notes: "for the wall" }), version: 4 });
    expect(predictedNow()).toEqual(found);
  });

  it("shows nothing of a profile before", async () => {
    ask.mockResolvedValue({ found });
    await predict();
    expect(predictedNow()).toEqual(found);
    useMachines.setState(({ changes }) => ({ changes: changes + 1 }));
    expect(predictedNow()).toBeNull();
  });

  it("has no answer where it was stopped, and says why where it failed", async () => {
    ask.mockResolvedValue({ found: null });
    await predict();
    expect(usePrediction.getState()).toMatchObject({ answer: null, asking: false, problem: null });
    ask.mockRejectedValue(new Error("there is no program"));
    await predict();
    expect(usePrediction.getState()).toMatchObject({ answer: null, asking: false, problem: "there is no program" });
  });

  it("leaves an answer aside that is of a design that was closed, and stops what is under way", async () => {
    let answer = (_: unknown) => {};
    ask.mockReturnValueOnce(new Promise((resolve) => (answer = resolve)));
    const predicted = predict();
    forgetPrediction();
    expect(ask).toHaveBeenLastCalledWith("stop-prediction", {});
    answer({ found });
    await predicted;
    expect(usePrediction.getState()).toMatchObject({ answer: null, asking: false });
    await stopPrediction();
  });
});
