import { create } from "zustand";
import type { ShapeName } from "../../generated/requests";
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
import { store, stored } from "../window/ui";

/** The steps, in the order of the work. */
export type CalibrationStep = "coupons" | "measure" | "fit" | "apply" | "versions";

/** What the springback may depend on; `better`: what predicts best. */
export type SpringbackShape = "better" | ShapeName;

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

/** A folder that has coupons. */
interface Occupied {
  readonly folder: string;
  /** How many readings the sheet in it has; null where that could not be read. */
  readonly readings: number | null;
}

/** What was applied, and the way back. */
interface Applied {
  readonly result: CalibrateApplyResponse;
  /** The machine and the wire of the design before. */
  readonly before: { readonly machine: string; readonly material: string };
  /** Whether profiles were replaced, which are as before once it is taken back. */
  readonly replaced: boolean;
  /** How often profiles were changed by then: the last change of one that was replaced is this one only as long as that is so. */
  readonly profiles: number;
  /** How many designs were opened by then: only that one was given it. */
  readonly opened: number;
  /** The readings that it is of, as one text. */
  readonly readings: string;
  readonly compared: CalibrateCompareResponse | null;
}

/** What of it was taken back. */
interface Reverted {
  readonly design: boolean;
  readonly profiles: boolean;
}

interface CalibrationStore {
  readonly open: boolean;
  readonly step: CalibrationStep;
  readonly sheet: CalibrationSheet | null;
  readonly made: CalibrateNewResponse | null;
  /** What they were made for. */
  readonly madeFor: CouponRequest | null;
  /** A folder in which coupons were not made, since it has some: to replace them is for a person to say. */
  readonly occupied: Occupied | null;
  readonly shape: SpringbackShape;
  /** What the sheet tells; null where it tells nothing yet: see `gap`. */
  readonly report: CalibrationReport | null;
  /** Why it tells nothing. */
  readonly gap: string | null;
  readonly applied: Applied | null;
  /** The machine of the design beside another version. */
  readonly versions: CalibrateCompareResponse | null;
  /** What of it was taken back; null where nothing was. */
  readonly reverted: Reverted | null;
  /** Jobs of which there was nothing new to enter when simulated runs were asked for; empty as long as they were not. */
  readonly unbent: readonly string[];
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
  reverted: null,
  unbent: [],
  problem: null,
  busy: false,
};

export const useCalibration = create<CalibrationStore>()(() => EMPTY);

