// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const { ask, pickSave, Refused } = vi.hoisted(() => ({
  ask: vi.fn(),
  pickSave: vi.fn(),
  Refused: class Refused extends Error {
    constructor(readonly refusal: { code: string }) {
      super(refusal.code);
    }
  },
}));
vi.mock("../../../platform", () => ({ platform: { ask, pickSave }, Refused }));

import type { MachineEntry, MaterialEntry } from "../../../generated/responses";
import { place } from "../../../shared/testing";
import { showStep, useCalibration } from "../../../state/calibration/calibration";
import { useDesign } from "../../../state/design/design";
import { useMachines } from "../../../state/machine/machines";
import { designState } from "../../../state/testing";
import { Coupons } from "./Coupons";
import { Measure } from "./Measure";

const at = place();
const text = () => at.host.textContent ?? "";
const press = (name: string) =>
  act(async () => [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === name)?.click());
const choose = (index: number, value: string) =>
  act(async () => {
    const select = at.host.querySelectorAll("select")[index];
    if (!select) throw new Error("no choice");
    select.value = value;
    select.dispatchEvent(new Event("change", { bubbles: true }));
  });
const asked = () => ask.mock.calls.filter(([name]) => name === "calibrate-new").map(([, request]) => request);
const request = { machine: "kit", material: "steel", angles_deg: [], repeats: 2, paper: "a4", folder: "/c/first" };
const OTHER = "The choices were changed since these coupons were made";

beforeEach(() => {
  ask.mockReset().mockImplementation(async (name: string, { machine, material, repeats, folder }: typeof request) => {
    const sheet = { sheet: "/c/first/sheet.csv", machine: "kit", material: "steel", rows: [], jobs: [] };
    if (name !== "calibrate-new") return sheet;
    return {
      ...sheet,
      machine,
      material,
      repeats,
      coupons: 6,
      printed: `${folder}/sheet.pdf`,
      wire_mm: 900,
      seconds: 60,
    };
  });
  pickSave.mockReset().mockResolvedValue("/c/first");
  localStorage.clear();
  useCalibration.setState(useCalibration.getInitialState());
  useDesign.setState({ state: designState({ machine: "kit", material: "steel" }) });
  const machines = ["kit", "other"].map((id) => ({ id, name: `Machine ${id}` }) as MachineEntry);
  const materials = ["steel"].map((id) => ({ id, name: `Wire ${id}` }) as MaterialEntry);
  useMachines.setState({ machines, materials });
});

it("says what the coupons are for, and that something else was chosen since, until they are made anew", async () => {
  at.show(<Coupons />);
  await press("Make coupons in a folder…");
  expect(asked()).toEqual([{ ...request, force: false }]);
  expect(text()).toContain("For Machine kit with Wire steel.");
  expect(text()).not.toContain(OTHER);
  await choose(0, "other");
  expect(text()).toContain(OTHER);
  expect(text()).toContain("These are for Machine kit with Wire steel, and Next goes on with their sheet.");
  await choose(0, "kit");
  expect(text()).not.toContain(OTHER);
  await choose(0, "other");
  await press("Make coupons in a folder…");
  expect(text()).not.toContain(OTHER);
  // Whoever comes back finds what they were made for.
  at.show(<Measure />);
  expect(text()).toContain("Readings of Machine kit with Wire steel");
  at.show(<Coupons />);
  expect(at.host.querySelector("select")?.value).toBe("other");
  expect(text()).not.toContain(OTHER);
});

it("replaces coupons that are there only when that is said, with what is chosen by then", async () => {
  at.show(<Coupons />);
  ask.mockRejectedValueOnce(new Refused({ code: "exists" }));
  await press("Make coupons in a folder…");
  expect(text()).toContain("There are coupons in first already");
  expect(useCalibration.getState().problem).toBeNull();
  await choose(0, "other");
  // It is looked once more whether they are there, and have readings by now.
  ask.mockRejectedValueOnce(new Refused({ code: "exists" }));
  await press("Replace");
  expect(asked().at(-1)).toEqual({ ...request, machine: "other", force: true });
  expect(text()).not.toContain("There are coupons in first already");
  expect(text()).toContain("Bend these");
});

