// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
vi.mock("../../../platform", () => ({ platform: { ask }, Refused: class Refused extends Error {} }));

import type { CalibrationReport } from "../../../generated/responses";
import { place } from "../../../shared/testing";
import { openCalibration, openSheet, useCalibration } from "../../../state/calibration/calibration";
import { Fit } from "./Fit";
import { NOTHING_FITTED } from "./testing";

const at = place();
const ROW = {
  line: 5,
  coupon: "angle-40",
  row: 1,
  what: "bend",
  unit: "deg",
  wanted: 40,
  commanded: 60,
  readings: [38],
};
const off = { rms: 0.5, mean_abs: 0.4 };
const bends = { kind: "bends", readings: 2, unit: "deg", rank: 1, scatter: 0.1 } as const;

beforeEach(() => {
  ask.mockReset().mockImplementation(async (name: string, request: { shape?: string | null }) => {
    if (name === "calibrate-sheet")
      return { sheet: "/c/sheet.csv", machine: "kit", material: "wire", rows: [ROW], jobs: [] };
    // Of a machine without a curve there is none that could be moved.
    const shape = request.shape === "curve" ? "curve" : "constant";
    const kinds = [{ ...bends, before: off, after: off, leave_one_out: off, parameters: [], values: [] }];
    return { ...NOTHING_FITTED, kinds, shape } satisfies CalibrationReport;
  });
  useCalibration.setState(useCalibration.getInitialState());
});

it("asks for the shape that is chosen, and says where another one was fitted", async () => {
  openCalibration();
  await openSheet("/c/sheet.csv", "fit");
  at.show(<Fit />);
  const choose = (label: string) =>
    act(async () => {
      [...at.host.querySelectorAll("label")].find(({ textContent }) => textContent === label)?.click();
    });
  const asked = () => ask.mock.calls.at(-1);
  expect(at.host.textContent).toContain("one angle: for an angle that it has not seen");
  await choose("Curve");
  expect(asked()).toEqual(["calibrate-fit", { sheet: "/c/sheet.csv", shape: "curve" }]);
  expect(at.host.textContent).not.toContain("a curve: for an angle");
  await choose("Profile's curve, moved");
  expect(asked()).toEqual(["calibrate-fit", { sheet: "/c/sheet.csv", shape: "moved" }]);
  expect(at.host.textContent).toContain("one angle: for an angle that it has not seen");
});
