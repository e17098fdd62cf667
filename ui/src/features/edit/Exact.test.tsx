// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { useExact } from "../../state/design/exact";
import { select } from "../../state/design/selection";
import { Exact } from "./Exact";

const at = place();

beforeEach(() => {
  platform.ask.mockReset().mockReturnValue(new Promise(() => {}));
  useExact.setState({ end: 0, side: 0, follows: true });
  useDesign.setState({
    vertices: new Map([
      [1, { id: 1, at: [0, 0, 0], support: false }],
      [2, { id: 2, at: [30, 0, 0], support: false }],
      [5, { id: 5, at: [30, 40, 0], support: false }],
    ]),
    edges: new Map([
      [3, { id: 3, a: 1, b: 2 }],
      [4, { id: 4, a: 2, b: 5 }],
    ]),
  });
  act(() => select([]));
  at.show(<Exact />);
});

const field = (label: string) => at.host.querySelector(`[aria-label="${label}"]`) as HTMLInputElement;
const length = () => field("Length of the edge, mm");
const angle = () => field("Angle between the edges, °");
const choices = (label: string) =>
  [...at.host.querySelectorAll(`[aria-label="${label}"] label`)].map(({ textContent }) => textContent);

it("has the same fields whatever is selected, and says what to select", () => {
  const reason = (field: HTMLElement) => (field.parentElement as HTMLElement).title;
  expect([reason(length()), length().readOnly]).toEqual(["Select one edge", true]);
  expect([reason(angle()), angle().readOnly]).toEqual(["Select a vertex or two edges", true]);
  expect(choices("Vertex that stays")).toEqual(["–", "–"]);
  act(() => select([], [4]));
  expect([length().value, length().readOnly, angle().readOnly]).toEqual(["40.0", false, true]);
  expect(choices("Vertex that stays")).toEqual(["2", "5"]);
  act(() => select([2]));
  expect([angle().value, angle().readOnly, length().readOnly]).toEqual(["90.0", false, true]);
  expect(choices("Edge that stays")).toEqual(["3", "4"]);
});

it("asks for the typed length, with the chosen end staying", async () => {
  act(() => select([], [4]));
  const [, second] = at.host.querySelectorAll('[aria-label="Vertex that stays"] input');
  act(() => (second as HTMLInputElement).click());
  act(() => {
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(length(), "52.5");
    length().dispatchEvent(new Event("input", { bubbles: true }));
  });
  act(() => void length().dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true })));
  await vi.waitFor(() =>
    expect(platform.ask).toHaveBeenCalledWith("edit", {
      request: { edit: "length", edge: 4, length_mm: 52.5, stays: 5, rest: "follows" },
    }),
  );
});
