import { beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
vi.mock("../../platform", () => ({ platform: { ask }, Refused: class Refused extends Error {} }));

import { useDesign } from "../design/design";
import { showFrame, useShape } from "../frame/shape";
import { movedFrame, smallFrame } from "../frame/testing";
import { useMachines } from "../machine/machines";
import { usePlayback } from "../program/program";
import { designState } from "../testing";
import { advanced } from "./clock";
import {
  cancelSequence,
  chooseBuilder,
  chooseGroups,
  findSequence,
  forgetSequence,
  hideSequence,
  isSequenceStale,
  moveStep,
  slideTo,
  stepAt,
  takeBackMoves,
  togglePlaySequence,
  useSequence,
} from "./sequence";
import { sequenceDrawn } from "./testing";

beforeEach(() => {
  ask.mockReset();
  ask.mockResolvedValue(sequenceDrawn());
  forgetSequence();
  chooseBuilder("builder");
  showFrame(null);
  usePlayback.setState({ played: null, live: false });
  useDesign.setState({ ...smallFrame(), state: designState(), version: 1 });
});

it("finds a sequence, and shows all of it built in place of a frame", async () => {
  showFrame({ kind: "loaded" });
  await findSequence("abs");
  expect(ask).toHaveBeenCalledWith("sequence", {
    machine: "builder",
    material: "abs",
    epsilon_mm: null,
    group_by: "edge",
  });
  expect(useSequence.getState()).toMatchObject({ shown: true, at: 2, problem: null });
  expect(useShape.getState().view).toBeNull();
});

it("is of the design, the builder and the profiles as they were", async () => {
  const changes = [
    () => useDesign.setState({ ...movedFrame(), version: 2 }),
    () => useMachines.setState(({ changes }) => ({ changes: changes + 1 })),
    () => chooseBuilder("other"),
  ];
  for (const change of changes) {
    await findSequence("abs");
    expect(isSequenceStale()).toBe(false);
    change();
    expect(isSequenceStale()).toBe(true);
  }
});

it("is of a design that is again as it was, and asks for the walks of wires only where these are placed", async () => {
  await findSequence("abs");
  const { vertices, edges } = smallFrame();
  const last = { id: 0, a: 0, b: 2, ceiling: true };
  const ceiling = new Map(edges).set(0, last);
  const held = new Map(vertices).set(2, { id: 2, at: [0, 0, 100], support: true });
  const clip = { kind: "snap-fit", mass_g: 5 } as const;
  const heavy = new Map(vertices).set(2, { id: 2, at: [0, 0, 100], support: false, joint: clip });
  for (const change of [movedFrame(), { edges: ceiling }, { vertices: held }, { vertices: heavy }]) {
    useDesign.setState({ ...change, version: 2 });
    expect(isSequenceStale()).toBe(true);
    useDesign.setState({ vertices, edges, version: 3 });
    expect(isSequenceStale()).toBe(false);
  }
  const walks = designState({ walks: [{ start: 0, edges: [0, 1] }] });
  useDesign.setState({ state: walks });
  expect(isSequenceStale()).toBe(false);
  chooseGroups("wire");
  await findSequence("abs");
  useDesign.setState({ state: designState() });
  expect(isSequenceStale()).toBe(true);
  chooseGroups("edge");
});

it("shows nothing of a search that has found none, or was refused", async () => {
  const none = sequenceDrawn([]);
  ask.mockResolvedValue({ ...none, stopped: true });
  await findSequence("abs");
  expect(useSequence.getState()).toMatchObject({ shown: false, found: { stopped: true } });
  ask.mockRejectedValue(new Error("no such machine"));
  await findSequence("abs");
  expect(useSequence.getState()).toMatchObject({ shown: false, found: null, problem: "no such machine" });
});

it("is cancelled at once, keeps what was found before, and leaves the answer aside", async () => {
  await findSequence("abs");
  const before = useSequence.getState().found;
  let answer = (_: unknown) => {};
  ask.mockReturnValueOnce(new Promise((resolve) => (answer = resolve)));
  const searched = findSequence("abs");
  cancelSequence();
  expect(ask).toHaveBeenLastCalledWith("stop-sequence", {});
  expect(useSequence.getState()).toMatchObject({ asking: false, cancelled: true, found: before, shown: true });
  answer(sequenceDrawn([]));
  await searched;
  expect(useSequence.getState()).toMatchObject({ cancelled: true, found: before });
  forgetSequence();
  expect(useSequence.getState()).toMatchObject({ cancelled: false, found: null });
});

it("places wires as a whole, and moves them with all their edges", async () => {
  chooseGroups("wire");
  const drawn = sequenceDrawn();
  const [first, second] = drawn.sequence.steps;
  if (!first || !second) throw new Error("there are no steps");
  const steps = [{ ...first, edges: [0, 5, 6] }, second];
  ask.mockResolvedValue({ ...drawn, sequence: { ...drawn.sequence, steps } });
  await findSequence("abs");
  expect(ask).toHaveBeenLastCalledWith("sequence", expect.objectContaining({ group_by: "wire" }));
  await moveStep(0, 1);
  const asked = ask.mock.lastCall?.[1];
  expect(asked).toMatchObject({
    group_by: "wire",
    order: [
      { edge: 1, edges: [] },
      { edge: 0, edges: [0, 5, 6] },
    ],
  });
  chooseGroups("edge");
});

it("checks at once where a step is moved to: its head may stand anywhere, that of the others as it stood", async () => {
  await findSequence("abs");
  ask.mockResolvedValue({ ...sequenceDrawn([1, 0]) });
  await moveStep(1, 0);
  expect(ask).toHaveBeenLastCalledWith("sequence", {
    machine: "builder",
    material: "wire",
    epsilon_mm: null,
    group_by: "edge",
    order: [
      { edge: 1, edges: [], from_vertex: 1, direction: null },
      { edge: 0, edges: [], from_vertex: 0, direction: [0, 0, 1] },
    ],
  });
  expect(useSequence.getState().changed?.sequence.steps.map(({ edge }) => edge)).toEqual([1, 0]);
  expect(useSequence.getState().at).toBe(1);
  takeBackMoves();
  expect(useSequence.getState().changed).toBeNull();
});

it("moves no step while one is looked for, which that would leave without an answer", async () => {
  await findSequence("abs");
  let answer = (_: unknown) => {};
  ask.mockReturnValueOnce(new Promise((resolve) => (answer = resolve)));
  const searched = findSequence("abs");
  await moveStep(1, 0);
  expect(ask).toHaveBeenCalledTimes(2);
  expect(useSequence.getState()).toMatchObject({ asking: true, checking: false });
  answer(sequenceDrawn());
  await searched;
  expect(useSequence.getState()).toMatchObject({ asking: false, changed: null });
});

it("slides within its steps, plays from the start where all is built, and stops where a person slides", async () => {
  await findSequence("abs");
  slideTo(7);
  expect(useSequence.getState().at).toBe(2);
  togglePlaySequence();
  expect(useSequence.getState()).toMatchObject({ at: 0, playing: true });
  slideTo(1);
  expect(useSequence.getState()).toMatchObject({ at: 1, playing: false });
  hideSequence();
  expect(useSequence.getState().shown).toBe(false);
  expect([stepAt(0, 2), stepAt(1.5, 2), stepAt(2, 2)]).toEqual([0, 1, 1]);
  expect(stepAt(1, 2)).toBe(0);
});

it("is left alone where a machine bends a wire", async () => {
  usePlayback.setState({ live: true });
  await findSequence("abs");
  expect(useSequence.getState().shown).toBe(false);
});

it("plays a step in under a second, and many within a minute", () => {
  expect(advanced(0, 10, 0.8)).toBeCloseTo(1);
  expect(advanced(0, 600, 60)).toBeCloseTo(600);
  expect(advanced(9.9, 10, 5)).toBe(10);
});

it("leaves the view to a design that is changed while a sequence is found", async () => {
  ask.mockImplementation(async () => {
    useDesign.setState({ ...movedFrame(), version: 2 });
    return sequenceDrawn();
  });
  await findSequence("abs");
  expect(useSequence.getState()).toMatchObject({ shown: false });
  expect(useSequence.getState().found).not.toBeNull();
});
