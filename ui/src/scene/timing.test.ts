import { describe, expect, it } from "vitest";
import type { PlayedStep } from "./interface";
import { phase, stepAt } from "./timing";

const step: PlayedStep = { feed: 50, rotate: 90, bend: 40, bendAxis: 52, seconds: [1, 2, 4, 3] };

describe("a step of 10 seconds", () => {
  it.each([
    // [seconds, feed, rotate, bend, peg]: 1 s feed, 2 s rotate, 2 s out, 2 s back, 3 s waiting.
    [0, 0, 0, 0, 0],
    [0.5, 0.5, 0, 0, 0],
    [2, 1, 0.5, 0, 0],
    [4, 1, 1, 0.5, 0.5],
    [5, 1, 1, 1, 1],
    [6, 1, 1, 1, 0.5],
    [8, 1, 1, 1, 0],
    [10, 1, 1, 1, 0],
  ])("has come so far after %d s", (seconds, feed, rotate, bend, peg) => {
    const now = phase(step, seconds / 10);
    expect([now.feed, now.rotate, now.bend, now.peg].map((part) => Math.round(part * 1e9) / 1e9)).toEqual([feed, rotate, bend, peg]);
  });
});

it("gives each part the same where the machine tells no times, and nothing to a part that does not move", () => {
  expect(phase({ ...step, rotate: 0, seconds: [0, 0, 0, 0] }, 0.5)).toMatchObject({ feed: 1, bend: 0 });
  expect(phase({ feed: 5, rotate: 0, bend: 0, bendAxis: 0, seconds: [0, 0, 0, 0] }, 0.5).feed).toBeCloseTo(0.5);
});

it("stops at both ends of the program", () => {
  expect(stepAt(3, -1)).toEqual({ step: 0, fraction: 0 });
  expect(stepAt(3, 1.25)).toEqual({ step: 1, fraction: 0.25 });
  expect(stepAt(3, 7)).toEqual({ step: 2, fraction: 1 });
  expect(stepAt(0, 0)).toBeNull();
});
