// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
vi.mock("../platform", () => ({ platform: { ask }, Refused: class Refused extends Error {} }));

import {
  closeCalibration,
  enterReading,
  openCalibration,
  openSheet,
  showStep,
  useCalibration,
} from "../state/calibration/calibration";
import { followSheet } from "./calibration";

/** The file, which others write into, too. */
let readings: (number | null)[];
const row = () => ({ line: 5, coupon: "angle-40", row: 1, what: "bend", unit: "deg", wanted: 40, readings });
const asked = (name: string) => ask.mock.calls.filter(([one]) => one === name);
const shown = () => useCalibration.getState().sheet?.rows[0]?.readings;

let end = () => {};
beforeEach(async () => {
  localStorage.clear();
  useCalibration.setState(useCalibration.getInitialState());
  readings = [38, null];
  ask.mockReset().mockImplementation(async (name: string, request: { readings?: string[] }) => {
    if (name === "calibrate-sheet")
      return { sheet: "/c/sheet.csv", machine: "", material: "", rows: [row()], jobs: [] };
    if (name === "calibrate-fit") return { kinds: [], left_out: [], doubts: [], gaps: [] };
    const [, cells = ""] = request.readings?.[0]?.split("=") ?? [];
    readings = cells.split(",").map((cell) => (cell === "-" ? null : Number(cell)));
    return {};
  });
  end = followSheet();
  openCalibration();
  await openSheet("/c/sheet.csv", "coupons");
});
afterEach(() => end());

it("shows what was written into the file elsewhere, when its table is opened and when a person comes back", async () => {
  readings = [38, 38.4];
  showStep("measure");
  await vi.waitFor(() => expect(shown()).toEqual([38, 38.4]));
  readings = [38.1, 38.4];
  window.dispatchEvent(new Event("focus"));
  await vi.waitFor(() => expect(shown()).toEqual([38.1, 38.4]));
  const fits = asked("calibrate-fit").length;
  // Nothing was changed: nothing is fitted anew.
  const reads = asked("calibrate-sheet").length;
  window.dispatchEvent(new Event("focus"));
  await vi.waitFor(() => expect(asked("calibrate-sheet").length).toBeGreaterThan(reads));
  await new Promise((done) => setTimeout(done));
  expect(asked("calibrate-fit")).toHaveLength(fits);
});

it("keeps the readings that were written into the file of a row in which one is typed", async () => {
  showStep("measure");
  await vi.waitFor(() => expect(shown()).toEqual([38, null]));
  readings = [null, 38.4];
  expect(await enterReading(row() as never, 0, 37.9)).toBe(true);
  expect(asked("calibrate-enter").at(-1)?.[1]).toEqual({
    sheet: "/c/sheet.csv",
    readings: ["angle-40:1=37.9,38.4"],
  });
  expect(shown()).toEqual([37.9, 38.4]);
});

it("is read once where it is opened or calibrating begins again, and nothing is said where it is gone by then", async () => {
  const reads = () => asked("calibrate-sheet").length;
  let before = reads();
  await openSheet("/c/sheet.csv", "measure");
  await new Promise((done) => setTimeout(done));
  expect(reads()).toBe(before + 1);
  closeCalibration();
  before = reads();
  openCalibration();
  await new Promise((done) => setTimeout(done));
  expect([reads(), useCalibration.getState().step]).toEqual([before + 1, "measure"]);
  closeCalibration();
  const problems = new Set<string | null>();
  const end = useCalibration.subscribe(({ problem }) => problems.add(problem));
  ask.mockRejectedValue(new Error("no such file"));
  // In this window, and in another one that has been closed since.
  for (const known of [useCalibration.getState(), useCalibration.getInitialState()]) {
    useCalibration.setState(known);
    openCalibration();
    await new Promise((done) => setTimeout(done));
    expect(useCalibration.getState()).toMatchObject({ step: "coupons", sheet: null });
  }
  end();
  expect([...problems]).toEqual([null]);
});

it("leaves a sheet as it was that cannot be read just now, with the reason, and asks for nothing once it is closed", async () => {
  ask.mockRejectedValueOnce(new Error("the file is open elsewhere"));
  window.dispatchEvent(new Event("focus"));
  await vi.waitFor(() => expect(useCalibration.getState().problem).toBe("the file is open elsewhere"));
  expect(shown()).toEqual([38, null]);
  window.dispatchEvent(new Event("focus"));
  await vi.waitFor(() => expect(useCalibration.getState().problem).toBeNull());
  closeCalibration();
  const before = ask.mock.calls.length;
  window.dispatchEvent(new Event("focus"));
  await new Promise((done) => setTimeout(done));
  expect(ask.mock.calls).toHaveLength(before);
});
