// @vitest-environment happy-dom
import { act } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../../shared/testing";
import type { Doubt, Question } from "../../../state/machine/operator";
import { useRun } from "../../../state/machine/run";
import { QuestionDialog } from "./QuestionDialog";

const at = place();
const question = (id: number, kind: Question["kind"]): Question => ({
  id,
  kind,
  lines: [],
  question: "May it move?",
  doubt: null,
  head: null,
});
const told = { feed_mm: 222.8, rotate_deg: 90, bend_deg: 45 };
const doubtful = (id: number, counted: Doubt["counted"]): Question => ({
  ...question(id, "doubt"),
  doubt: {
    wire: 0,
    step: 5,
    of: 10,
    last: 5,
    designed: told,
    told,
    before: { feed_mm: 0, rotate_deg: 0 },
    counted,
    in_step: 0,
  },
});
const typeOn = (field: HTMLInputElement, text: string) =>
  act(() => {
    field.focus();
    // React listens to the setter of the prototype.
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field, text);
    field.dispatchEvent(new Event("input", { bubbles: true }));
  });
const type = (field: HTMLInputElement, text: string) => {
  typeOn(field, text);
  act(() => field.blur());
};
const choose = (name: string) =>
  act(() =>
    [...at.host.querySelectorAll("label")]
      .find(({ textContent }) => textContent === name)
      ?.querySelector("input")
      ?.click(),
  );
const given = (): unknown[] =>
  platform.ask.mock.calls.filter(([ask]) => ask === "answer").map(([, { answer }]) => answer);
const press = (name: string) =>
  act(() => [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === name)?.click());
const answers = (): unknown[] =>
  platform.ask.mock.calls.filter(([ask]) => ask === "answer").map(([, { question: id }]) => id);

beforeEach(() => {
  vi.useFakeTimers();
  platform.ask.mockReset().mockResolvedValue({});
});
afterEach(() => {
  vi.useRealTimers();
  useRun.setState({ question: null, ordering: false });
});

it("takes no second click of a double one for an answer to the next question about a step", () => {
  useRun.setState({ question: doubtful(1, null) });
  at.show(<QuestionDialog />);
  choose("All of it");
  press("Continue");
  expect(answers()).toEqual([]);
  act(() => vi.advanceTimersByTime(800));
  press("Continue");
  act(() => useRun.setState({ question: doubtful(2, null), ordering: false }));
  choose("All of it");
  press("Continue");
  expect(answers()).toEqual([1]);
  act(() => vi.advanceTimersByTime(800));
  press("Continue");
  expect(answers()).toEqual([1, 2]);
  expect(given()).toEqual(["made", "made"]);
});

it("finishes a step only when a person has said how much of it is in the wire", () => {
  useRun.setState({ question: doubtful(1, { feed_mm: 110.3, rotate_deg: 0 }) });
  at.show(<QuestionDialog />);
  act(() => vi.advanceTimersByTime(800));
  press("Continue");
  expect(given()).toEqual([]);
  choose("As counted");
  expect(at.host.textContent).toContain("feed 112.5 mm, rotate 90.0°, bend 45.0° from its beginning");
  press("Continue");
  expect(given()).toEqual(["as-counted"]);
});

it("offers nothing as counted where the machine does not count it, and takes what is measured", () => {
  useRun.setState({ question: doubtful(1, null) });
  at.show(<QuestionDialog />);
  act(() => vi.advanceTimersByTime(800));
  expect(at.host.textContent).not.toContain("As counted");
  choose("Measured");
  press("Continue");
  expect(given()).toEqual([]);
  const [fed, turned] = at.host.querySelectorAll<HTMLInputElement>("input[inputmode]");
  for (const [field, text] of [
    [fed, "110.3"],
    [turned, "30"],
  ] as const)
    if (field) type(field, text);
  press("Continue");
  expect(given()).toEqual([{ part: { feed_mm: 110.3, rotate_deg: 30 } }]);
});

it("follows what is typed: Continue can be pressed with the field still being typed in, and not with less than a number", () => {
  useRun.setState({ question: doubtful(1, { feed_mm: 110.3, rotate_deg: 30 }) });
  at.show(<QuestionDialog />);
  act(() => vi.advanceTimersByTime(800));
  choose("Measured");
  const go = () => [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === "Continue");
  const [fed] = at.host.querySelectorAll<HTMLInputElement>("input[inputmode]");
  if (!fed) throw new Error("no field");
  typeOn(fed, "59.6");
  expect(go()?.getAttribute("aria-disabled")).toBeNull();
  expect(at.host.textContent).toContain("feed 163.2 mm, rotate 60.0°, bend 45.0° from its beginning");
  for (const wrong of ["", "59.6 x", "1000"]) {
    typeOn(fed, wrong);
    expect(go()?.title).toBe("Type what you measure.");
    press("Continue");
  }
  expect(given()).toEqual([]);
  typeOn(fed, "59.6");
  press("Continue");
  expect(given()).toEqual([{ part: { feed_mm: 59.6, rotate_deg: 30 } }]);
});

it("takes where the head stands, once it was said, and nothing beyond its cable", () => {
  useRun.setState({ question: { ...question(4, "head"), head: { range_deg: [-360, 360], left_at_deg: null } } });
  at.show(<QuestionDialog />);
  press("It stands there");
  expect(answers()).toEqual([]);
  const field = at.host.querySelector("input");
  if (!field) throw new Error("no field");
  type(field, "400");
  press("It stands there");
  expect(answers()).toEqual([]);
  type(field, "-62.5");
  press("It stands there");
  expect(platform.ask.mock.calls).toEqual([["answer", { question: 4, answer: { head: -62.5 } }]]);
});

it("offers where the head was left, which is confirmed by one press", () => {
  useRun.setState({ question: { ...question(5, "head"), head: { range_deg: [-360, 360], left_at_deg: 90 } } });
  at.show(<QuestionDialog />);
  expect(at.host.querySelector("input")?.value).toBe("90.0");
  press("It stands there");
  expect(platform.ask.mock.calls).toEqual([["answer", { question: 5, answer: { head: 90 } }]]);
});

it("lets any other question be answered at once", () => {
  useRun.setState({ question: question(3, "arm") });
  at.show(<QuestionDialog />);
  press("Arm");
  expect(answers()).toEqual([3]);
});
