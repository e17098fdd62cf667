// @vitest-environment happy-dom
import { act } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../shared/testing";
import type { Question } from "../../state/operator";
import { useRun } from "../../state/run";
import { QuestionDialog } from "./QuestionDialog";

const at = place();
const question = (id: number, kind: Question["kind"]): Question => ({ id, kind, lines: [], question: "Was it made?", doubt: null });
const press = (name: string) => act(() => [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === name)?.click());
const answers = (): unknown[] => platform.ask.mock.calls.filter(([ask]) => ask === "answer").map(([, { question: id }]) => id);

beforeEach(() => {
  vi.useFakeTimers();
  platform.ask.mockReset().mockResolvedValue({});
});
afterEach(() => {
  vi.useRealTimers();
  useRun.setState({ question: null, ordering: false });
});

it("takes no second click of a double one for an answer to the next question about a step", () => {
  useRun.setState({ question: question(1, "doubt") });
  at.show(<QuestionDialog />);
  press("It was made");
  expect(answers()).toEqual([]);
  act(() => vi.advanceTimersByTime(800));
  press("It was made");
  act(() => useRun.setState({ question: question(2, "doubt"), ordering: false }));
  press("It was made");
  expect(answers()).toEqual([1]);
  act(() => vi.advanceTimersByTime(800));
  press("It was made");
  expect(answers()).toEqual([1, 2]);
});

it("lets any other question be answered at once", () => {
  useRun.setState({ question: question(3, "arm") });
  at.show(<QuestionDialog />);
  press("Arm");
  expect(answers()).toEqual([3]);
});
