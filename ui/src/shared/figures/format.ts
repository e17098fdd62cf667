/** How figures are shown and read. Lengths are mm inside and everywhere else. */

/** What lengths are shown in. */
export type DisplayUnit = "mm" | "inch";

export const MM_PER_INCH = 25.4;
const THIN = "\u202f";
const MINUS = "\u2212";

/** A number with thousands apart: "11 821.4"; never "−0.0". */
export function number(value: number, digits = 1): string {
  if (!Number.isFinite(value)) return "\u2013";
  const [whole = "", part] = Math.abs(value).toFixed(digits).split(".");
  const apart = whole.length > 3 ? whole.replace(/\B(?=(\d{3})+$)/g, THIN) : whole;
  const text = part === undefined ? apart : `${apart}.${part}`;
  return value < 0 && /[1-9]/.test(text) ? MINUS + text : text;
}

/** A number with no more digits than it needs, of those that count: "5", "0.25". */
export function short(value: number, significant = 6): string {
  const rounded = Number(value.toPrecision(significant));
  const [, part = ""] = String(rounded).split(".");
  return number(rounded, part.length);
}

/** With a capital at its beginning. */
export const sentence = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** The digits that a length is shown with. */
function lengthDigits(unit: DisplayUnit): number {
  return unit === "inch" ? 3 : 1;
}

/** mm in one of the unit. */
export const unitSize = (unit: DisplayUnit): number => (unit === "inch" ? MM_PER_INCH : 1);

/** mm as a number of the unit, without the unit: for columns and fields that name it. */
export function lengthNumber(mm: number, unit: DisplayUnit, finer = 0): string {
  return number(mm / unitSize(unit), lengthDigits(unit) + finer);
}

/** How lengths are written by what does not know the units; see `LengthFormat` of the scene. */
export const lengthFormat = (unit: DisplayUnit) => ({
  mm: unitSize(unit),
  name: unitName(unit),
  number: (mm: number) => lengthNumber(mm, unit),
  short: (mm: number) => short(mm / unitSize(unit), 3),
  angle,
});

export function unitName(unit: DisplayUnit): string {
  return unit === "inch" ? "in" : "mm";
}

/** The least length of those that are shown that is not below `mm`: what has to do when it is typed. */
export function roundedUp(mm: number, unit: DisplayUnit): number {
  const least = unitSize(unit) / 10 ** lengthDigits(unit);
  return Math.ceil(mm / least - 1e-6) * least;
}

/** The largest length of those that are shown that is not above `mm`: what has to fit when it is typed. */
export function roundedDown(mm: number, unit: DisplayUnit): number {
  return -roundedUp(-mm, unit);
}

/** "601.4 mm", "23.677 in"; `finer`: with so many digits more. */
export function length(mm: number, unit: DisplayUnit, finer = 0): string {
  return `${lengthNumber(mm, unit, finer)} ${unitName(unit)}`;
}

/** How far something is from where it should be, which is small: "0.08 mm", "0.0031 in". */
export const deviation = (mm: number, unit: DisplayUnit): string => length(mm, unit, 1);

/** How deep two things are in each other, or below zero how near they come: "2.1 mm deep", "within 0.4 mm". */
export function meetingText(mm: number, unit: DisplayUnit): string {
  const least = unitSize(unit) * 10 ** -lengthDigits(unit);
  // In so many digits it would be nothing.
  if (mm < 0) return `within ${length(Math.max(-mm, least), unit)}`;
  return `${mm < least / 2 ? `less than ${length(least, unit)}` : length(mm, unit)} deep`;
}

/** What is loaded or bought, for which millimetres are too fine: "12.22 m" from 10 m on, feet from 10 ft on. */
export function longLength(mm: number, unit: DisplayUnit): string {
  if (unit === "inch")
    return Math.abs(mm) < 120 * MM_PER_INCH ? length(mm, unit) : `${number(mm / MM_PER_INCH / 12, 2)} ft`;
  return Math.abs(mm) < 10_000 ? length(mm, unit) : `${number(mm / 1000, 2)} m`;
}

/** "110.2 mm/s", "4.339 in/s". */
export function speed(mmPerSecond: number, unit: DisplayUnit): string {
  return `${length(mmPerSecond, unit)}/s`;
}

/** "151.3°". */
export function angle(deg: number): string {
  return `${number(deg)}°`;
}

/** Seconds as "0:42", "52:10", "1 h 02". */
export function time(seconds: number): string {
  if (!Number.isFinite(seconds)) return "\u2013";
  const whole = Math.round(Math.abs(seconds));
  const two = (value: number) => String(value).padStart(2, "0");
  const text =
    whole < 3600
      ? `${Math.floor(whole / 60)}:${two(whole % 60)}`
      : `${Math.floor(whole / 3600)} h ${two(Math.floor((whole % 3600) / 60))}`;
  return seconds < 0 && whole > 0 ? MINUS + text : text;
}

const SIGNS: Readonly<Record<string, string>> = { USD: "$", EUR: "€", GBP: "£", JPY: "¥" };

/** "$1.20"; a currency without a sign of its own behind it: "1.20 CHF". */
export function money(value: number, currency: string | null): string {
  const text = number(Math.abs(value), 2);
  const sign = value < 0 && /[1-9]/.test(text) ? MINUS : "";
  const before = currency === null ? "" : SIGNS[currency];
  return before === undefined ? `${sign}${text} ${currency}` : `${sign}${before}${text}`;
}

/** A share of 1: "37 %". */
export function percent(share: number, digits = 0): string {
  return `${number(share * 100, digits)} %`;
}

/** "1 edge", "13 edges". */
export function count(many: number, one: string, more = `${one}s`): string {
  return `${number(many, 0)} ${many === 1 ? one : more}`;
}

/** With a plus in front of what is not negative, for differences. */
export function signed(value: number, shown: (value: number) => string): string {
  const text = shown(value);
  return text.startsWith(MINUS) ? text : `+${text}`;
}

/** "3.4k", "69k", "1.2M": for counts whose last digits do not matter. */
export function roughly(many: number): string {
  if (many < 1000) return String(many);
  if (many < 999_500) return `${number(many / 1000, many < 10_000 ? 1 : 0)}k`;
  return `${number(many / 1e6, 1)}M`;
}

/** How long ago, of seconds: "now", "12 s ago", "5 min ago", "3 h ago", "2 days ago". */
export function ago(seconds: number): string {
  if (seconds < 2) return "now";
  if (seconds < 60) return `${Math.floor(seconds)} s ago`;
  if (seconds < 3600) return `${Math.floor(seconds / 60)} min ago`;
  if (seconds < 86_400) return `${Math.floor(seconds / 3600)} h ago`;
  return `${count(Math.floor(seconds / 86_400), "day")} ago`;
}

/** What a design without errors is where nothing has looked at whether one part hits another. */
export const LIMITS_ONLY = "within the machine's limits; collisions not checked";
