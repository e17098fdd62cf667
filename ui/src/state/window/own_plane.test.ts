import { beforeEach, expect, it, vi } from "vitest";

vi.mock("../../platform", () => ({ platform: {}, Refused: class Refused extends Error {} }));

import type { Vec3 } from "../../scene/interface";
import { useDesign } from "../design/design";
import { select } from "../design/selection";
import { run } from "./commands";
import { choosePlane, drawnPlane, normalOf, putPlane, takePlanePoints, useView } from "./view";

const PLACES: readonly Vec3[] = [
  [10, 0, 0],
  [10, 30, 40],
  [-50, 0, 0],
  [10, 60, 80],
];

beforeEach(() => {
  useDesign.setState({ vertices: new Map(PLACES.map((at, id) => [id, { id, at, support: false }])), edges: new Map() });
  useView.setState({ plane: "xz", ownPlane: null, planeOffset: 5, tool: "draw", strand: null });
  select([]);
});

const drawn = () => drawnPlane(useView.getState());

it("lies through three selected vertices, with its first axis from the first to the second", () => {
  select([0, 1, 2]);
  putPlane();
  expect(drawn()).toMatchObject({ origin: [10, 0, 0], u: [0, 0.6, 0.8] });
  for (const at of PLACES.slice(0, 3)) {
    const off = at.map((value, k) => value - (drawn().origin[k] ?? NaN));
    expect(off.reduce((sum, value, k) => sum + value * (normalOf(drawn())[k] ?? NaN), 0)).toBeCloseTo(0, 9);
  }
  // To the side of the third, and of length 1.
  expect(drawn().v).toEqual([-1, 0, 0]);
  // The offset is along its normal, u × v: here (0, −0.8, 0.6).
  useView.setState({ planeOffset: 10 });
  drawn().origin.forEach((value, k) => expect(value).toBeCloseTo([10, -8, 6][k] ?? NaN, 9));
});

it("asks for three clicks where no three vertices are selected that are not in line", () => {
  for (const ids of [[], [0, 1], [0, 1, 2, 3], [0, 1, 3]]) {
    useView.setState({ tool: "draw" });
    select(ids);
    putPlane();
    expect([useView.getState().ownPlane, useView.getState().tool]).toEqual([null, "plane"]);
  }
});

it("is put on the points that were clicked, and drawn on then", () => {
  putPlane();
  const points = PLACES.slice(0, 3).map((at, index) => ({ at, vertex: index === 1 ? 1 : null }));
  for (const count of [1, 2]) {
    takePlanePoints(points.slice(0, count));
    expect(useView.getState()).toMatchObject({ planePoints: count, ownPlane: null, tool: "plane" });
  }
  takePlanePoints(points);
  expect(useView.getState()).toMatchObject({ planePoints: 0, planeOffset: 0, tool: "draw" });
  expect(useView.getState().ownPlane?.through).toEqual([null, 1, null]);
  expect(drawn()).toMatchObject({ origin: [10, 0, 0], u: [0, 0.6, 0.8], v: [-1, 0, 0] });
});

it("gives way to a plane of the axes, and to a view that would see it from its edge", () => {
  const view = vi.fn();
  useView.setState({ handle: { view } as unknown as NonNullable<ReturnType<typeof useView.getState>["handle"]> });
  select([0, 1, 2]);
  putPlane();
  // Its normal is at right angles to x, which the right side looks along.
  run("view-front");
  expect(useView.getState().ownPlane).not.toBeNull();
  run("view-right");
  expect([useView.getState().ownPlane, useView.getState().plane]).toEqual([null, "yz"]);
  putPlane();
  choosePlane("xy");
  expect(drawn()).toMatchObject({ u: [1, 0, 0], v: [0, 1, 0] });
});
