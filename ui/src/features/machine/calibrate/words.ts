/** What a calibration says in the window. */

import type {
  CalibratedVersion,
  CalibrationReport,
  CalibrationRow,
  CalibrationSheet,
  KindReport,
  MachineEntry,
} from "../../../generated/responses";
import { angle, count, type DisplayUnit, deviation, number, short } from "../../../shared/figures/format";
import { parseAngle, parseNumber } from "../../../shared/figures/parse";

/** "12 of 56 readings entered, 1 left out"; nothing without a sheet. */
export function progressOf(sheet: CalibrationSheet | null, report: CalibrationReport | null): string {
  if (!sheet) return "";
  const cells = sheet.rows.flatMap(({ readings }) => readings);
  const entered = cells.filter((reading) => reading !== null).length;
  const left = report?.left_out.length ?? 0;
  return `${entered} of ${count(cells.length, "reading")} entered${left > 0 ? `, ${left} left out` : ""}`;
}

/** What is to be measured of a row. */
export const WHAT: Readonly<Record<string, { readonly name: string; readonly how: string }>> = {
  bend: { name: "bend", how: "how far the wire turns; straight is 0°, a right angle 90°." },
  side: { name: "side", how: "the middle side of the U over its outside, with a caliper." },
  turn: { name: "turn", how: "the angle between the planes of two bends that follow each other." },
  "turn-back": { name: "turn back", how: "the same, where the head has turned back." },
};

/** A reading as the sheet has it, in degrees or mm; an empty cell is missing; undefined where it is no number. */
export function parseReading(text: string, unit: string): number | null | undefined {
  const plain = text.trim();
  if (plain === "" || plain === "-" || plain === "–") return null;
  const read = unit === "deg" ? parseAngle(plain) : parseNumber(plain.replace(/\s*mm$/i, ""));
  return read ?? undefined;
}

/** A reading as it stands in its cell. */
export const shownReading = (reading: number | null): string =>
  reading === null ? "" : short(reading).replace(/\u202f/g, "");

/** Why a reading is left out; null where it is not. */
export function leftOut(report: CalibrationReport | null, row: CalibrationRow, at: number): string | null {
  return report?.left_out.find(({ line, reading }) => line === row.line && reading === at + 1)?.message ?? null;
}

export const KINDS: Readonly<Record<KindReport["kind"], string>> = {
  bends: "Bends",
  feeds: "Sides",
  turns: "Turns of the head",
};

/** How far something is off, in the unit of its kind. */
export const off = (value: number, unit: string, lengths: DisplayUnit): string =>
  unit === "mm" ? deviation(value, lengths) : unit === "deg" ? `${number(value, 2)}°` : short(value, 4);

/** A parameter with its unit. */
export function figure(value: number, unit: string, lengths: DisplayUnit): string {
  if (unit === "mm") return deviation(value, lengths);
  return unit === "deg" ? `${number(value, 2)}°` : number(value, 4);
}

/** "14 readings, scatter 0.14°; 8 of 10 parameters determined". */
export function summary(kind: KindReport, lengths: DisplayUnit): string {
  const scatter = off(kind.scatter, kind.unit, lengths);
  return `${count(kind.readings, "reading")}, scatter ${scatter}; ${kind.rank} of ${count(kind.parameters.length, "parameter")} determined`;
}

/** Angles as they are typed: "20, 45, 90"; null where one is none. */
export function parseAngles(text: string): readonly number[] | null {
  const parts = text.split(/[;,\s]+/).filter((part) => part !== "");
  const angles = parts.map((part) => parseAngle(part));
  return angles.some((one) => one === null || one <= 0 || one > 180) ? null : (angles as number[]);
}

/** The largest angle that is bent where none is named. */
const USUAL_MOST_DEG = 135;

/** "the 35 readings in their sheet", "the readings in their sheet" where it is not known how many; null where there are none. */
export function lostReadings(readings: number | null): string | null {
  if (readings === 0) return null;
  const many = readings === null ? "readings" : readings === 1 ? "reading" : count(readings, "reading");
  return `the ${many} in their sheet`;
}

/** What there is to do about jobs of which no simulated machine has bent anything new; null where there are none. */
export function unbentPhrase(names: readonly string[]): string | null {
  const last = names.at(-1);
  if (last === undefined) return null;
  const others = names.slice(0, -1).join(", ");
  const [which, them] = others === "" ? [last, "it"] : [`${others} and ${last}`, "them"];
  return `There is no new simulated run of ${which}. Bend ${them} on the simulated machine first, with Run… in Coupons.`;
}

/** Which angles are bent where none is named: "20° to at most 120°". `bends`: how far the machine bends to both sides, where that is known. */
export function usualAngles(bends: readonly [number, number] | null): string {
  if (!bends) return "20° to what the machine can bend";
  // A wire that springs back much can be bent less far than the machine's own limit.
  const most = Math.min(USUAL_MOST_DEG, ...bends.map(Math.abs));
  // One that bends to one side makes no ladder to both.
  return most < 20 ? "20° to what the machine can bend" : `20° to at most ${short(most, 4)}°`;
}

export const wanted = (row: CalibrationRow): string =>
  row.unit === "deg" ? angle(row.wanted) : `${number(row.wanted)} mm`;

/** A machine with a wire, and the calibration that made both; null where none did. */
interface Version {
  readonly id: string;
  readonly name: string;
  readonly material: string;
  readonly calibrated: CalibratedVersion | null;
}

/** What calibrations made, the newest first, and after them what they were made from, with the wire that they began with. */
export function versionsOf(machines: readonly MachineEntry[]): Version[] {
  const made = machines.flatMap(({ id, name, default_material: material, calibrated }) =>
    calibrated ? [{ id, name, material, calibrated }] : [],
  );
  made.sort((one, other) => other.calibrated.date.localeCompare(one.calibrated.date));
  const from = new Map<string, Version>();
  for (const { calibrated } of made) {
    const { machine: id, material } = calibrated;
    const machine = machines.find((one) => one.id === id && !one.calibrated);
    if (machine) from.set(`${id} ${material}`, { id, name: machine.name, material, calibrated: null });
  }
  return [...made, ...from.values()];
}
