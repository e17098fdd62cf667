// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn(), setTitle: vi.fn() }));
vi.mock("../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { type DesignState, useDesign } from "../state/design/design";
import { designState } from "../state/testing";
import { useUi } from "../state/window/ui";
import { useUnits } from "../state/window/units";
import { useView } from "../state/window/view";
import { followWindow } from "./window";

let end = () => {};
beforeEach(() => {
  useUi.setState({ unit: null });
  useDesign.setState({ state: null });
  end = followWindow();
});
afterEach(() => end());

it("the grid is a round figure of what is shown, where the person has set none", () => {
  useUnits.setState({ unit: "inch" });
  // A quarter of an inch.
  expect(useView.getState().grid).toBe(6.35);
  useUnits.setState({ unit: "mm" });
  expect(useView.getState().grid).toBe(5);
  useView.setState({ grid: 8 });
  useUnits.setState({ unit: "inch" });
  expect(useView.getState().grid).toBe(8);
});

const show = (units: DesignState["units"]) => useDesign.setState({ state: { units, name: "" } as DesignState });

describe("lengths", () => {
  it("are shown as the design says, as long as the person has not chosen", () => {
    show("inch");
    expect(useUnits.getState().unit).toBe("inch");
    show("mm");
    expect(useUnits.getState().unit).toBe("mm");
  });

  it("stay as the person has chosen, whatever is opened", () => {
    show("mm");
    useUi.getState().setUnit("inch");
    expect(useUnits.getState().unit).toBe("inch");
    show("mm");
    expect(useUnits.getState().unit).toBe("inch");
  });
});

it("has messages worded in the unit that is shown, from the start, asking for one at a time", async () => {
  await vi.waitFor(() => expect(platform.ask).toHaveBeenLastCalledWith("show-lengths", { unit: "mm" }));
  platform.ask.mockClear();
  let answer = () => {};
  platform.ask.mockReturnValueOnce(new Promise<void>((done) => (answer = done)));
  useUi.getState().setUnit("inch");
  useUi.getState().setUnit("mm");
  useUi.getState().setUnit("inch");
  useUi.getState().setUnit("mm");
  expect(platform.ask.mock.calls).toEqual([["show-lengths", { unit: "inch" }]]);
  answer();
  // The last one counts, whatever was asked first.
  await vi.waitFor(() => expect(platform.ask.mock.calls.at(-1)).toEqual(["show-lengths", { unit: "mm" }]));
});

it("the title is the design's, with a mark where it is not saved", () => {
  useDesign.setState({ state: designState({ name: "House", changed: true }) });
  expect(platform.setTitle).toHaveBeenLastCalledWith("• House – WireBend-kit");
  useDesign.setState({ state: designState({ name: "" }) });
  expect(platform.setTitle).toHaveBeenLastCalledWith("New design – WireBend-kit");
});

it("how the window stands is kept, and the theme is shown", () => {
  useUi.getState().setTheme("light");
  expect(document.documentElement.dataset.theme).toBe("light");
  useUi.getState().setTheme("dark");
  expect(document.documentElement.dataset.theme).toBe("dark");
  expect(JSON.parse(localStorage.getItem("wirebend.ui") ?? "{}")).toMatchObject({ theme: "dark" });
});
