// @vitest-environment happy-dom
import { act } from "react";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

vi.mock("../../platform", () => ({
  platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {},
}));

import type { SceneVertex, Vec3 } from "../../scene/interface";
import { place } from "../../shared/testing";
import { tell, useProblems } from "../../state/asking/problems";
import { useDesign } from "../../state/design/design";
import { highlight, select } from "../../state/design/selection";
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

describe("what a message speaks of", () => {
  const SIZE = { x: 0, y: 0, width: 800, height: 600 };
  /** At the foot of the view and at its head: a message of 560 × 60 px. */
  const FOOT = { left: 120, right: 680, top: 484, bottom: 544 };
  const HEAD = { left: 120, right: 680, top: 80, bottom: 140 };
  const inPicture = ([x, , z]: Vec3) => ({ x, y: SIZE.height - z });
  const vertex = (id: number, x: number, up: number): [number, SceneVertex] => [
    id,
    { id, at: [x, 0, up], support: false },
  ];
  const topped = () => box().classList.contains("top");
  const show = (gizmo: Vec3 | null = null) => {
    const segment = (a: Vec3, b: Vec3) => ({ a: inPicture(a), b: inPicture(b) });
    const handle = { screen: inPicture, seen: { gizmo, segment } };
    useView.setState({ handle: handle as unknown as ReturnType<typeof useView.getState>["handle"] });
  };
  const choose = (vertices: readonly number[], edges: readonly number[] = []) => act(() => select(vertices, edges));

  beforeEach(() => {
    // In the picture 1 is beside both, 2 in the way at the foot, 3 at the head; the edges 1 and 2 cross one of them from side to side.
    useDesign.setState({
      vertices: new Map([
        vertex(1, 400, 300),
        vertex(2, 400, 90),
        vertex(3, 400, 490),
        vertex(4, 20, 90),
        vertex(5, 780, 90),
        vertex(6, 20, 490),
        vertex(7, 780, 490),
      ]),
      edges: new Map([
        [1, { id: 1, a: 4, b: 5 }],
        [2, { id: 2, a: 6, b: 7 }],
      ]),
    });
    choose([]);
    Object.defineProperty(HTMLElement.prototype, "offsetParent", { get: () => document.body, configurable: true });
    vi.spyOn(HTMLElement.prototype, "getBoundingClientRect").mockImplementation(function (this: HTMLElement) {
      const rect = this.matches(".problems.top") ? HEAD : this.matches(".problems") ? FOOT : SIZE;
      return { x: 0, y: 0, left: 0, top: 0, right: 800, bottom: 600, ...rect } as DOMRect;
    });
    show();
  });
  afterEach(() => {
    vi.restoreAllMocks();
    choose([]);
  });

  it("is not covered: a vertex", () => {
    choose([1]);
    say("error", "1");
    expect(topped()).toBe(false);
    press("Dismiss");
    choose([2]);
    say("error", "2");
    expect(topped()).toBe(true);
  });

  it("is not covered: an edge whose ends are beside the message", () => {
    choose([], [1]);
    say("error", "0 mm is no length of an edge");
    expect(topped()).toBe(true);
  });

  it("is not covered: the gizmo, whose arrows reach farther than its middle", () => {
    choose([1]);
    // 44 px above the upper side of the message.
    show([400, 0, 160]);
    say("error", "1");
    expect(topped()).toBe(true);
  });

  it("is not covered by a message that was there before the one that speaks of it", () => {
    say("info", "older");
    expect(topped()).toBe(false);
    act(() => highlight([2]));
    expect(topped()).toBe(false);
    say("error", "newer");
    expect(topped()).toBe(true);
    act(() => highlight());
  });

  it("is not covered once something else is selected", () => {
    say("error", "1");
    choose([], [1]);
    expect(topped()).toBe(true);
    choose([3]);
    expect(topped()).toBe(false);
  });

  it("waits while the pointer is on a message, which does not jump away under it", () => {
    say("error", "1");
    point(true);
    choose([2]);
    say("error", "2");
    expect(topped()).toBe(false);
    point(false);
    expect(topped()).toBe(true);
  });

  it("is covered as little as can be where both places are in the way, and then nothing moves", () => {
    choose([2, 3]);
    say("error", "1");
    expect(topped()).toBe(false);
    choose([2, 3], [1]);
    expect(topped()).toBe(true);
    choose([2, 3]);
    expect(topped()).toBe(true);
  });
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
