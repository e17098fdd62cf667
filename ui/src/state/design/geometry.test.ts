import { describe, expect, it } from "vitest";
import type { SceneDesign, Vec3 } from "../../scene/interface";
import { boundsOf, degrees, lengthOf, type Matrix, rotation, scaling, translation, turning } from "./geometry";

const apply = (matrix: Matrix, [x, y, z]: Vec3): number[] =>
  matrix.slice(0, 3).map(([a, b, c, d]) => a * x + b * y + c * z + d);

const design: SceneDesign = {
  vertices: new Map(
    (
      [
        [0, 0, 0],
        [30, 40, 0],
        [30, 40, -10],
      ] as Vec3[]
    ).map((at, id) => [id, { id, at, support: false }]),
  ),
  edges: new Map([
    [7, { id: 7, a: 0, b: 1 }],
    [8, { id: 8, a: 1, b: 2 }],
  ]),
};

describe("matrices of edits", () => {
  it("scales about a point that stays", () => {
    const matrix = scaling(2, [10, 0, 5]);
    expect(apply(matrix, [10, 0, 5])).toEqual([10, 0, 5]);
    expect(apply(matrix, [11, 3, 5])).toEqual([12, 6, 5]);
  });

  it.each([
    ["z", 90, [1, 0, 0], [0, 1, 0]],
    ["x", 90, [0, 1, 0], [0, 0, 1]],
    ["y", 90, [0, 0, 1], [1, 0, 0]],
    ["z", -90, [1, 0, 0], [0, -1, 0]],
  ] as const)("turns right-handed about %s by %d°", (axis, deg, from, to) => {
    apply(rotation(axis, deg, [0, 0, 0]), from).forEach((value, k) =>
      expect(value).toBeCloseTo(to[k] ?? Number.NaN, 12),
    );
  });

  it("turns about an axis through a point, and on along it", () => {
    const matrix = rotation("z", 180, [10, 20, 99], 5);
    expect(apply(matrix, [10, 20, 0])).toEqual([10, 20, 5]);
    expect(apply(matrix, [11, 20, 0])).toEqual([9, 20, 5]);
    // 60° about z through the origin: (1, 0) goes to (1/2, √3/2).
    expect(apply(rotation("z", 60, [0, 0, 0]), [1, 0, 0])[1]).toBeCloseTo(Math.sqrt(3) / 2, 12);
  });

  it("keeps 0 0 0 1 below", () => {
    for (const matrix of [translation([1, 2, 3]), scaling(3, [1, 1, 1]), rotation("y", 33, [1, 2, 3], 4)])
      expect(matrix[3]).toEqual([0, 0, 0, 1]);
  });
});

describe("measures", () => {
  it("finds size and middle", () => {
    expect(boundsOf([...design.vertices.values()].map(({ at }) => at))).toEqual({
      low: [0, 0, -10],
      high: [30, 40, 0],
      size: [30, 40, 10],
      centre: [15, 20, -5],
    });
    expect(boundsOf([])).toBeNull();
  });

  it("adds lengths: 3-4-5, and 10", () => {
    expect(lengthOf([7, 8], design)).toBe(60);
    expect(lengthOf([99], design)).toBe(0);
  });

  it("counts the edges at a vertex", () => {
    expect([...degrees(design.edges)]).toEqual([
      [0, 1],
      [1, 2],
      [2, 1],
    ]);
  });
});

it("turns about a line right-handed, and leaves the line where it is", () => {
  const on = (matrix: Matrix | null, at: Vec3) => matrix && apply(matrix, at);
  const about = (deg: number) => turning([10, 0, 0], [10, 0, 7], deg);
  expect(on(about(90), [30, 0, 5])).toEqual([10, 20, 5]);
  expect(on(about(90), [10, 0, -3])).toEqual([10, 0, -3]);
  // A third of a turn about the diagonal of a cube takes each axis to the next.
  on(turning([0, 0, 0], [2, 2, 2], 120), [1, 0, 0])?.forEach((value, k) =>
    expect(value).toBeCloseTo([0, 1, 0][k] ?? NaN, 12),
  );
  expect(turning([1, 2, 3], [1, 2, 3], 90)).toBeNull();
});
