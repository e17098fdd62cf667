import { describe, expect, it } from "vitest";
import {
  advance,
  machineSeconds,
  type Speeds,
  type StepSeconds,
  screenSeconds,
  stepBack,
  stepForward,
  stepOf,
} from "./clock";

const ONE: Speeds = { feed: 1, rotate: 1, bend: 1, all: 1 };
/** 2 s feed, 1 s rotate, 4 s bend, 1 s wait; then 3 s feed. */
const STEPS: readonly StepSeconds[] = [
  [2, 1, 4, 1],
  [3, 0, 0, 0],
];

describe("advance", () => {
  it("runs through a step in the machine's own time", () => {
    expect(advance(STEPS, 0, 4, ONE)).toBeCloseTo(4 / 8);
    expect(advance(STEPS, 0, 8, ONE)).toBeCloseTo(1);
    expect(advance(STEPS, 0, 9.5, ONE)).toBeCloseTo(1.5);
  });

  it("runs faster where it is set to: 2 s feed, 1 s rotate, then 1 of 5 s of bending at four times the speed", () => {
    const fast = { ...ONE, bend: 4 };
    expect(advance(STEPS, 0, 3.25, fast)).toBeCloseTo((3 + 1) / 8);
    expect(advance(STEPS, 0, 3 + 5 / 4, fast)).toBeCloseTo(1);
  });

  it("multiplies all of it", () => {
    expect(advance(STEPS, 0, 2, { ...ONE, all: 2 })).toBeCloseTo(4 / 8);
  });

  it("continues from within a step, stops at the end, and takes steps without time for a second", () => {
    expect(advance(STEPS, 0.5, 1, ONE)).toBeCloseTo(5 / 8);
    expect(advance(STEPS, 1.9, 60, ONE)).toBe(2);
    expect(advance([[0, 0, 0, 0]], 0, 0.5, { ...ONE, bend: 8 })).toBeCloseTo(0.5);
    expect(advance([], 0, 1, ONE)).toBe(0);
  });

  it("takes as long as is said before, whatever the frames are", () => {
    const speeds = { feed: 1.5, rotate: 2, bend: 4, all: 0.7 };
    const all = screenSeconds(STEPS, 0, speeds);
    let at = 0;
    for (let k = 0; k < 100; k += 1) at = advance(STEPS, at, all / 100, speeds);
    expect(at).toBeCloseTo(2, 6);
    // And the time to the end shrinks by what has passed.
    const half = advance(STEPS, 0, all / 3, speeds);
    expect(screenSeconds(STEPS, half, speeds)).toBeCloseTo((2 / 3) * all, 9);
  });
});

describe("machineSeconds", () => {
  it("is what the machine has worked, whatever the speed of the screen", () => {
    expect(machineSeconds(STEPS, 0)).toBe(0);
    expect(machineSeconds(STEPS, 0.25)).toBeCloseTo(2);
    expect(machineSeconds(STEPS, 1.5)).toBeCloseTo(9.5);
    expect(machineSeconds(STEPS, 2)).toBe(11);
    expect(machineSeconds(STEPS, 9)).toBe(11);
  });
});

describe("steps", () => {
  it("goes to the next boundary either way", () => {
    expect([stepForward(2, 0), stepForward(2, 0.4), stepForward(2, 1), stepForward(2, 2)]).toEqual([1, 1, 2, 2]);
    expect([stepBack(2), stepBack(1.4), stepBack(1), stepBack(0)]).toEqual([1, 1, 0, 0]);
  });

  it("names the step that is under way", () => {
    expect([stepOf(2, 0), stepOf(2, 1.99), stepOf(2, 2), stepOf(0, 0)]).toEqual([0, 1, 1, -1]);
  });
});