it("says how many readings are lost with coupons that are replaced, and asks before", async () => {
  HTMLDialogElement.prototype.showModal ??= () => {};
  const rows = [{ readings: [58, null] }, { readings: [60, 61] }];
  const answer = ask.getMockImplementation();
  let there: object | null = { rows };
  ask.mockImplementation((name: string, request: { sheet?: string; force?: boolean }) => {
    if (name === "calibrate-new" && !request.force) throw new Refused({ code: "exists" });
    if (name !== "calibrate-sheet") return answer?.(name, request);
    if (!there) throw new Error("it cannot be read");
    return there;
  });
  at.show(<Coupons />);
  await press("Make coupons in a folder…");
  expect(ask).toHaveBeenCalledWith("calibrate-sheet", { sheet: "/c/first/sheet.csv" });
  expect(text()).toContain("Replacing deletes the 3 readings in their sheet.");
  await press("Replace…");
  expect(asked().filter(({ force }) => force)).toEqual([]);
  expect(at.host.querySelector("dialog")?.textContent).toContain("This deletes the 3 readings in their sheet.");
  await press("Cancel");
  expect(at.host.querySelector("dialog")).toBeNull();
  expect(asked().filter(({ force }) => force)).toEqual([]);
  there = null;
  await press("Make coupons in a folder…");
  await press("Replace…");
  expect(at.host.querySelector("dialog")?.textContent).toContain("This deletes the readings in their sheet.");
  there = { sheet: "/c/first/sheet.csv", machine: "kit", material: "steel", rows: [], jobs: [] };
  await press("Replace and delete");
  expect(asked().at(-1)).toEqual({ ...request, force: true });
  expect(text()).not.toContain("already");
});

it("keeps the focus on what asks to replace coupons until they are, and the offer where that is refused", async () => {
  HTMLDialogElement.prototype.showModal ??= () => {};
  const answer = ask.getMockImplementation();
  let readings: (number | null)[] = [58];
  let refuse: Error | null = null;
  ask.mockImplementation((name: string, request: { force?: boolean }) => {
    if (name === "calibrate-new" && refuse) throw refuse;
    if (name === "calibrate-new" && !request.force) throw new Refused({ code: "exists" });
    return name === "calibrate-sheet" ? { rows: [{ readings }] } : answer?.(name, request);
  });
  at.show(<Coupons />);
  await press("Make coupons in a folder…");
  const alert = at.host.querySelector("[role=alert]");
  const offered = alert?.firstElementChild;
  const replace = [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === "Replace…");
  replace?.focus();
  await press("Replace…");
  expect(at.host.querySelector("dialog")).not.toBeNull();
  await press("Cancel");
  expect(document.activeElement).toBe(replace);
  // What was not taken away is not announced again.
  expect(alert?.firstElementChild).toBe(offered);
  refuse = new Error("the disk is full");
  await press("Replace…");
  expect(at.host.querySelector("dialog")).toBeNull();
  expect(useCalibration.getState().problem).toBe("the disk is full");
  expect(document.activeElement).toBe(replace);
  refuse = null;
  readings = [];
  await press("Replace…");
  expect(text()).not.toContain("already");
  expect(document.activeElement?.textContent).toBe("Make coupons in a folder…");
});

it("asks before readings are deleted that came into the sheet since it was looked at", async () => {
  HTMLDialogElement.prototype.showModal ??= () => {};
  const answer = ask.getMockImplementation();
  let rows: readonly object[] = [];
  ask.mockImplementation((name: string, request: { force?: boolean }) => {
    if (name === "calibrate-new" && !request.force) throw new Refused({ code: "exists" });
    return name === "calibrate-sheet" ? { rows } : answer?.(name, request);
  });
  at.show(<Coupons />);
  await press("Make coupons in a folder…");
  rows = [{ readings: [58] }];
  await press("Replace");
  expect(asked().filter(({ force }) => force)).toEqual([]);
  expect(at.host.querySelector("dialog")?.textContent).toContain("This deletes the reading in their sheet.");
});

it("keeps nothing to replace once a person has gone elsewhere, and says what else is wrong as before", async () => {
  at.show(<Coupons />);
  ask.mockRejectedValueOnce(new Refused({ code: "exists" }));
  await press("Make coupons in a folder…");
  act(() => showStep("coupons"));
  expect(text()).not.toContain("already");
  ask.mockRejectedValueOnce(new Error("the disk is full"));
  await press("Make coupons in a folder…");
  expect(useCalibration.getState()).toMatchObject({ problem: "the disk is full", occupied: null });
});
