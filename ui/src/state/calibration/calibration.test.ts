// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
const edit = vi.hoisted(() => vi.fn(async (_: object) => ({})));
vi.mock("../../platform", () => ({ platform: { ask }, Refused: class Refused extends Error {} }));
vi.mock("../design/design", async (original) => ({
  ...(await original<object>()),
  edit,
  checkDesign: () => {},
}));

import { useDesign } from "../design/design";
import { useFiles } from "../files/files";
import { useMachines } from "../machine/machines";
import { designState } from "../testing";
import { applyCalibration, revertCalibration } from "./applying";
import {
  chooseShape,
  closeCalibration,
  enterBent,
  enterReading,
  openCalibration,
  openSheet,
  useCalibration,
} from "./calibration";

let second: number | null;
const rows = () => [
  {
    line: 5,
    coupon: "side-35",
    row: 1,
    what: "side",
    unit: "mm",
    wanted: 35,
    commanded: 33,
    readings: [38.1, second],
  },
];
let views: Record<string, boolean>;

beforeEach(async () => {
  localStorage.clear();
  useCalibration.setState(useCalibration.getInitialState());
  second = null;
  views = { machine: true, material: false };
  ask.mockReset();
  edit.mockReset().mockImplementation(async (request) => {
    const { machine, material } = request as { machine: string; material: string };
    useDesign.setState({ state: designState({ machine, material }) });
    return {};
  });
  ask.mockImplementation(async (name: string, request: { kind?: string }) => {
    if (name === "calibrate-sheet")
      return { sheet: "/c/sheet.csv", machine: "kit", material: "wire", rows: rows(), jobs: [] };
    if (name === "calibrate-fit") return { kinds: [], left_out: [], doubts: [], gaps: [] };
    if (name === "apply-calibration") return { machine: "my-kit", material: "my-wire", files: [], notes: [] };
    if (name === "profile-view") return { has_last_change: views[request.kind ?? ""] };
    return { machines: [], materials: [], values: [], misfits: [] };
  });
  useDesign.setState({ state: designState({ machine: "kit", material: "steel" }) });
  openCalibration();
  await openSheet("/c/sheet.csv", "measure");
});

const asked = (name: string) => ask.mock.calls.filter(([one]) => one === name).map(([, request]) => request);

it("takes a reading out without losing the others of its row", async () => {
  const [row] = useCalibration.getState().sheet?.rows ?? [];
  if (row) await enterReading(row, 0, null);
  expect(asked("calibrate-enter")).toEqual([{ sheet: "/c/sheet.csv", readings: ["side-35:1=-,-"] }]);
});

it("says of which jobs a simulated machine has bent nothing new, until something else is done", async () => {
  const jobs = ["/c/angles.wbjob", "/c/sides.wbjob", "/c/turns.wbjob"];
  useCalibration.setState(({ sheet }) => ({ sheet: sheet && { ...sheet, jobs } }));
  const answer = ask.getMockImplementation();
  ask.mockImplementation(async (name: string, request: { bent?: string[] }) =>
    name === "calibrate-enter" && request.bent
      ? { entered: request.bent[0] === "/c/sides.wbjob" ? 4 : 0 }
      : answer?.(name, request),
  );
  expect(await enterBent()).toBe(true);
  expect(asked("calibrate-enter").map(({ bent }) => bent)).toEqual(jobs.map((job) => [job]));
  expect(useCalibration.getState().unbent).toEqual(["/c/angles.wbjob", "/c/turns.wbjob"]);
  const [row] = useCalibration.getState().sheet?.rows ?? [];
  if (row) await enterReading(row, 0, 38);
  expect(useCalibration.getState().unbent).toEqual([]);
});

it("says why a reading was not entered, and goes on", async () => {
  const [row] = useCalibration.getState().sheet?.rows ?? [];
  ask.mockRejectedValueOnce(new Error("the disk is full"));
  expect(row && (await enterReading(row, 1, 38))).toBe(false);
  expect(useCalibration.getState()).toMatchObject({ problem: "the disk is full", busy: false });
  expect(row && (await enterReading(row, 1, 38))).toBe(true);
  expect(useCalibration.getState().problem).toBeNull();
});

it("loses no reading that is on its way while the dialog is closed and opened again", async () => {
  const [row] = useCalibration.getState().sheet?.rows ?? [];
  if (!row) throw new Error("no row");
  const answer = ask.getMockImplementation();
  let done: (value: unknown) => void = () => {};
  ask.mockImplementation((name: string, request: object) =>
    name === "calibrate-enter" && asked(name).length === 1
      ? new Promise((resolve) => (done = resolve))
      : answer?.(name, request),
  );
  const both = [enterReading(row, 0, 37.9), enterReading(row, 1, 38)];
  await vi.waitFor(() => expect(asked("calibrate-enter")).toHaveLength(1));
  closeCalibration();
  openCalibration();
  expect(useCalibration.getState()).toMatchObject({ open: true, step: "measure", busy: true });
  done({});
  expect(await Promise.all(both)).toEqual([true, true]);
  expect(asked("calibrate-enter").map(({ readings }) => readings)).toEqual([
    ["side-35:1=37.9,-"],
    ["side-35:1=38.1,38"],
  ]);
  await vi.waitFor(() => expect(useCalibration.getState().busy).toBe(false));
  expect(useCalibration.getState().sheet?.sheet).toBe("/c/sheet.csv");
});

