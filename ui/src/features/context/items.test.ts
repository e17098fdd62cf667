// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(async () => null), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { Played } from "../../scene/interface";
import type { MenuItem } from "../../shared/layers/Menu";
import { useDesign } from "../../state/design/design";
import { useSelection } from "../../state/design/selection";
import { useByHand } from "../../state/machine/by_hand";
import { usePlayback } from "../../state/program/program";
import { openMenu } from "../../state/window/context_menu";
import { itemsOf } from "./items";

beforeEach(() => {
  useSelection.setState({ vertices: new Set(), edges: new Set(), lines: new Set() });
  usePlayback.setState({ played: null, live: false });
  useByHand.setState({ moves: 0, played: null });
});

const labels = (items: readonly MenuItem[]) => items.flatMap((item) => (item.kind === "rule" ? [] : [item.label]));
const why = (items: readonly MenuItem[], name: string) =>
  items.flatMap((item) => (item.kind === "item" && item.label === name ? [item.why ?? null] : []))[0];

it("offers in the view what can be done with what is selected, else how to select and draw", () => {
  expect(labels(itemsOf("design"))).toContain("Draw on a plane");
  expect(labels(itemsOf("design"))).not.toContain("Merge");
  useSelection.setState({ vertices: new Set([1]), edges: new Set() });
  expect(labels(itemsOf("design"))).toContain("Merge");
  expect(why(itemsOf("design"), "Merge")).toBe("Select at least 2 vertices to merge.");
});

it("offers to measure anywhere, and to rotate and to fillet what is selected", () => {
  expect(labels(itemsOf("design"))).toContain("Measure");
  expect(labels(itemsOf("design"))).not.toContain("Rotate…");
  expect(labels(itemsOf("design"))).not.toContain("Fillet…");
  useDesign.setState({
    vertices: new Map([1, 2, 3].map((id) => [id, { id, at: [id, 0, id % 2], support: false }])),
    edges: new Map([
      [1, { id: 1, a: 1, b: 2 }],
      [2, { id: 2, a: 2, b: 3 }],
    ]),
  });
  const found = (vertex: number) => {
    useSelection.setState({ vertices: new Set([vertex]), edges: new Set() });
    return ["Measure", "Rotate…", "Fillet…"].map((name) => why(itemsOf("design"), name));
  };
  expect(found(2)).toEqual([null, null, null]);
  // The end of a wire is no corner.
  expect(found(1)).toEqual([null, null, "Select corners: vertices with two edges."]);
  useDesign.setState({ vertices: new Map(), edges: new Map() });
});

it("offers no change of the design while a program is shown", () => {
  usePlayback.setState({ played: {} as Played, live: true });
  expect(labels(itemsOf("design"))).toEqual(["Play or pause", "Back to the design", "Frame all"]);
  expect(why(itemsOf("design"), "Back to the design")).toBe("A machine is bending the wire.");
});

it("offers no change of the design while the wire of moves by hand is shown, but to hide it", () => {
  useByHand.setState({ moves: 1, played: {} as Played });
  const items = itemsOf("design");
  expect(labels(items)).toEqual(["Back to the design", "Frame all"]);
  expect(why(items, "Back to the design")).toBeNull();
  const [back] = items;
  if (back?.kind === "item") back.run();
  expect(useByHand.getState()).toEqual({ moves: 1, played: null });
  expect(labels(itemsOf("design"))).toContain("Draw on a plane");
});

it("offers in a field what can be done with what is selected in it, and says why not", () => {
  document.body.innerHTML = '<input value="12.5">';
  const field = document.querySelector("input") as HTMLInputElement;
  field.focus();
  field.setSelectionRange(0, 0);
  openMenu("field", { x: 0, y: 0 });
  expect(why(itemsOf("field"), "Copy")).toBe("Nothing is selected in the field.");
  field.readOnly = true;
  field.select();
  openMenu("field", { x: 0, y: 0 });
  expect([why(itemsOf("field"), "Copy"), why(itemsOf("field"), "Paste")]).toEqual([
    null,
    "The field cannot be changed now.",
  ]);
});

it("makes construction lines of edges, and edges of lines where these alone are selected", () => {
  const made = () => labels(itemsOf("design")).find((label) => label.startsWith("Make"));
  useDesign.setState({ edges: new Map([[1, { id: 1, a: 1, b: 2 }]]) });
  useSelection.setState({ lines: new Set([0]) });
  expect([made(), why(itemsOf("design"), "Make edges")]).toEqual(["Make edges", null]);
  // A line is moved and deleted, and has nothing to be merged or copied.
  expect(["Move", "Delete", "Rotate…"].map((name) => why(itemsOf("design"), name))).toEqual([null, null, null]);
  expect(why(itemsOf("design"), "Copy")).toBe("Select vertices or edges first.");
  useSelection.setState({ edges: new Set([1]) });
  expect(made()).toBe("Make construction lines");
  useDesign.setState({ edges: new Map() });
});
