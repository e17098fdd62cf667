import { describe, expect, it } from "vitest";
import type { Axes } from "./operator";
import { StepWatch, type ToldStep } from "./live_step";

/** 40 mm in 4 s, 90° in 2 s, a bend of -100° there and back in 3 s, the peg out and in within 1 s. */
const step: ToldStep = { told: { feed_mm: 40, rotate_deg: 90, bend_deg: -100 }, seconds: [4, 2, 3, 1] };
const axes = (feed_mm: number, rotate_deg: number, bend_deg: number): Axes => ({ feed_mm, rotate_deg, bend_deg });
/** Where it is after each report, to a thousandth of a step. */
const told = (watch: StepWatch, made: number, ...places: readonly Axes[]) => places.map((place) => Math.round(watch.at(made, step, place) * 1000) / 1000);

describe("a watch of a step", () => {
  it("goes with the axes through feed, rotate and bend", () => {
    const fed = [axes(100, -30, 0), axes(120, -30, 0), axes(140, -30, 0), axes(140, 15, 0), axes(140, 60, 0)];
    const bent = [axes(140, 60, -50), axes(140, 60, -100), axes(140, 60, -50), axes(140, 60, 0)];
    expect(told(new StepWatch(), 3, ...fed, ...bent)).toEqual([3, 3.2, 3.4, 3.5, 3.6, 3.725, 3.8, 3.875, 3.95]);
  });

  it("begins a step where the one before has ended, although that is told late and its last place was in its middle", () => {
    const watch = new StepWatch();
    told(watch, 0, axes(0, 0, 0), axes(31, 0, 0));
    expect(told(watch, 1, axes(44, 90, 0), axes(60, 90, 0))).toEqual([1.04, 1.2]);
    expect(told(watch, 2, axes(70, 90, 0), axes(80, 180, 0), axes(100, 180, 0))).toEqual([2, 2, 2.2]);
  });

  it("does not take the way back of the bend axis for a bend of the next step, nor the peg's way to its side", () => {
    const watch = new StepWatch();
    told(watch, 0, axes(0, 0, 0), axes(20, 0, 0), axes(40, 90, -5));
    expect(told(watch, 1, axes(40, 90, -4), axes(80, 90, 0), axes(80, 180, 18), axes(80, 180, -20))).toEqual([1, 1.4, 1.6, 1.68]);
  });

  it("measures a bend from where its axis rests: far from its zero, or where the bend before has left it", () => {
    const homed = new StepWatch();
    expect(told(homed, 0, axes(0, 0, -199), axes(20, 0, -199), axes(40, 90, -199), axes(40, 90, -249))).toEqual([0, 0.2, 0.6, 0.725]);
    // A machine whose axis stays: there is no way back.
    const staying = new StepWatch();
    told(staying, 0, axes(0, 0, 0), axes(20, 0, 0), axes(40, 90, -100));
    expect(told(staying, 1, axes(60, 90, -100), axes(80, 180, -100), axes(80, 180, -150))).toEqual([1.2, 1.6, 1.725]);
  });

  it("follows a zero that is set anew for the next wire", () => {
    const watch = new StepWatch();
    expect(told(watch, 0, axes(400, 0, 0), axes(0, 0, 0), axes(20, 0, 0))).toEqual([0, 0, 0.2]);
  });

  it("does not take a place that was told before the step for a new zero", () => {
    const watch = new StepWatch();
    const short: ToldStep = { ...step, told: { feed_mm: 5, rotate_deg: 0, bend_deg: 0 } };
    told(watch, 0, axes(100, 0, 0), axes(110, 0, 0));
    expect(watch.at(1, short, axes(110, 0, 0))).toBe(1);
    expect(watch.at(1, short, axes(142, 90, 0))).toBeCloseTo(1.16);
  });

  it("does not go back when a machine draws its wire back, and not past the end of the step", () => {
    expect(told(new StepWatch(), 0, axes(0, 0, 0), axes(20, 0, 0), axes(18, 0, 0))).toEqual([0, 0.2, 0.2]);
    const watch = new StepWatch();
    watch.at(0, step, axes(0, 0, 0));
    expect(watch.at(0, step, axes(900, 900, -900))).toBeLessThan(1);
  });

  it("waits for a place, and for a step", () => {
    const watch = new StepWatch();
    expect(watch.at(0, step, null)).toBe(0);
    expect(watch.at(2, undefined, axes(1, 2, 3))).toBe(2);
    expect(watch.at(1, { ...step, seconds: [0, 0, 0, 0] }, axes(1, 2, 3))).toBe(1);
  });

  it("takes what it knows anew where steps were missed, and of another wire", () => {
    const watch = new StepWatch();
    told(watch, 0, axes(0, 0, 0), axes(30, 0, 0));
    expect(told(watch, 4, axes(500, 0, 0), axes(520, 0, 0))).toEqual([4, 4.2]);
    watch.reset();
    expect(told(watch, 0, axes(900, 0, 0))).toEqual([0]);
  });
});
