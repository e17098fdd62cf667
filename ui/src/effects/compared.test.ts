// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from "vitest";

vi.mock("../platform", () => ({
  platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {},
}));

import { type DesignState, useDesign } from "../state/design/design";
import { type Compared, useMachines } from "../state/machine/machines";
import { followDesign } from "./design";

const state = { machine: "kit", material: "al", name: "A" } as DesignState;
const compared: Compared = { machine: "pensa", asked: "panel", from: null, to: null, problem: null };

let end = () => {};
beforeEach(() => {
  useDesign.setState({ state });
  useMachines.setState({ compared });
  end = followDesign();
});
afterEach(() => end());

it.each([{ machine: "other" }, { material: "steel" }])(
  "what was compared with another machine is gone when the design has another one: %o",
  (other) => {
    useDesign.setState({ state: { ...state, ...other } });
    expect(useMachines.getState().compared).toBeNull();
  },
);

it("stays while only the name or the file is another", () => {
  useDesign.setState({ state: { ...state, name: "B", changed: true } });
  expect(useMachines.getState().compared).toBe(compared);
});
