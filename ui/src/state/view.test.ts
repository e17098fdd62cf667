// @vitest-environment happy-dom
import { expect, it, vi } from "vitest";

vi.mock("../platform", () => ({ platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }, Refused: class Refused extends Error {} }));

import { useUnitStore } from "../shared/unit";
import { useView } from "./view";

it("the grid is a round figure of what is shown, where the person has set none", () => {
  useUnitStore.setState({ unit: "inch" });
  // A quarter of an inch.
  expect(useView.getState().grid).toBe(6.35);
  useUnitStore.setState({ unit: "mm" });
  expect(useView.getState().grid).toBe(5);
  useView.setState({ grid: 8 });
  useUnitStore.setState({ unit: "inch" });
  expect(useView.getState().grid).toBe(8);
});
