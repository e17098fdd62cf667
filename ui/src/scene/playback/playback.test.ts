import { type InstancedBufferGeometry, type Mesh, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { shared } from "../drawing/shading";
import { THEMES } from "../drawing/theme";
import type { Moment, Played, PlayedPath, PlayedStep, Pose, Vec3 } from "../interface";
import { given } from "../testing";
import { Playback } from "./playback";

/** 10 mm, a corner of 90° to the left, 20 mm, a corner of 90° upwards, 30 mm. */
const PATH: Vec3[] = [
  [0, 0, 0],
  [10, 0, 0],
  [10, 20, 0],
  [10, 20, 30],
];
/** Half of the square root of 2: of half a right angle. */
const H = Math.SQRT1_2;
/**
 * By hand: a wire that runs along x is fed to -x, its z to -z, which is half a turn about y; each bend turns on from there, the second about
 * the z of a head that has turned by -90° about x, which is y.
 */
const POSES: Pose[] = [
  { turn: [0, 1, 0, 0], bendAxis: [0, 0, 1], bend: 90 },
  { turn: [-H, H, 0, 0], bendAxis: [0, 1, 0], bend: 90 },
  { turn: [-0.5, 0.5, 0.5, -0.5], bendAxis: [0, 1, 0], bend: 0 },
];
/** A step of 4 s: feed 1 s, rotate 1 s, out 1 s, back 1 s. The bend axis goes by a fifth farther than the wire stays bent. */
const step = (before: number, head: number, bend: number): PlayedStep => {
  const begin: Moment = { at: 0, fed: 0, bent: 0, head: before, bendAxis: 0, pegOut: 1 };
  const rotated: Moment = { ...begin, at: 0.5, fed: 1, head };
  const bent: Moment = { ...rotated, at: 0.75, bent: 1, bendAxis: bend * 1.2 };
  return {
    moments: [begin, { ...begin, at: 0.25, fed: 1 }, rotated, bent, { ...bent, at: 1, bendAxis: 0 }],
    seconds: [1, 1, 2, 0],
  };
};
const STEPS = [step(0, 0, 90), step(0, -90, 90), step(-90, -90, 0)];
const NO_WIRE: PlayedPath = { corners: [], poses: [] };
const played = (change: Partial<Played> = {}): Played => ({
  steps: STEPS,
  designed: { corners: PATH, poses: POSES },
  made: null,
  bodies: [
    { name: "arm", part: "head", shape: { kind: "box", size: [4, 4, 4] }, at: [0, 0, -20], axis: [0, 0, 1] },
    { name: "peg", part: "peg", shape: { kind: "cylinder", radius: 3, length: 20 }, at: [32, 0, 0], axis: [0, 0, 1] },
  ],
  wireDiameter: 3,
  orbitOffset: 12,
  pegTop: 10,
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
  const body = (part: string, place: Vec3): number[] =>
    round(given(playback.group.getObjectByName(part)).localToWorld(new Vector3(...place)));
  return {
    first: round(given(wire).localToWorld(new Vector3(...given(PATH[0])))),
    arm: body("head", [0, 0, -20]),
    peg: body("peg", [20, 0, 0]),
  };
}

// All places by hand.
describe("the end that was bent first", () => {
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

it("shows a ball once its place is out of the nozzle, and where its place is", () => {
  const playback = new Playback(shared(), THEMES.dark);
  playback.play(played());
  const ball = { radius: 2, colour: [1, 0, 0] as const };
  playback.setSpread([
    { ...ball, at: [10, 0, 0], along: 10 },
    { ...ball, at: [10, 20, 0], along: 30 },
    { ...ball, at: [10, 20, 15], along: 45 },
  ]);
  const { group } = playback;
  const scattered = given(group.children.find((child) => child.type === "Group" && child !== group.children[0]));
  const mesh = given(scattered.children[0]) as Mesh<InstancedBufferGeometry>;
  const seen = (time: number, shown: "designed" | "made" | "both" = "designed"): number => {
    playback.setTime(time, shown);
    group.updateMatrixWorld(true);
    return scattered.visible ? mesh.geometry.instanceCount : 0;
  };
  expect([0, 0.2, 0.25, 1, 1.2, 1.25, 2, 2.124, 2.126, 3].map((time) => seen(time))).toEqual([
    0, 0, 1, 1, 1, 2, 2, 2, 3, 3,
  ]);
  seen(0.75);
  // The corner that is being bent stays at the bend point.
  const corner = mesh.localToWorld(new Vector3(10, 0, 0));
  expect(corner.length()).toBeCloseTo(0, 6);
  playback.play(played({ made: { corners: PATH, poses: POSES } }));
  expect([seen(3, "made"), seen(3, "both")]).toEqual([0, 3]);
});

it("turns the head about the direction of travel, with everything on it", () => {
  expect(at(1.25).arm).toEqual([0, 0, -20]);
  expect(at(1.5).arm).toEqual([0, -20, 0]);
  expect(at(3).arm).toEqual([0, -20, 0]);
});

it("turns the peg about the orbit's axis, out and back", () => {
  expect(at(0.5).peg).toEqual([32, 0, 0]);
  const out = (108 * Math.PI) / 180;
  expect(at(0.75).peg).toEqual(
    [12 + 20 * Math.cos(out), 20 * Math.sin(out), 0].map((part) => Math.round(part * 1e6) / 1e6),
  );
  expect(at(1).peg).toEqual([32, 0, 0]);
});

describe("a peg that the machine waits for", () => {
  // A step is 6 s: feed 1 s, rotate 1 s, 1 s the peg comes out, there 1 s, back 1 s, 1 s it goes in.
  const waits = ({ moments, seconds }: PlayedStep, k: number): PlayedStep => {
    const [begin, fed, rotated, bent, end] = moments.map((moment) => ({ ...moment, pegOut: 0 }));
    if (!begin || !fed || !rotated || !bent || !end) throw new Error("a step has five moments");
    const out = k < 2 ? 1 : 0;
    const times = [
      { ...fed, at: 1 / 6 },
      { ...rotated, at: 2 / 6 },
      { ...rotated, at: 3 / 6, pegOut: out },
      { ...bent, at: 4 / 6, pegOut: out },
      { ...end, at: 5 / 6, pegOut: out },
    ];
    return { moments: [begin, ...times, end], seconds };
  };
  const waiting = { steps: STEPS.map(waits) };
  const height = (time: number): number => given(at(time, waiting).peg[2]);
  // It reaches 10 mm above the wire's middle; the wire is 3 mm thick, and 1 mm is left between them.
  const IN = -12.5;

  it("is in while the wire is fed and the head turns, and out while it bends", () => {
    expect([0, 1, 2, 3, 4, 5, 6].map((seconds) => height(seconds / 6))).toEqual(
      [IN, IN, IN, 0, 0, 0, IN].map((z) => expect.closeTo(z, 6)),
    );
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
      made: { corners: [...PATH.slice(0, 3), [10, 22, 30]], poses: POSES },
    }),
  );
  playback.setTime(1, "both");
  expect(playback.group.children.filter((child) => (child as Mesh).isMesh && child.visible).length).toBe(2);
  playback.setTime(1, "made");
  expect(playback.group.children.filter((child) => (child as Mesh).isMesh && child.visible).length).toBe(1);
});

it("draws what touches what red, each body alone, and all as before when nothing touches any more", () => {
  const playback = new Playback(shared(), THEMES.dark);
  const mark = { ...given(played().bodies[0]), name: "mark", at: [0, 0, 30] as const };
  playback.play(played({ bodies: [...played().bodies, mark] }));
  playback.setTime(1.5, "designed");
  const touched = (part: string): number[] => [
    ...(given(playback.group.getObjectByName(part)) as Mesh).geometry.getAttribute("marked").array,
  ];
  // A box has 24 corners: arm and mark are one mesh, the arm first.
  playback.setTouches([{ leg: 0, body: 2 }]);
  expect(touched("head")).toEqual([...Array(24).fill(0), ...Array(24).fill(1)]);
  expect(touched("peg").every((one) => one === 0)).toBe(true);
  playback.setTouches([
    { leg: 0, body: 1 },
    { leg: 1, body: null },
  ]);
  expect(touched("head").every((one) => one === 0)).toBe(true);
  expect(touched("peg").every((one) => one === 1)).toBe(true);
  playback.setTouches([]);
  expect(touched("peg").every((one) => one === 0)).toBe(true);
});

it("shows nothing, and does not stop, for an empty program or path", () => {
  const point: PlayedPath = { corners: [[0, 0, 0]], poses: [] };
  for (const change of [{ steps: [] }, { designed: NO_WIRE }, { designed: point }, { made: NO_WIRE }]) {
    const playback = new Playback(shared(), THEMES.dark);
    playback.play(played(change));
    playback.setTime(1.5, "both");
    expect(playback.places).not.toBeNull();
    playback.dispose();
    expect(playback.places).toBeNull();
  }
});
