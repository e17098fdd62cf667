// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { DrawingPlane, Played, SceneDesign, Vec3 } from "../../scene/interface";
import type { Viewport } from "../../scene/viewport";
import { useDesign } from "../../state/design/design";
import { useFiles } from "../../state/files/files";
import { usePlayback } from "../../state/program/program";
import { useView } from "../../state/window/view";
import { show } from "./showing";

/** A view that does nothing but count how often it turns to everything. */
const frame = vi.fn();
/** As the scene does, it reports what the view is called now. */
const named = (viewName: string) => useView.setState({ viewName });
const face = vi.fn((_: DrawingPlane) => {
  named("Top");
  return true;
});
const view = vi.fn(() => named("Perspective"));
const heard: Record<string | symbol, unknown> = { frame, face, view };
const scene = new Proxy({} as Viewport, { get: (_, name) => heard[name] ?? (() => {}) });
const empty = (): SceneDesign => ({ vertices: new Map(), edges: new Map() });
const vertex = (id: number, x: number) => [id, { id, at: [x, 0, 0] as const, support: false }] as const;
const EDGE: SceneDesign = {
  vertices: new Map([vertex(0, 0), vertex(1, 400)]),
  edges: new Map([[0, { id: 0, a: 0, b: 1 }]]),
};
let end = () => {};

beforeEach(() => {
  useDesign.setState({ ...empty(), surfaces: new Map(), check: null });
  useView.setState({ tool: "select", viewName: "Perspective" });
  end = show(scene);
  frame.mockClear();
  face.mockClear();
  view.mockClear();
});
afterEach(() => end());

function open(design: SceneDesign): void {
  useFiles.setState(({ opened }) => ({ opened: opened + 1 }));
  useDesign.setState({ ...design });
}

it("turns to what is opened", () => {
  open(EDGE);
  expect(frame).toHaveBeenCalledOnce();
});

it.each([
  ["before", () => useView.setState({ tool: "draw" }), () => {}],
  ["after", () => {}, () => useView.setState({ tool: "draw" })],
])("does not turn away under the first edge that is drawn on nothing, the tool being chosen %s", (_, before, after) => {
  before();
  open(empty());
  after();
  frame.mockClear();
  useDesign.setState({ ...EDGE });
  expect(frame).not.toHaveBeenCalled();
});

const at = (...places: Vec3[]): SceneDesign => ({
  vertices: new Map(places.map((at, id) => [id, { id, at, support: false }])),
  edges: new Map(),
});

it("turns to the plane of a flat drawing, which would be seen from its edge, and back for what is not flat", () => {
  open(at([0, 0, 5], [40, 0, 5], [40, 30, 5]));
  expect(face.mock.calls).toEqual([[{ origin: [0, 0, 5], u: [1, 0, 0], v: [0, 1, 0] }]]);
  open(at([0, 0, 0], [40, 0, 0], [40, 30, 20]));
  expect(view.mock.calls).toEqual([["perspective"]]);
  // A person's own view is left alone.
  open(at([0, 0, 0], [40, 10, 0], [40, 30, 20]));
  expect([face.mock.calls.length, view.mock.calls.length, frame.mock.calls.length]).toEqual([1, 1, 3]);
});

const FLAT = at([0, 0, 5], [40, 0, 5], [40, 30, 5]);
const SOLID = at([0, 0, 0], [40, 0, 0], [40, 30, 20]);

it.each(["Perspective", "Front", "Parallel"])(
  "leaves a view alone that a person has turned since a flat drawing was opened: %s",
  (own) => {
    open(FLAT);
    named(own);
    open(SOLID);
    expect(view).not.toHaveBeenCalled();
    expect(frame).toHaveBeenCalledTimes(2);
  },
);

it("turns back from a flat drawing although a wire was played meanwhile, which has a view of its own", () => {
  open(FLAT);
  usePlayback.setState({ played: {} as Played });
  named("Perspective");
  usePlayback.setState({ played: null });
  // The scene gives back what it showed before.
  named("Top");
  open(SOLID);
  expect(view.mock.calls).toEqual([["perspective"]]);
});

it("turns to a plane as soon as it is drawn on", () => {
  useView.setState({ plane: "xz" });
  expect(face).not.toHaveBeenCalled();
  useView.setState({ tool: "draw" });
  useView.setState({ plane: "yz" });
  expect(face.mock.calls.map(([{ v, u }]) => [u, v])).toEqual([
    [
      [1, 0, 0],
      [0, 0, 1],
    ],
    [
      [0, 1, 0],
      [0, 0, 1],
    ],
  ]);
  useView.setState({ plane: "xy" });
});
