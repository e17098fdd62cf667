import { Quaternion, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import programs from "./fixtures/programs.json";
import type { PlayedStep, Vec3 } from "./interface";
import { bendTurn, corners, type Run, runs } from "./poses";
import { distance, subtract } from "./vec";

/** Steps and paths as `wirebend dump program|schedule|route` gives them for the examples of the same names. */
const CASES = programs.flatMap(({ name, path_mm, program, schedule }) =>
  [
    ["program", program],
    ["schedule", schedule],
  ].map(([kind, steps]) => ({
    name: `${name}, ${kind as string}`,
    path: path_mm as unknown as Vec3[],
    steps: (steps as number[][]).map(([feed = 0, rotate = 0, bend = 0]): PlayedStep => ({
      feed,
      rotate,
      bend,
      seconds: [1, 1, 1, 0],
      bendAxis: bend,
    })),
  })),
);

const RADIANS = Math.PI / 180;
const NEAR = 1e-6;

/** Where the made part of the path is at the end of a run's feed, in the frame of the machine. */
function madeAt(path: readonly Vec3[], run: Run, turn: Quaternion): Vec3[] {
  const end = path[run.last]!;
  return path.slice(0, run.last + 1).map((at) => new Vector3(...subtract(at, end)).applyQuaternion(turn).toArray() as unknown as Vec3);
}

/**
 * The machine alone, with no look at the path: the wire that is out is pushed along +x, the head turns by -rotate about +x, and the
 * wire turns about the head's z by the bend. Ends of the straight parts, the one made first in front, at the end of the last feed.
 */
function bender(steps: readonly PlayedStep[]): Vector3[] {
  const out = [new Vector3()];
  let head = 0;
  for (const [k, step] of steps.entries()) {
    for (const at of out) at.x += step.feed;
    if (k === steps.length - 1) break;
    head -= step.rotate * RADIANS;
    const z = new Vector3(0, 0, 1).applyAxisAngle(new Vector3(1, 0, 0), head);
    for (const at of out) at.applyAxisAngle(z, step.bend * RADIANS);
    out.push(new Vector3());
  }
  return [...out, new Vector3()];
}

describe.each(CASES)("$name", ({ path, steps }) => {
  const made = runs(path, steps);

  it("has a run for each step, as long as its feed", () => {
    expect(made.length).toBe(steps.length);
    made.forEach((run, k) => expect(Math.abs(run.length - steps[k]!.feed)).toBeLessThan(NEAR));
  });

  it("has the fed part on the machine's x axis, in front of the nozzle, at the end of every feed", () => {
    for (const run of made) {
      const at = madeAt(path, run, run.turn);
      for (const place of at.slice(run.first)) {
        expect(Math.hypot(place[1], place[2])).toBeLessThan(NEAR);
        expect(place[0]).toBeGreaterThan(-NEAR);
      }
      expect(distance(at[run.first]!, [run.length, 0, 0])).toBeLessThan(NEAR);
    }
  });

  it("is where a bender that knows only the steps has it: same shape, same hand, same place", () => {
    const wanted = bender(steps);
    const last = made.at(-1)!;
    const at = madeAt(path, last, last.turn);
    const ends = [...made.map((run) => run.first), last.last];
    ends.forEach((point, k) => expect(wanted[k]!.distanceTo(new Vector3(...at[point]!))).toBeLessThan(NEAR));
  });

  it("bends about the head's axis by the angle of the step", () => {
    let head = 0;
    made.slice(0, -1).forEach((run, k) => {
      head -= steps[k]!.rotate * RADIANS;
      expect(run.headAfter).toBeCloseTo(head, 9);
      const asked = new Quaternion().setFromAxisAngle(new Vector3(0, -Math.sin(head), Math.cos(head)), steps[k]!.bend * RADIANS);
      const shown = bendTurn(run.bendAxis, run.bendAngle);
      expect(Math.abs(asked.dot(shown))).toBeCloseTo(1, 9);
    });
  });

  it("turns nothing that is out while the head rotates", () => {
    made.slice(0, -1).forEach((run, k) => {
      const bent = bendTurn(run.bendAxis, run.bendAngle).multiply(run.turn);
      expect(Math.abs(bent.dot(made[k + 1]!.turn))).toBeCloseTo(1, 9);
    });
  });
});

it("keeps mirror images apart", () => {
  const [left, right] = ["mirror-left, program", "mirror-right, program"].map((name) => {
    const { path, steps } = CASES.find((one) => one.name === name)!;
    const last = runs(path, steps).at(-1)!;
    return madeAt(path, last, last.turn);
  });
  // The same lengths and angles, laid on each other at both ends of their last part.
  const apart = left!.map((at, k) => distance(at, right![k]!));
  expect(Math.max(...apart)).toBeGreaterThan(1);
});

it("takes the sharpest corners where a path has more points than the program has bends", () => {
  const path: Vec3[] = [
    [0, 0, 0],
    [10, 0, 0],
    [20, 0.001, 0],
    [20, 10, 0],
    [20, 20, 0],
  ];
  expect(corners(path, 2)).toEqual([0, 2, 4]);
});

it("shows what there is of a path that is too short for its program", () => {
  const steps = CASES[0]!.steps;
  expect(runs([], steps)).toEqual([]);
  expect(runs([[0, 0, 0]], steps)).toEqual([]);
  expect(
    runs(
      [
        [0, 0, 0],
        [0, 5, 0],
      ],
      steps,
    ).map((run) => run.length),
  ).toEqual([5]);
});
