import { type Mesh, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type { Played, PlayedStep, Vec3 } from "./interface";
import { Playback } from "./playback";
import { shared } from "./shading";
import { THEMES } from "./theme";

const step = (feed: number, rotate: number, bend: number): PlayedStep => ({
  feed,
  rotate,
  bend,
  bendAxis: bend * 1.2,
  seconds: [1, 1, 2, 0],
});

/** 10 mm, a corner of 90° to the left, 20 mm, a corner of 90° upwards, 30 mm. */
const PATH: Vec3[] = [
  [0, 0, 0],
  [10, 0, 0],
  [10, 20, 0],
  [10, 20, 30],
];
const STEPS = [step(10, 0, 90), step(20, 90, 90), step(30, 0, 0)];
const played = (change: Partial<Played> = {}): Played => ({
  steps: STEPS,
  path: PATH,
  made: null,
  bodies: [
    { name: "arm", part: "head", shape: { kind: "box", size: [4, 4, 4] }, at: [0, 0, -20], axis: [0, 0, 1] },
    { name: "peg", part: "peg", shape: { kind: "cylinder", radius: 3, length: 20 }, at: [32, 0, 0], axis: [0, 0, 1] },
  ],
  wireDiameter: 3,
  orbitOffset: 12,
  ...change,
});

/** Where a point of the wire, and a body, is in the frame of the machine. */
function at(time: number, change: Partial<Played> = {}) {
  const playback = new Playback(shared(), THEMES.dark);
  playback.play(played(change));
  playback.setTime(time, "designed");
  playback.group.updateMatrixWorld(true);
  const round = (place: Vector3): number[] => place.toArray().map((part) => Math.round(part * 1e6) / 1e6 + 0);
  const wire = playback.group.children.find((child) => (child as Mesh).isMesh && child.visible);
  const body = (part: string, place: Vec3): number[] => round(playback.group.getObjectByName(part)!.localToWorld(new Vector3(...place)));
  return { first: round(wire!.localToWorld(new Vector3(...PATH[0]!))), arm: body("head", [0, 0, -20]), peg: body("peg", [20, 0, 0]) };
}

// A step is 4 s: feed 1 s, rotate 1 s, out 1 s, back 1 s. All places by hand.
describe("the end that was made first", () => {
  it("comes out of the nozzle along x", () => {
    expect(at(0).first).toEqual([0, 0, 0]);
    expect(at(0.125).first).toEqual([5, 0, 0]);
    expect(at(0.25).first).toEqual([10, 0, 0]);
  });

  it("swings to the left, right-handed about z, while the peg goes out, and stays there while it comes back", () => {
    const half = 10 * Math.SQRT1_2;
    expect(at(0.625).first).toEqual([half, half, 0].map((part) => Math.round(part * 1e6) / 1e6));
    expect(at(0.75).first).toEqual([0, 10, 0]);
    expect(at(1).first).toEqual([0, 10, 0]);
  });

  it("is fed on, and stays as it is while the head rotates", () => {
    expect(at(1.25).first).toEqual([20, 10, 0]);
    expect(at(1.5).first).toEqual([20, 10, 0]);
  });

  it("swings about the turned head: rotated by 90° its z points to +y, and +x goes to -z", () => {
    // Right-handed about the direction of travel, -x: z goes to y. About y, x goes to -z.
    expect(at(2).first).toEqual([0, 10, -20]);
    expect(at(3).first).toEqual([30, 10, -20]);
  });
});

it("turns the head about the direction of travel, with everything on it", () => {
  expect(at(1.25).arm).toEqual([0, 0, -20]);
  expect(at(1.5).arm).toEqual([0, -20, 0]);
  expect(at(3).arm).toEqual([0, -20, 0]);
});

it("turns the peg about the orbit's axis, out and back", () => {
  expect(at(0.5).peg).toEqual([32, 0, 0]);
  const out = (108 * Math.PI) / 180;
  expect(at(0.75).peg).toEqual([12 + 20 * Math.cos(out), 20 * Math.sin(out), 0].map((part) => Math.round(part * 1e6) / 1e6));
  expect(at(1).peg).toEqual([32, 0, 0]);
});

describe("a peg that the machine waits for", () => {
  // A step is 6 s: feed 1 s, rotate 1 s, 1 s the peg comes out, there 1 s, back 1 s, 1 s it goes in.
  const waiting = { steps: STEPS.map((each, k): PlayedStep => (k < 2 ? { ...each, seconds: [1, 1, 2, 2] } : each)) };
  const height = (time: number): number => at(time, waiting).peg[2]!;
  // It reaches 10 mm above the wire's middle; the wire is 3 mm thick, and 1 mm is left between them.
  const IN = -12.5;

  it("is in while the wire is fed and the head turns, and out while it bends", () => {
    expect([0, 1, 2, 3, 4, 5, 6].map((seconds) => height(seconds / 6))).toEqual([IN, IN, IN, 0, 0, 0, IN].map((z) => expect.closeTo(z, 6)));
    expect(height(2.5 / 6)).toBeCloseTo(IN / 2, 6);
  });

  it("moves along its own axis, also on a head that has turned", () => {
    // The head's z points to +y.
    expect(at(1 + 2 / 6, waiting).peg[1]).toBeCloseTo(IN, 6);
    expect(at(2.5, waiting).peg[1]).toBeCloseTo(IN, 6);
  });
});

it("shows the wire as made, also where the program asked for something else", () => {
  const playback = new Playback(shared(), THEMES.dark);
  playback.play(
    played({
      made: [
        [0, 0, 0],
        [10, 0, 0],
        [10, 20, 0],
        [10, 22, 30],
      ],
    }),
  );
  playback.setTime(1, "both");
  expect(playback.group.children.filter((child) => (child as Mesh).isMesh && child.visible).length).toBe(2);
  playback.setTime(1, "made");
  expect(playback.group.children.filter((child) => (child as Mesh).isMesh && child.visible).length).toBe(1);
});

it("shows nothing, and does not stop, for an empty program or path", () => {
  for (const change of [{ steps: [] }, { path: [] }, { path: [[0, 0, 0]] as Vec3[] }, { made: [] }]) {
    const playback = new Playback(shared(), THEMES.dark);
    playback.play(played(change));
    playback.setTime(1.5, "both");
    expect(playback.places).not.toBeNull();
    playback.dispose();
    expect(playback.places).toBeNull();
  }
});
