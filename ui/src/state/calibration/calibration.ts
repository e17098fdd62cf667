import { create } from "zustand";
import type {
  CalibrateApplyResponse,
  CalibrateCompareResponse,
  CalibrateNewResponse,
  CalibrationReport,
  CalibrationRow,
  CalibrationSheet,
} from "../../generated/responses";
import { platform, Refused } from "../../platform";
import { edit, useDesign } from "../design/design";
import { profilesChanged } from "../machine/machines";
import { store, stored } from "../window/ui";

/** The steps, in the order of the work. */
export type CalibrationStep = "coupons" | "measure" | "fit" | "apply" | "versions";

/** What the springback may depend on; `better`: what predicts best. */
export type SpringbackShape = "better" | "constant" | "curve";

/** Coupons as they are asked for. */
export interface CouponRequest {
  readonly machine: string;
  readonly material: string;
  /** Empty: a usual set. */
  readonly angles_deg: readonly number[];
  readonly repeats: number;
  readonly paper: string;
  readonly folder: string;
}

/** What was applied, and the way back. */
interface Applied {
  readonly result: CalibrateApplyResponse;
  /** The machine and the wire of the design before. */
  readonly before: { readonly machine: string; readonly material: string };
  /** Whether profiles were replaced, which are as before once it is taken back. */
  readonly replaced: boolean;
  readonly compared: CalibrateCompareResponse | null;
}

interface CalibrationStore {
  readonly open: boolean;
  readonly step: CalibrationStep;
  readonly sheet: CalibrationSheet | null;
  readonly made: CalibrateNewResponse | null;
  /** What they were made for. */
  readonly madeFor: CouponRequest | null;
  /** A folder in which coupons were not made, since it has some: to replace them is for a person to say. */
  readonly occupied: string | null;
  readonly shape: SpringbackShape;
  /** What the sheet tells; null where it tells nothing yet: see `gap`. */
  readonly report: CalibrationReport | null;
  /** Why it tells nothing. */
  readonly gap: string | null;
  readonly applied: Applied | null;
  /** The machine of the design beside another version. */
  readonly versions: CalibrateCompareResponse | null;
  /** Whether what was applied was taken back. */
  readonly reverted: boolean;
  /** Why the last thing came to nothing. */
  readonly problem: string | null;
  readonly busy: boolean;
}

const EMPTY: CalibrationStore = {
  open: false,
  step: "coupons",
  sheet: null,
  made: null,
  madeFor: null,
  occupied: null,
  shape: "better",
  report: null,
  gap: null,
  applied: null,
  versions: null,
  reverted: false,
  problem: null,
  busy: false,
};

export const useCalibration = create<CalibrationStore>()(() => EMPTY);

/** The sheet that was open last: measuring takes longer than a window is open. */
const KEY = "wirebend.calibration";

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** Does one thing after another; what comes to nothing is said. Gives whether it was done. */
let last: Promise<unknown> = Promise.resolve();
function working(work: () => Promise<void>): Promise<boolean> {
  const done = last.then(async () => {
    useCalibration.setState({ busy: true, problem: null });
    try {
      await work();
      return true;
    } catch (error) {
      useCalibration.setState({ problem: messageOf(error) });
      return false;
    } finally {
      useCalibration.setState({ busy: false });
    }
  });
  last = done;
  return done;
}

export function openCalibration(): void {
  const { sheet: known, made, madeFor, shape, report, gap, busy } = useCalibration.getState();
  if (known) {
    const kept = { sheet: known, made, madeFor, shape, report, gap, busy };
    // What is being entered goes into this sheet; it is read anew after that, since others may have written into it.
    useCalibration.setState({ ...EMPTY, ...kept, open: true, step: "measure" });
    void readAgain();
    return;
  }
  useCalibration.setState({ ...EMPTY, open: true });
  const sheet = stored(KEY);
  // A sheet that is not there any more is no problem of today.
  if (sheet) void openSheet(sheet, "measure").then((done) => !done && useCalibration.setState({ problem: null }));
}

/** The same sheet as it is now, after all that is being entered; none where it is gone. */
function readAgain(): Promise<boolean> {
  return working(async () => {
    const { sheet } = useCalibration.getState();
    try {
      if (sheet) await read(sheet.sheet);
    } catch {
      useCalibration.setState(({ open }) => ({ ...EMPTY, open, busy: true }));
    }
  });
}

export function closeCalibration(): void {
  useCalibration.setState({ open: false });
}

export function showStep(step: CalibrationStep): void {
  useCalibration.setState({ step, problem: null, occupied: null });
}

async function read(sheet: string): Promise<void> {
  const { applied } = useCalibration.getState();
  // Other readings hold other versions to be better.
  useCalibration.setState({
    sheet: await platform.ask("calibrate-sheet", { sheet }),
    versions: null,
    applied: applied && { ...applied, compared: null },
  });
  await fitAnew();
}

/** Fits what there is. Readings that no machine fits are no error of the window: it says so in their place. */
async function fitAnew(): Promise<void> {
  const { sheet, shape } = useCalibration.getState();
  if (!sheet) return;
  if (sheet.rows.every(({ readings }) => readings.every((reading) => reading === null))) {
    useCalibration.setState({ report: null, gap: null });
    return;
  }
  try {
    const report = await platform.ask("calibrate-fit", {
      sheet: sheet.sheet,
      ...(shape === "better" ? {} : { shape }),
    });
    useCalibration.setState({ report, gap: null });
  } catch (error) {
    useCalibration.setState({ report: null, gap: messageOf(error) });
  }
}

