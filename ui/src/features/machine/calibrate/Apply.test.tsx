// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
const edit = vi.hoisted(() => vi.fn());
vi.mock("../../../platform", () => ({ platform: { ask }, Refused: class Refused extends Error {} }));
vi.mock("../../../state/design/design", async (original) => ({ ...(await original<object>()), edit }));

import type { CalibrationRow } from "../../../generated/responses";
import { place } from "../../../shared/testing";
import {
  enterReading,
  openCalibration,
  openSheet,
  showStep,
  useCalibration,
} from "../../../state/calibration/calibration";
import { useDesign } from "../../../state/design/design";
import { designState } from "../../../state/testing";
import { CalibrationDialog } from "./CalibrationDialog";
import { NOTHING_FITTED } from "./testing";

const at = place();
const text = () => at.host.textContent ?? "";
const button = (name: string) =>
  [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent?.trim() === name);
const press = (name: string) => act(async () => button(name)?.click());
const GIVEN = "The design was given my-kit with my-wire";
const SINCE = "The readings were changed since. Apply again to take them.";
let readings: (number | null)[];
const row = (): CalibrationRow =>
  ({ line: 5, coupon: "angle-40", row: 1, what: "bend", unit: "deg", wanted: 40, commanded: 60, readings }) as never;

beforeEach(async () => {
  HTMLDialogElement.prototype.showModal ??= () => {};
  readings = [38];
  ask.mockReset().mockImplementation(async (name: string, request: { readings?: string[] }) => {
    if (name === "calibrate-sheet")
      return { sheet: "/c/sheet.csv", machine: "kit", material: "wire", rows: [row()], jobs: [] };
    if (name === "calibrate-enter") readings = [Number(request.readings?.[0]?.split("=")[1])];
    if (name === "calibrate-fit") return NOTHING_FITTED;
    if (name === "apply-calibration")
      return {
        machine: "my-kit",
        material: "my-wire",
        files: ["/p/my-kit.json"],
        report: { kinds: [], left_out: [], doubts: [], gaps: [] },
      };
    return { machines: [], materials: [], values: [], misfits: [] };
  });
  edit.mockReset().mockImplementation(async ({ machine, material }) => {
    useDesign.setState({ state: designState({ machine, material }) });
    return {};
  });
  localStorage.clear();
  useCalibration.setState(useCalibration.getInitialState());
  useDesign.setState({ state: designState({ machine: "kit", material: "wire" }) });
  openCalibration();
  await openSheet("/c/sheet.csv", "measure");
  showStep("apply");
  at.show(<CalibrationDialog />);
});

it("says that readings were changed since, until they are as they were or are applied", async () => {
  await press("Apply");
  expect(text()).toContain(GIVEN);
  expect(text()).toContain("/p/my-kit.json");
  await act(() => enterReading(row(), 0, 37));
  expect(text()).toContain(GIVEN);
  expect(text()).toContain(SINCE);
  await act(() => enterReading(row(), 0, 38));
  expect(text()).not.toContain(SINCE);
  await act(() => enterReading(row(), 0, 37));
  await press("Apply");
  expect(text()).not.toContain(SINCE);
});

it("takes back what was applied before the dialog was closed", async () => {
  await press("Apply");
  await press("Done");
  expect(text()).toBe("");
  await act(async () => openCalibration());
  await act(async () => showStep("apply"));
  expect(button("Take back")?.getAttribute("aria-disabled")).toBeNull();
  await press("Take back");
  expect(text()).toContain("The design was given kit again");
  expect(text()).toContain("Nothing is applied.");
});

it("says where there is nothing to take back any more", async () => {
  await press("Apply");
  act(() => useDesign.setState({ state: designState({ machine: "other", material: "wire" }) }));
  expect(button("Take back")?.title).toBe("The design has another machine or wire by now.");
});
