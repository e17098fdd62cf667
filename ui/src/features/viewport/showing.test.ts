// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { designOf } from "../../scene/testing";
import type { Viewport } from "../../scene/viewport";
import { useDesign } from "../../state/design";
import { useFiles } from "../../state/files";
import { useView } from "../../state/view";
import { show } from "./showing";

/** A view that does nothing but count how often it turns to everything. */
const frame = vi.fn();
const scene = new Proxy({ frame } as unknown as Viewport, { get: (target, name) => (name === "frame" ? target.frame : () => {}) });
const EMPTY = designOf([], []);
const EDGE = designOf([[0, 0, 0], [400, 0, 0]], [[0, 1]]);
let end = () => {};

beforeEach(() => {
  useDesign.setState({ ...EMPTY, stencil: null, check: null });
  useView.setState({ tool: "select" });
  end = show(scene);
  frame.mockClear();
});
afterEach(() => end());

function open(design: typeof EMPTY): void {
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
])("does not turn away under the first edge that is drawn on nothing, the tool being taken up %s", (_, before, after) => {
  before();
  open(designOf([], []));
  after();
  frame.mockClear();
  useDesign.setState({ ...EDGE });
  expect(frame).not.toHaveBeenCalled();
});
