import { describe, expect, it } from "vitest";
import { shared } from "../drawing/shading";
import type { SceneStencil, SnapKind, SnapSettings, Vec3 } from "../interface";
import { Stencils } from "../layers/stencils";
import { designOf, drawn, projectionOf } from "../testing";
import { inDirections, type SnapPlace, snap } from "./snap";

const ALL: SnapKind[] = ["vertex", "stencil-vertex", "stencil-edge", "edge", "surface", "grid", "plane"];
const settings = (kinds: SnapKind[] = ALL): SnapSettings => ({ kinds: new Set(kinds), grid: 10, reach: 8 });
const NONE = { vertices: new Set<number>(), edges: new Set<number>() };

const AS_IN_FILE: SceneStencil["matrix"] = [
  [1, 0, 0, 0],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
];

/** A square of 200 mm in the plane y = 0 with its diagonal, seen from the front; a pixel is a millimetre. */
function square(change: Partial<SceneStencil> = {}): Stencils {
  const stencils = new Stencils(shared());
  const positions = new Float32Array([-100, 0, -100, 100, 0, -100, 100, 0, 100, -100, 0, 100]);
  const surface = { positions, triangles: new Uint32Array([0, 1, 2, 0, 2, 3]) };
  stencils.show([{ id: 0, surface, matrix: AS_IN_FILE, colour: null, hidden: false, ...change }]);
  return stencils;
}

const place = (change: Partial<SnapPlace> = {}): SnapPlace => ({
  design: drawn(
    designOf(
      [
        [0, -5, 50],
        [60, -5, 50],
        [40, 80, -60],
      ],
      [[0, 1]],
    ),
  ),
  projection: projectionOf("front"),
  stencil: square(),
  construction: [],
  plane: { origin: [0, 0, 0], u: [1, 0, 0], v: [0, 0, 1] },
  without: NONE,
  ...change,
});

const kindAt = (x: number, z: number, kinds?: SnapKind[], change?: Partial<SnapPlace>): SnapKind | undefined =>
  snap(place(change), settings(kinds), 400 + x, 300 - z)?.kind;

describe("a stencil that is placed", () => {
  /** Half as large, a quarter turn about y, and 60 mm to the right. */
  const matrix: SceneStencil["matrix"] = [
    [0, 0, 0.5, 60],
    [0, 0.5, 0, 0],
    [-0.5, 0, 0, 0],
  ];

  it("is traced where it lies", () => {
    const change = { stencil: square({ matrix }) };
    expect(kindAt(108, 48, undefined, change)).toBe("stencil-vertex");
    expect(snap(place(change), settings(), 508, 252)?.at.map(Math.round)).toEqual([110, 0, 50]);
    expect(kindAt(109, 20, undefined, change)).toBe("stencil-edge");
    expect(kindAt(-50, -60, undefined, change)).not.toBe("surface");
  });

  it("is not met while it is hidden", () => {
    expect(kindAt(-50, -60, ["surface"], { stencil: square({ hidden: true }) })).toBeUndefined();
  });

  it("goes on being the same surface while it is in the hand, and comes back", () => {
    const stencil = square();
    stencil.hold(0, ([x, y, z]) => [x + 300, y, z]);
    expect(kindAt(-50, -60, ["surface"], { stencil })).toBeUndefined();
    // Edge on.
    stencil.hold(0, ([x, y, z]) => [-y, x, z]);
    expect(kindAt(-50, -60, ["surface"], { stencil })).toBeUndefined();
    stencil.hold(0, null);
    expect(kindAt(-50, -60, ["surface"], { stencil })).toBe("surface");
  });
});

describe("what comes first", () => {
  it("is a vertex, then the stencil's own corners and rims, then edges, then its surface", () => {
    expect(kindAt(3, 53)).toBe("vertex");
    expect(kindAt(97, 96)).toBe("stencil-vertex");
    expect(kindAt(97, 20)).toBe("stencil-edge");
    expect(kindAt(30, 53)).toBe("edge");
    expect(kindAt(-50, -60)).toBe("surface");
  });

  it("is the corner of the stencil before a vertex behind it at its rim, which is not covered there", () => {
    const seen = (y: number) => {
      const design = drawn(designOf([[100.4, y, 100.4]], []));
      return kindAt(100, 100, undefined, { design });
    };
    expect([seen(80), seen(0), seen(-5)]).toEqual(["stencil-vertex", "vertex", "vertex"]);
    const design = drawn(designOf([[100.4, 80, 100.4]], []));
    expect(kindAt(100, 100, ["vertex", "surface"], { design })).toBe("vertex");
  });

  it("is what is switched on", () => {
    expect(kindAt(3, 53, ["edge", "surface"])).toBe("edge");
    expect(kindAt(97, 96, ["surface", "grid"])).toBe("surface");
    expect(kindAt(97, 96, ["grid"])).toBe("grid");
    expect(kindAt(97, 96, [])).toBeUndefined();
  });

  it("leaves out what is moved, with its edges", () => {
    const without = { vertices: new Set([0]), edges: new Set<number>() };
    expect(kindAt(3, 53, undefined, { without })).toBe("surface");
  });
});

