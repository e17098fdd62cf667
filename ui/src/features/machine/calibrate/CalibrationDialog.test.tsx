// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
vi.mock("../../../platform", () => ({ platform: { ask }, Refused: class Refused extends Error {} }));

import type { CalibrationRow } from "../../../generated/responses";
import { place } from "../../../shared/testing";
import { openCalibration, openSheet, useCalibration } from "../../../state/calibration/calibration";
import { useDesign } from "../../../state/design/design";
import { designState } from "../../../state/testing";
import { CalibrationDialog } from "./CalibrationDialog";
import { NOTHING_FITTED } from "./testing";

const at = place();
let readings: (number | null)[];
let leftOut: object[];

const row = (): CalibrationRow =>
  ({ line: 5, coupon: "angle-40", row: 1, what: "bend", unit: "deg", wanted: 40, commanded: 60, readings }) as never;

beforeEach(() => {
  HTMLDialogElement.prototype.showModal ??= () => {};
  readings = [null, null];
  leftOut = [];
  ask.mockReset();
  ask.mockImplementation(async (name: string, request: { readings?: string[] }) => {
    if (name === "calibrate-sheet")
      return { sheet: "/c/sheet.csv", machine: "wirebend-kit", material: "steel-1mm", rows: [row()], jobs: [] };
    if (name === "calibrate-enter") {
      const [, cells = ""] = request.readings?.[0]?.split("=") ?? [];
      readings = cells.split(",").map((cell) => (cell === "-" ? null : Number(cell)));
      return {};
    }
    if (name === "calibrate-fit") return { ...NOTHING_FITTED, left_out: leftOut };
    return { machines: [], materials: [] };
  });
  localStorage.clear();
  useCalibration.setState(useCalibration.getInitialState());
  useDesign.setState({ state: designState({ machine: "wirebend-kit", material: "steel-1mm" }) });
});

const cell = (reading: number) =>
  at.host.querySelector<HTMLInputElement>(`[aria-label="angle-40, row 1, reading ${reading}"]`);
const type = (reading: number, text: string) =>
  act(async () => {
    const field = cell(reading) as HTMLInputElement;
    field.focus();
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field, text);
    field.dispatchEvent(new Event("input", { bubbles: true }));
    field.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
    await vi.waitFor(() => expect(ask.mock.calls.at(-1)?.[0]).not.toBe("calibrate-enter"));
  });
const show = async () => {
  openCalibration();
  at.show(<CalibrationDialog />);
  await act(() => openSheet("/c/sheet.csv", "measure"));
};
const entered = () => ask.mock.calls.filter(([name]) => name === "calibrate-enter").map(([, request]) => request);

it("enters a row with what is missing in it, as the command does", async () => {
  await show();
  await type(2, "38,5");
  expect(entered()).toEqual([{ sheet: "/c/sheet.csv", readings: ["angle-40:1=-,38.5"] }]);
  expect(at.host.textContent).toContain("1 of 2 readings entered");
});

it("keeps what is no number in its cell and enters nothing", async () => {
  await show();
  await act(async () => {
    const field = cell(1) as HTMLInputElement;
    field.focus();
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field, "3o");
    field.dispatchEvent(new Event("input", { bubbles: true }));
    field.blur();
  });
  expect(cell(1)?.value).toBe("3o");
  expect(cell(1)?.getAttribute("aria-invalid")).toBe("true");
  expect(entered()).toEqual([]);
});

it("names a reading that is left out in its cell and below, with the reason", async () => {
  await show();
  const message = "385.0° cannot be; about 40.0° was to be expected";
  leftOut = [{ kind: "bends", line: 5, reading: 1, coupon: "angle-40", read: 385, expected: 40, message }];
  await type(1, "385");
  expect(cell(1)?.title).toBe(message);
  expect(at.host.querySelector(".calibrate-notes")?.textContent).toContain(`angle-40, reading 1: ${message}`);
});

it("says why a step has to wait", async () => {
  openCalibration();
  at.show(<CalibrationDialog />);
  const next = [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === "Next");
  expect(next?.getAttribute("aria-disabled")).toBe("true");
  expect(at.host.textContent).toContain("The files that are made are listed here.");
});