it("does not call a reading entered whose row the sheet has no more", async () => {
  const [row] = useCalibration.getState().sheet?.rows ?? [];
  expect(row && (await enterReading({ ...row, line: 99 }, 0, 38))).toBe(false);
  expect(useCalibration.getState().problem).toBe(
    "The sheet has no row 1 of side-35 any more: the reading was not entered.",
  );
});

it("gives the design its machine and wire of before, and a profile that was replaced its values", async () => {
  await applyCalibration("my-kit", "my-wire", true);
  expect(edit).toHaveBeenLastCalledWith({ edit: "machine", machine: "my-kit", material: "my-wire" });
  expect(asked("calibrate-compare")).toEqual([{ machines: ["kit", "my-kit"], sheet: "/c/sheet.csv" }]);
  await revertCalibration();
  expect(edit).toHaveBeenLastCalledWith({ edit: "machine", machine: "kit", material: "steel" });
  // The wire was new: there is nothing of before.
  expect(asked("revert-profile")).toEqual([{ kind: "machine", id: "my-kit", keys: [] }]);
  expect(useCalibration.getState().reverted).toEqual({ design: true, profiles: true });
});

it("keeps no comparison of applied profiles by other readings", async () => {
  await applyCalibration("my-kit", "my-wire", false);
  expect(useCalibration.getState().applied?.compared).not.toBeNull();
  const [row] = useCalibration.getState().sheet?.rows ?? [];
  // Entered as it was it is no other.
  if (row) await enterReading(row, 0, 38.1);
  expect(useCalibration.getState().applied?.compared).not.toBeNull();
  second = 38;
  if (row) await enterReading(row, 1, 38);
  expect(useCalibration.getState().applied).toMatchObject({ result: { machine: "my-kit" }, compared: null });
});

it("keeps what was applied, to be taken back, while it is closed and opened, and another sheet is looked at", async () => {
  await applyCalibration("my-kit", "my-wire", true);
  closeCalibration();
  openCalibration();
  await openSheet("/c/other.csv", "measure");
  await chooseShape("constant");
  expect(useCalibration.getState()).toMatchObject({ applied: { result: { machine: "my-kit" } }, reverted: null });
  await revertCalibration();
  expect(edit).toHaveBeenLastCalledWith({ edit: "machine", machine: "kit", material: "steel" });
});

it("takes nothing back from another design, nor a change of a profile that came later", async () => {
  await applyCalibration("my-kit", "my-wire", true);
  useFiles.setState(({ opened }) => ({ opened: opened + 1 }));
  await revertCalibration();
  expect(edit).toHaveBeenCalledTimes(1);
  expect(useCalibration.getState().reverted).toEqual({ design: false, profiles: true });
  await applyCalibration("my-kit", "my-wire", true);
  useMachines.setState(({ changes }) => ({ changes: changes + 1 }));
  ask.mockClear();
  await revertCalibration();
  expect(asked("revert-profile")).toEqual([]);
  expect(useCalibration.getState().reverted).toEqual({ design: true, profiles: false });
});

it("has the machine's values asked anew where only those of the wire cannot be as before", async () => {
  await applyCalibration("my-kit", "my-wire", true);
  views = { machine: true, material: true };
  const { changes } = useMachines.getState();
  const answer = ask.getMockImplementation();
  ask.mockImplementation(async (name: string, request: { kind?: string }) => {
    if (name === "revert-profile" && request.kind === "material") throw new Error("the disk is full");
    return answer?.(name, request);
  });
  expect(await revertCalibration()).toBe(false);
  expect(useMachines.getState().changes).toBe(changes + 1);
});

it("opens the last sheet again, and says nothing where it is gone", async () => {
  const opened = async () => {
    const before = asked("calibrate-sheet").length;
    openCalibration();
    await vi.waitFor(() => expect(asked("calibrate-sheet").length).toBeGreaterThan(before));
    await vi.waitFor(() => expect(useCalibration.getState().busy).toBe(false));
  };
  // Of a window before, and of this one.
  for (const before of [useCalibration.getInitialState(), useCalibration.getState()]) {
    useCalibration.setState(before);
    await opened();
    expect(useCalibration.getState()).toMatchObject({ step: "measure", sheet: { sheet: "/c/sheet.csv" } });
    useCalibration.setState(before);
    ask.mockRejectedValueOnce(new Error("no such file"));
    await opened();
    await vi.waitFor(() =>
      expect(useCalibration.getState()).toMatchObject({ step: "coupons", sheet: null, problem: null }),
    );
  }
});
