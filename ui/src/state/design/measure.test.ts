import { expect, it } from "vitest";
import type { MeasuredThing, SceneDesign, Vec3 } from "../../scene/interface";
import { between as apart, measured } from "./measure";

const places: readonly Vec3[] = [
  [0, 0, 0],
  [100, 0, 0],
  [50, 30, 40],
  [50, 80, 40],
  [130, 40, 0],
  [0, 20, 0],
  [100, 20, 0],
];
const ends = [
  [0, 1],
  [2, 3],
  [5, 6],
] as const;
const design: SceneDesign = {
  vertices: new Map(places.map((at, id) => [id, { id, at, support: false }])),
  edges: new Map(ends.map(([a, b], id) => [id, { id, a, b }])),
};
/** A construction line 10 mm below the first edge. */
const line = [
  [0, 0, -10],
  [100, 0, -10],
] as const;
const between = (vertices: number[], edges: number[] = [], lines: number[] = []) =>
  measured({ vertices: new Set(vertices), edges: new Set(edges), lines: new Set(lines) }, design, [line]);

it("measures between vertices, a vertex and an edge, and two edges", () => {
  expect(between([0, 1])).toEqual({ from: [0, 0, 0], to: [100, 0, 0], mm: 100, deg: null });
  // Across from the edge, and beside its end.
  expect(between([2], [0])).toMatchObject({ from: [50, 30, 40], to: [50, 0, 0], mm: 50, deg: null });
  expect(between([4], [0])).toMatchObject({ to: [100, 0, 0], mm: 50 });
  // At right angles, nearest at an end of one; and in parallel.
  expect(between([], [0, 1])).toMatchObject({ from: [50, 0, 0], to: [50, 30, 40], mm: 50 });
  expect(between([], [0, 1])?.deg).toBeCloseTo(90, 9);
  expect(between([], [0, 2])).toMatchObject({ mm: 20, deg: 0 });
  // A construction line is one of the two things, as an edge is.
  expect(between([], [0], [0])).toMatchObject({ mm: 10, deg: 0 });
  expect(between([4], [0], [0])).toBeNull();
});

it("measures the shortest way between straight pieces, as dense samples of both find it", () => {
  let seed = 7;
  /** Even from 0 to 1, the same at each run (Park and Miller, 1988). */
  const random = () => {
    seed = (seed * 48271) % 2147483647;
    return seed / 2147483647;
  };
  const anywhere = (): Vec3 => [random() * 100, random() * 100, random() * 100];
  const on = ({ from, to }: MeasuredThing, share: number): Vec3 => [
    from[0] + (to[0] - from[0]) * share,
    from[1] + (to[1] - from[1]) * share,
    from[2] + (to[2] - from[2]) * share,
  ];
  const STEPS = 60;
  for (let round = 0; round < 60; round += 1) {
    const [one, other] = [
      { from: anywhere(), to: anywhere() },
      { from: anywhere(), to: anywhere() },
    ];
    const found = apart(one, other);
    let least = Infinity;
    for (let i = 0; i <= STEPS; i += 1)
      for (let j = 0; j <= STEPS; j += 1) {
        const [p, q] = [on(one, i / STEPS), on(other, j / STEPS)];
        least = Math.min(least, Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      }
    // No sample is nearer; and the nearest sample is off by at most half a step on each.
    const reach = [one, other].map((thing) => apart({ ...thing, to: thing.from }, { from: thing.to, to: thing.to }).mm);
    const [a = 0, b = 0] = reach;
    expect(found.mm).toBeLessThanOrEqual(least + 1e-9);
    expect(found.mm).toBeGreaterThanOrEqual(least - (a + b) / (2 * STEPS) - 1e-9);
    expect(apart(other, one).mm).toBeCloseTo(found.mm, 9);
  }
});

it("measures angles between lines from 0° to 90°, whichever way they run, and none where one of them is a place", () => {
  const line = (deg: number): MeasuredThing => {
    const [x, y] = [Math.cos((deg * Math.PI) / 180), Math.sin((deg * Math.PI) / 180)];
    return { from: [0, 0, 5], to: [x * 40, y * 40, 5] };
  };
  for (const [deg, expected] of [
    [30, 30],
    [90, 90],
    [150, 30],
    [180, 0],
    [210, 30],
  ] as const)
    expect(apart(line(0), line(deg)).deg).toBeCloseTo(expected, 9);
  const corner: MeasuredThing = { from: [0, 0, 0], to: [0, 0, 0] };
  expect(apart(corner, line(30))).toMatchObject({ from: [0, 0, 0], to: [0, 0, 5], mm: 5, deg: null });
});

it("measures nothing of one thing or of three", () => {
  expect([between([0]), between([], [0]), between([0, 1, 2]), between([0, 1], [0])]).toEqual([null, null, null, null]);
});
