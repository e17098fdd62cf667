// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from "vitest";

vi.mock("../platform", () => ({
  platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {},
}));

import { platform } from "../platform";
import { useDesign } from "../state/design/design";
import { type Compared, compareWith, stopComparing, useMachines } from "../state/machine/machines";
import { designState } from "../state/testing";
import { followDesign } from "./design";

const state = designState({ machine: "kit", material: "al", name: "A" });
const compared: Compared = { machine: "pensa", asked: "panel", from: null, to: null, problem: null };

let end = () => {};
beforeEach(() => {
  useDesign.setState({ state });
  useMachines.setState({ compared });
  end = followDesign();
});
afterEach(() => end());

it.each([{ machine: "other" }, { material: "steel" }, { doublings: [5] }, { closed: true }])(
  "what was compared with another machine is gone when the wires are others: %o",
  (other) => {
    useDesign.setState({ state: { ...state, ...other } });
    expect(useMachines.getState().compared).toBeNull();
  },
);

it("is gone when a profile was changed", () => {
  useMachines.setState(({ changes }) => ({ changes: changes + 1 }));
  expect(useMachines.getState().compared).toBeNull();
});

it("is what was asked last, also of the same machine", async () => {
  const answers: ((comparison: object) => void)[] = [];
  vi.mocked(platform.ask).mockImplementation((() => new Promise((resolve) => answers.push(resolve))) as never);
  useDesign.setState({ edges: new Map([[1, { id: 1, a: 0, b: 1 }]]) });
  const comparison = (to: string) => ({ from: { machine: "kit" }, to: [{ machine: to }] });
  const first = compareWith("pensa", "panel");
  stopComparing();
  const second = compareWith("pensa", "panel");
  answers[0]?.(comparison("before"));
  await first;
  expect(useMachines.getState().compared?.to).toBeNull();
  answers[1]?.(comparison("now"));
  await second;
  expect(useMachines.getState().compared?.to).toEqual({ machine: "now" });
});

it("stays while only the name or the file is another", () => {
  useDesign.setState({ state: { ...state, name: "B", changed: true } });
  expect(useMachines.getState().compared).toBe(compared);
});
