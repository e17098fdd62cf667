import { describe, expect, it } from "vitest";
import { StepWatch, type ToldStep } from "./live_step";

/** 40 mm in 4 s, 90° in 2 s, a bend of -100° there and back in 3 s, the peg out and in within 1 s. */
const step: ToldStep = { told: { feed_mm: 40, rotate_deg: 90, bend_deg: -100 }, seconds: [4, 2, 3, 1] };
const axes = (feed_mm: number, rotate_deg: number, bend_deg: number) => ({ feed_mm, rotate_deg, bend_deg });

describe("a watch of a step", () => {
  it("goes with the axes through feed, rotate and bend", () => {
    const watch = new StepWatch();
    const places = [axes(100, -30, 0), axes(120, -30, 0), axes(140, -30, 0), axes(140, 15, 0), axes(140, 60, 0), axes(140, 60, -50), axes(140, 60, -100), axes(140, 60, -50), axes(140, 60, 0)];
    expect(places.map((place) => Math.round(watch.at(3, step, place) * 1000) / 1000)).toEqual([3, 3.2, 3.4, 3.5, 3.6, 3.725, 3.8, 3.875, 3.95]);
  });

  it("begins a step where the one before has ended", () => {
    const watch = new StepWatch();
    watch.at(0, step, axes(0, 0, 0));
    watch.at(0, step, axes(40, 90, 0));
    // Its end is told after the next one has begun.
    expect(watch.at(1, step, axes(44, 90, 0))).toBeCloseTo(1.04);
    expect(watch.at(1, step, axes(60, 90, 0))).toBeCloseTo(1.2);
  });

  it("does not take the way back of the bend axis for a bend of the next step, nor the peg's way to its side", () => {
    const watch = new StepWatch();
    watch.at(0, step, axes(0, 0, 0));
    watch.at(0, step, axes(40, 90, -5));
    const places = [axes(40, 90, -4), axes(80, 90, 0), axes(80, 180, 18), axes(80, 180, -20)];
    expect(places.map((place) => Math.round(watch.at(1, step, place) * 1000) / 1000)).toEqual([1, 1.4, 1.6, 1.68]);
  });

  it("does not go back when a machine draws its wire back, and not past the end of the step", () => {
    const watch = new StepWatch();
    watch.at(0, step, axes(0, 0, 0));
    expect(watch.at(0, step, axes(20, 0, 0))).toBeCloseTo(0.2);
    expect(watch.at(0, step, axes(18, 0, 0))).toBeCloseTo(0.2);
    expect(watch.at(0, step, axes(900, 900, -900))).toBeLessThan(1);
  });

  it("waits for a place, and for a step", () => {
    const watch = new StepWatch();
    expect(watch.at(0, step, null)).toBe(0);
    expect(watch.at(2, undefined, axes(1, 2, 3))).toBe(2);
    expect(watch.at(1, { ...step, seconds: [0, 0, 0, 0] }, axes(1, 2, 3))).toBe(1);
  });

  it("knows nothing of a wire before", () => {
    const watch = new StepWatch();
    watch.at(0, step, axes(0, 0, 0));
    watch.at(0, step, axes(30, 0, 0));
    watch.reset();
    expect(watch.at(0, step, axes(500, 0, 0))).toBe(0);
  });
});
