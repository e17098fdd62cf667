// @vitest-environment happy-dom
import { act } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";

vi.mock("../../platform", () => ({
  platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {},
}));

import { place } from "../../shared/testing";
import { tell, useProblems } from "../../state/asking/problems";
import { useDesign } from "../../state/design/design";
import { useSelection } from "../../state/design/selection";
import { useView } from "../../state/window/view";
import { Problems } from "./Problems";

const at = place();

beforeEach(() => {
  vi.useFakeTimers();
  useProblems.setState({ problems: [] });
  at.show(<Problems />);
});
afterEach(() => {
  vi.useRealTimers();
  useView.setState({ handle: null });
});

const box = () => at.host.querySelector<HTMLElement>(".problems") as HTMLElement;
const texts = () => [...at.host.querySelectorAll("li:not(.gone) p")].map(({ textContent }) => textContent);
const pass = (ms: number) => act(() => void vi.advanceTimersByTime(ms));
const say = (severity: "info" | "warning" | "error", ...messages: string[]) =>
  act(() => messages.forEach((message) => tell(severity, message)));
const point = (over: boolean) =>
  act(() => {
    box().dispatchEvent(new PointerEvent(over ? "pointerover" : "pointerout", { bubbles: true }));
    if (over) box().dispatchEvent(new PointerEvent("pointermove", { clientX: 9, clientY: 9, bubbles: true }));
  });
const press = (name: string) =>
  act(() =>
    [...at.host.querySelectorAll("button")]
      .find((button) => (button.getAttribute("aria-label") ?? button.textContent) === name)
      ?.click(),
  );

it("goes by itself, sooner what is only news", () => {
  say("info", "saved");
  say("warning", "no backup");
  say("error", "no file");
  expect(texts()).toEqual(["no file", "no backup", "saved"]);
  pass(8000);
  expect(texts()).toEqual(["no file", "no backup"]);
  pass(12_000);
  expect(texts()).toEqual(["no file"]);
  pass(20_000);
  expect(texts()).toEqual([]);
});

it("shows three, says how many more, and all are dismissed at once", () => {
  say("error", "1", "2", "3", "4", "5");
  expect(texts()).toEqual(["5", "4", "3"]);
  expect(box().textContent).toContain("2 more");
  press("Dismiss all");
  expect(useProblems.getState().problems).toEqual([]);
});

it("neither goes nor moves while the pointer is on it", () => {
  say("info", "1", "2");
  point(true);
  pass(60_000);
  // Above them there is room for one more, and not for another.
  say("error", "3", "4");
  expect(texts()).toEqual(["4", "2", "1"]);
  const dismiss = at.host.querySelectorAll<HTMLButtonElement>('[aria-label="Dismiss"]');
  act(() => dismiss[1]?.click());
  // Its place stays empty, so that the next one is not under the pointer.
  expect(texts().at(-1)).toBe("1");
  expect(at.host.querySelectorAll("li.gone")).toHaveLength(1);
  point(false);
  expect(texts()).toEqual(["4", "3", "1"]);
});

it("does not wait for a pointer that rests where the first has come", () => {
  say("info", "1", "2", "3");
  act(() => void box().dispatchEvent(new PointerEvent("pointerover", { bubbles: true })));
  say("error", "4");
  expect(texts()).toEqual(["4", "3", "2"]);
});

it("is at the upper edge where it would cover what is selected", () => {
  const handle = { screen: () => ({ x: 0, y: 0 }) } as unknown as ReturnType<typeof useView.getState>["handle"];
  useDesign.setState({ vertices: new Map([[1, { id: 1, at: [0, 0, 0], support: false }]]), edges: new Map() });
  Object.defineProperty(HTMLElement.prototype, "offsetParent", { get: () => document.body, configurable: true });
  const topped = () => box().className === "problems top";
  useView.setState({ handle });
  useSelection.setState({ vertices: new Set(), edges: new Set() });
  say("error", "1");
  expect(topped()).toBe(false);
  press("Dismiss");
  useSelection.setState({ vertices: new Set([1]), edges: new Set() });
  say("error", "2");
  expect(topped()).toBe(true);
});

const focus = (name: string) =>
  act(() =>
    [...at.host.querySelectorAll("button")]
      .find((button) => (button.getAttribute("aria-label") ?? button.textContent) === name)
      ?.focus(),
  );

it.each([
  ["Dismiss all", []],
  ["Dismiss", ["1"]],
])("does not hold those that come later for the focus that went with the button “%s”", (name, left) => {
  say("info", "1", "2");
  focus(name);
  press(name);
  expect(texts()).toEqual(left);
  expect(at.host.querySelectorAll("li.gone")).toHaveLength(0);
  say("info", "later");
  expect(texts()).toEqual(["later", ...left]);
  pass(8000);
  expect(texts()).toEqual([]);
});

it("leaves no place empty under the pointer once the last is dismissed: a click there is one on the view", () => {
  say("info", "1");
  point(true);
  press("Dismiss");
  expect(at.host.querySelectorAll("li")).toHaveLength(0);
  say("info", "later");
  pass(8000);
  expect(texts()).toEqual([]);
});

it("does not keep what is out of sight for later: many wrong files are not reported one by one for minutes", () => {
  say("error", "1", "2", "3", "4", "5");
  pass(40_000);
  expect(texts()).toEqual([]);
});

it("keeps what a person has to do something about until it is dismissed", () => {
  act(() => tell("error", "connect again", "", true));
  say("error", "no file");
  pass(3_600_000);
  expect(texts()).toEqual(["connect again"]);
  press("Dismiss");
  expect(texts()).toEqual([]);
});