/** Writes coupons as jobs and a sheet into a folder. `force`: those that are there are replaced, with the readings of their sheet. */
export function makeCoupons(request: CouponRequest, force: boolean): Promise<boolean> {
  return working(async () => {
    useCalibration.setState({ occupied: null });
    let made: CalibrateNewResponse;
    try {
      made = await platform.ask("calibrate-new", { ...request, angles_deg: [...request.angles_deg], force });
    } catch (error) {
      if (!(error instanceof Refused && error.refusal.code === "exists")) throw error;
      useCalibration.setState({ occupied: request.folder });
      return;
    }
    useCalibration.setState({ made, madeFor: request, applied: null, reverted: false });
    store(KEY, made.sheet);
    await read(made.sheet);
  });
}

/** Opens a sheet that is there. */
export function openSheet(sheet: string, step: CalibrationStep): Promise<boolean> {
  const from = useCalibration.getState().step;
  return working(async () => {
    await read(sheet);
    store(KEY, sheet);
    // Whoever has gone elsewhere meanwhile stays there.
    const { step: now } = useCalibration.getState();
    const none = { made: null, madeFor: null, occupied: null, applied: null, reverted: false };
    useCalibration.setState({ ...none, step: now === from ? step : now });
  });
}

/** Enters a reading, or takes it out, and fits anew. */
export function enterReading(row: CalibrationRow, at: number, value: number | null): Promise<boolean> {
  return working(async () => {
    const { sheet } = useCalibration.getState();
    // What was entered into the row just before counts.
    const now = sheet?.rows.find(({ line }) => line === row.line);
    if (!sheet || !now)
      throw new Error(`The sheet has no row ${row.row} of ${row.coupon} any more: the reading was not entered.`);
    const readings = Array.from({ length: Math.max(at + 1, now.readings.length) }, (_, index) =>
      index === at ? value : (now.readings[index] ?? null),
    );
    const cells = readings.map((reading) => (reading === null ? "-" : String(reading))).join(",");
    await platform.ask("calibrate-enter", {
      sheet: sheet.sheet,
      readings: [`${row.coupon}:${row.row}=${cells}`],
    });
    await read(sheet.sheet);
  });
}

/** Enters what a simulated machine has bent of the coupons. */
export function enterBent(): Promise<boolean> {
  return working(async () => {
    const { sheet } = useCalibration.getState();
    if (!sheet) return;
    await platform.ask("calibrate-enter", { sheet: sheet.sheet, bent: [...sheet.jobs] });
    await read(sheet.sheet);
  });
}

/** Adds rows of a table of pin angle and springback angle. */
export function addPinTable(file: string): Promise<boolean> {
  return working(async () => {
    const { sheet } = useCalibration.getState();
    if (!sheet) return;
    await platform.ask("calibrate-enter", { sheet: sheet.sheet, pin_tables: [file] });
    await read(sheet.sheet);
  });
}

export function chooseShape(shape: SpringbackShape): Promise<boolean> {
  return working(async () => {
    useCalibration.setState({ shape });
    await fitAnew();
  });
}

/** Writes profiles of what was found, and gives them to the design. `force`: profiles of these ids are replaced. */
export function applyCalibration(machine_id: string, material_id: string, force: boolean): Promise<boolean> {
  return working(async () => {
    const { sheet, shape } = useCalibration.getState();
    const { state } = useDesign.getState();
    if (!sheet) return;
    const before = {
      machine: state?.machine ?? sheet.machine,
      material: state?.material ?? sheet.material,
    };
    const result = await platform.ask("apply-calibration", {
      sheet: sheet.sheet,
      machine_id,
      material_id,
      force,
      ...(shape === "better" ? {} : { shape }),
    });
    profilesChanged(null);
    const applied = { result, before, replaced: force, compared: null };
    useCalibration.setState({ applied, reverted: false, versions: null });
    await edit({ edit: "machine", machine: result.machine, material: result.material });
    const machines: [string, string] = [sheet.machine, result.machine];
    const compared = await platform.ask("calibrate-compare", { machines, sheet: sheet.sheet });
    useCalibration.setState({ applied: { result, before, replaced: force, compared } });
  });
}

/** Holds a version against the machine of the design; by the readings of the open sheet too, where these tell something. */
export function compareVersions(id: string): Promise<boolean> {
  return working(async () => {
    const { sheet, report } = useCalibration.getState();
    const machine = useDesign.getState().state?.machine;
    if (!machine) return;
    const by = sheet && report ? { sheet: sheet.sheet } : {};
    const request = { machines: [machine, id] as [string, string], ...by };
    useCalibration.setState({ versions: await platform.ask("calibrate-compare", request) });
  });
}

/** The design takes a version of a machine, and its wire. */
export function takeVersion(machine: string, material: string): Promise<boolean> {
  return working(async () => {
    await edit({ edit: "machine", machine, material });
    useCalibration.setState({ versions: null });
  });
}

/** The design has its machine and its wire of before; profiles that were replaced are as before. */
export function revertCalibration(): Promise<boolean> {
  return working(async () => {
    const { applied } = useCalibration.getState();
    if (!applied) return;
    const { result, before, replaced } = applied;
    await edit({ edit: "machine", machine: before.machine, material: before.material });
    try {
      // The machine first: it names the wire. One of both may be new.
      for (const [kind, id] of [
        ["machine", result.machine],
        ["material", result.material],
      ] as const) {
        if (!replaced) break;
        const { has_last_change } = await platform.ask("profile-view", { kind, id });
        if (has_last_change) await platform.ask("revert-profile", { kind, id, keys: [] });
      }
    } finally {
      // The machine may be as before where the wire cannot be.
      profilesChanged(null);
    }
    useCalibration.setState({ reverted: true, versions: null });
  });
}