it("takes the very middle of an edge that it is near to, and any place of it beside that", () => {
  const kinds: SnapKind[] = ["edge-middle", "edge"];
  const half = snap(place(), settings(kinds), 400 + 33, 300 - 53);
  expect([half?.kind, half?.at, half?.along]).toEqual(["edge-middle", [30, -5, 50], 0.5]);
  expect(kindAt(45, 53, kinds)).toBe("edge");
  expect(kindAt(45, 53, ["edge-middle"])).toBeUndefined();
});

it("takes the ends and the middle of a construction line first, then any place of it, before the surface behind", () => {
  const construction: SnapPlace["construction"] = [
    [
      [-80, -5, 60],
      [-20, -5, 60],
    ],
  ];
  const at = (x: number, z: number, kinds: SnapKind[] = [...ALL, "construction"]) =>
    snap(place({ construction }), settings(kinds), 400 + x, 300 - z);
  expect(at(-77, 63)).toEqual({ kind: "construction", at: [-80, -5, 60] });
  expect(at(-48, 57)).toEqual({ kind: "construction", at: [-50, -5, 60] });
  const beside = at(-65, 63);
  expect([beside?.kind, beside?.at.map(Math.round)]).toEqual(["construction", [-65, -5, 60]]);
  expect(beside).not.toHaveProperty("edge");
  expect(at(-65, 63, ["surface"])?.kind).toBe("surface");
});

it("does not take the diagonal of a flat face for an edge", () => {
  expect(kindAt(0, 0, ["stencil-edge", "surface"])).toBe("surface");
});

it("does not snap to a vertex that the surface covers; without the surface it does", () => {
  expect(kindAt(40, -60)).toBe("surface");
  expect(kindAt(40, -60, undefined, { stencil: null })).toBe("vertex");
});

it("takes the rim of the surface from a little beside it", () => {
  expect(kindAt(104, 20)).toBe("stencil-edge");
  expect(kindAt(120, 20, ["stencil-edge", "surface"])).toBeUndefined();
});

it("finds the place under the pointer on the surface", () => {
  const found = snap(place(), settings(["surface"]), 400 - 50, 300 + 60);
  expect(found?.at.map((part) => Math.round(part * 1e3) / 1e3 + 0)).toEqual([-50, 0, -60]);
});

it("takes a point of the grid within reach, and the plane between them", () => {
  expect(kindAt(203, -202, ["grid", "plane"])).toBe("grid");
  expect(kindAt(205, -208, ["grid", "plane"], { projection: projectionOf("front") })).toBe("grid");
  const coarse = { ...settings(["grid", "plane"]), grid: 100 };
  expect(snap(place(), coarse, 400 + 240, 300)?.kind).toBe("plane");
  expect(snap(place(), { ...coarse, kinds: new Set<SnapKind>(["grid"]) }, 400 + 240, 300)?.at).toEqual([200, 0, 0]);
});

it("finds nothing on a plane that is seen edge on", () => {
  expect(
    kindAt(300, 0, ["grid", "plane"], { plane: { origin: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0] } }),
  ).toBeUndefined();
});

it("keeps lines to steps of 15°", () => {
  const plane = { origin: [0, 0, 0] as Vec3, u: [1, 0, 0] as Vec3, v: [0, 1, 0] as Vec3 };
  const at = inDirections(plane, [10, 0, 0], [110, 4, 0]);
  expect(at[1]).toBeCloseTo(0);
  expect(at[0]).toBeCloseTo(110);
  const slope = inDirections(plane, [0, 0, 0], [100, 97, 0]);
  expect(slope[0]).toBeCloseTo(98.5);
  expect(slope[1]).toBeCloseTo(98.5);
  // As long as the grid is apart, and along an axis without rounding.
  expect(inDirections(plane, [1, 2, 0], [0, 39, 0], 10)).toEqual([1, 42, 0]);
  expect(inDirections(plane, [1, 2, 0], [-33, 1, 0], 10)).toEqual([-29, 2, 0]);
});
