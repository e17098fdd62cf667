import { expect, it } from "vitest";
import type { Moment } from "../interface";
import { momentAt, stepAt } from "./moments";

const BEGIN: Moment = { at: 0, fed: 0, bent: 0, head: 10, bendAxis: 0, pegOut: 0 };
const FED: Moment = { ...BEGIN, at: 0.2, fed: 1 };
const OUT: Moment = { ...FED, pegOut: 1 };
const BENT: Moment = { ...OUT, at: 0.6, bent: 1, bendAxis: -52, head: 100 };
const END: Moment = { ...BENT, at: 1, bendAxis: 0 };
const MOMENTS = [BEGIN, FED, OUT, BENT, END];

it.each([
  // [fraction, fed, bent, head, bend axis, peg]
  [-1, 0, 0, 10, 0, 0],
  [0, 0, 0, 10, 0, 0],
  [0.05, 0.25, 0, 10, 0, 0],
  [0.4, 1, 0.5, 55, -26, 1],
  [0.6, 1, 1, 100, -52, 1],
  [0.9, 1, 1, 100, -13, 1],
  [1, 1, 1, 100, 0, 1],
  [2, 1, 1, 100, 0, 1],
])("is evenly between the moments around it at %d", (fraction, fed, bent, head, bendAxis, pegOut) => {
  const now = momentAt(MOMENTS, fraction);
  expect([now?.fed, now?.bent, now?.head, now?.bendAxis, now?.pegOut]).toEqual(
    [fed, bent, head, bendAxis, pegOut].map((value) => expect.closeTo(value, 9)),
  );
});

it("jumps where two moments are at the same time", () => {
  expect(momentAt(MOMENTS, 0.2)?.pegOut).toBe(0);
  expect(momentAt(MOMENTS, 0.2001)?.pegOut).toBe(1);
});

it("takes the end alone where there is nothing else, and nothing where there is nothing", () => {
  for (const fraction of [0, 0.5, 1]) expect(momentAt([END], fraction)).toBe(END);
  expect(momentAt([], 0.5)).toBeNull();
});

it("stops at both ends of the program", () => {
  expect(stepAt(3, -1)).toEqual({ step: 0, fraction: 0 });
  expect(stepAt(3, 1.25)).toEqual({ step: 1, fraction: 0.25 });
  expect(stepAt(3, 7)).toEqual({ step: 2, fraction: 1 });
  expect(stepAt(0, 0)).toBeNull();
});
