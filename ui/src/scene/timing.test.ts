import { describe, expect, it } from "vitest";
import type { PlayedStep } from "./interface";
import { phase, stepAt, waitsForPeg } from "./timing";

const step: PlayedStep = { feed: 50, rotate: 90, bend: 40, bendAxis: 52, seconds: [1, 2, 4, 3] };

describe("a step of 10 seconds", () => {
  it.each([
    // [seconds, feed, rotate, bend, axis, peg]: 1 s feed, 2 s rotate, 1.5 s the peg comes out, 2 s there, 2 s back, 1.5 s it goes in.
    [0, 0, 0, 0, 0, 0],
    [0.5, 0.5, 0, 0, 0, 0],
    [2, 1, 0.5, 0, 0, 0],
    [3, 1, 1, 0, 0, 0],
    [3.75, 1, 1, 0, 0, 0.5],
    [4.5, 1, 1, 0, 0, 1],
    [5.5, 1, 1, 0.5, 0.5, 1],
    [6.5, 1, 1, 1, 1, 1],
    [7.5, 1, 1, 1, 0.5, 1],
    [8.5, 1, 1, 1, 0, 1],
    [9.25, 1, 1, 1, 0, 0.5],
    [10, 1, 1, 1, 0, 0],
  ])("has come so far after %d s", (seconds, feed, rotate, bend, axis, out) => {
    const now = phase(step, seconds / 10);
    expect([now.feed, now.rotate, now.bend, now.axis, now.out].map((part) => Math.round(part * 1e9) / 1e9)).toEqual([feed, rotate, bend, axis, out]);
  });
});

it("leaves the peg in while a step only feeds", () => {
  const straight: PlayedStep = { feed: 50, rotate: 0, bend: 0, bendAxis: 0, seconds: [1, 0, 0, 0] };
  for (const fraction of [0, 0.3, 1]) expect(phase(straight, fraction).out).toBe(0);
  expect([waitsForPeg([straight, step]), waitsForPeg([straight])]).toEqual([true, false]);
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
