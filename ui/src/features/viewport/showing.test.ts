// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { SceneDesign } from "../../scene/interface";
import type { Viewport } from "../../scene/viewport";
import { useDesign } from "../../state/design/design";
import { useFiles } from "../../state/files/files";
import { useView } from "../../state/window/view";
import { show } from "./showing";

/** A view that does nothing but count how often it turns to everything. */
const frame = vi.fn();
const scene = new Proxy({ frame } as unknown as Viewport, {
  get: (target, name) => (name === "frame" ? target.frame : () => {}),
});
const empty = (): SceneDesign => ({ vertices: new Map(), edges: new Map() });
const vertex = (id: number, x: number) => [id, { id, at: [x, 0, 0] as const, support: false }] as const;
const EDGE: SceneDesign = {
  vertices: new Map([vertex(0, 0), vertex(1, 400)]),
  edges: new Map([[0, { id: 0, a: 0, b: 1 }]]),
};
let end = () => {};

beforeEach(() => {
  useDesign.setState({ ...empty(), stencil: null, check: null });
  useView.setState({ tool: "select" });
  end = show(scene);
  frame.mockClear();
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