/** The sheet that was open last: measuring takes longer than a window is open. */
const KEY = "wirebend.calibration";

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** Does one thing after another; what comes to nothing is said. Gives whether it was done. */
let last: Promise<unknown> = Promise.resolve();
export function working(work: () => Promise<void>): Promise<boolean> {
  const done = last.then(async () => {
    useCalibration.setState({ busy: true, problem: null, unbent: [] });
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
  const { sheet: known } = useCalibration.getState();
  // What was applied can still be taken back, and what is being entered goes into the sheet that is there.
  useCalibration.setState({
    open: true,
    step: known ? "measure" : "coupons",
    versions: null,
    occupied: null,
    problem: null,
  });
  if (known) {
    void readAgain();
    return;
  }
  const sheet = stored(KEY);
  // A sheet that is not there any more is no problem of today.
  if (sheet) void working(() => takeUp(sheet, "measure", "coupons").catch(() => {}));
}

/** The same sheet as it is now, after all that is being entered: others may have written into it. None where it is gone. */
function readAgain(): Promise<boolean> {
  return working(async () => {
    const { sheet } = useCalibration.getState();
    try {
      if (sheet) await read(sheet.sheet);
    } catch {
      useCalibration.setState({ step: "coupons", sheet: null, made: null, madeFor: null, report: null, gap: null });
    }
  });
}

/** Why the sheet could not be read when that was last tried by itself. */
let unreadable: string | null = null;

/**
 * The same while the dialog is open, when a person comes to its table, or back from a spreadsheet. What was said before stays; a sheet that cannot be
 * read just now stays as it was.
 */
export function refreshSheet(): Promise<void> {
  const done = last.then(async () => {
    const { open, sheet } = useCalibration.getState();
    if (!open || !sheet) return;
    try {
      const table = await platform.ask("calibrate-sheet", { sheet: sheet.sheet });
      if (JSON.stringify(table) !== JSON.stringify(sheet)) await take(table);
      const over = unreadable;
      unreadable = null;
      if (over !== null) useCalibration.setState(({ problem }) => ({ problem: problem === over ? null : problem }));
    } catch (error) {
      unreadable = messageOf(error);
      useCalibration.setState({ problem: unreadable });
    }
  });
  last = done;
  return done;
}

export function closeCalibration(): void {
  useCalibration.setState({ open: false });
}

export function showStep(step: CalibrationStep): void {
  useCalibration.setState({ step, problem: null, occupied: null, unbent: [] });
  if (step === "measure") void refreshSheet();
}

/** The readings of the sheet, and how they are fitted, as one text. */
export const readingsOf = ({ sheet, shape }: Pick<CalibrationStore, "sheet" | "shape">): string =>
  JSON.stringify([sheet?.sheet, sheet?.rows.map(({ readings }) => readings), shape]);

const read = async (sheet: string): Promise<void> => take(await platform.ask("calibrate-sheet", { sheet }));

async function take(table: CalibrationSheet): Promise<void> {
  // Other readings hold other versions to be better.
  useCalibration.setState(({ applied, shape }) => {
    const stays = applied?.readings === readingsOf({ sheet: table, shape });
    return { sheet: table, versions: null, applied: applied && (stays ? applied : { ...applied, compared: null }) };
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

/** How many readings the sheet of the coupons in a folder has; null where it cannot be read. */
async function readingsIn(folder: string): Promise<number | null> {
  try {
    const { rows } = await platform.ask("calibrate-sheet", { sheet: `${folder}/sheet.csv` });
    return rows.flatMap(({ readings }) => readings).filter((reading) => reading !== null).length;
  } catch {
    return null;
  }
}

/**
 * Writes coupons as jobs and a sheet into a folder. `force`: those that are there are replaced, with the readings of their sheet. What is
 * known of that folder stays until it is known anew: who is to say whether they are replaced is looking at it.
 */
export function makeCoupons(request: CouponRequest, force: boolean): Promise<boolean> {
  return working(async () => {
    const { occupied } = useCalibration.getState();
    if (occupied?.folder !== request.folder) useCalibration.setState({ occupied: null });
    let made: CalibrateNewResponse;
    try {
      made = await platform.ask("calibrate-new", { ...request, angles_deg: [...request.angles_deg], force });
    } catch (error) {
      if (!(error instanceof Refused && error.refusal.code === "exists")) throw error;
      useCalibration.setState({ occupied: { folder: request.folder, readings: await readingsIn(request.folder) } });
      return;
    }
    useCalibration.setState({ made, madeFor: request, occupied: null });
    store(KEY, made.sheet);
    await read(made.sheet);
  });
}

/** Opens a sheet that is there. */
export function openSheet(sheet: string, step: CalibrationStep): Promise<boolean> {
  const from = useCalibration.getState().step;
  return working(() => takeUp(sheet, step, from));
}

/** Reads a sheet and leads to a step. Whoever has gone elsewhere than `from` meanwhile stays there. */
async function takeUp(sheet: string, step: CalibrationStep, from: CalibrationStep): Promise<void> {
  await read(sheet);
  store(KEY, sheet);
  const { step: now } = useCalibration.getState();
  useCalibration.setState({ made: null, madeFor: null, occupied: null, step: now === from ? step : now });
}

/** Enters a reading, or takes it out, and fits anew. */
export function enterReading(row: CalibrationRow, at: number, value: number | null): Promise<boolean> {
  return working(async () => {
    const known = useCalibration.getState().sheet;
    // A row is written as a whole: what was entered into it just before counts, here or in the file.
    const sheet = known && (await platform.ask("calibrate-sheet", { sheet: known.sheet }));
    const now = sheet?.rows.find(
      ({ line, coupon, row: n }) => line === row.line && coupon === row.coupon && n === row.row,
    );
    if (!sheet || !now) {
      if (sheet) await take(sheet);
      throw new Error(`The sheet has no row ${row.row} of ${row.coupon} any more: the reading was not entered.`);
    }
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
    const unbent: string[] = [];
    try {
      // One by one: what is entered is told of all jobs together.
      for (const job of sheet.jobs) {
        const { entered } = await platform.ask("calibrate-enter", { sheet: sheet.sheet, bent: [job] });
        if (entered === 0) unbent.push(job);
      }
    } finally {
      await read(sheet.sheet);
    }
    useCalibration.setState({ unbent });
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
