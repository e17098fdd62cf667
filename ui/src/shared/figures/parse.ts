import { type DisplayUnit, MM_PER_INCH, unitSize } from "./format";

const MM_PER_FOOT = 304.8;

/** mm of one of what people write behind a number. */
const LENGTHS: Readonly<Record<string, number>> = {
  mm: 1,
  cm: 10,
  m: 1000,
  in: MM_PER_INCH,
  inch: MM_PER_INCH,
  inches: MM_PER_INCH,
  '"': MM_PER_INCH,
  "\u2033": MM_PER_INCH,
  ft: MM_PER_FOOT,
  "'": MM_PER_FOOT,
  "\u2032": MM_PER_FOOT,
};

/** "12.5", "12,5", "1/2", "1 1/2", "1 250,5", "−3", or a sum such as "-0.3+30"; null for what is no number. */
export function parseNumber(text: string): number | null {
  return parseOneNumber(text) ?? parseSum(text, parseOneNumber);
}

function parseOneNumber(text: string): number | null {
  const plain = text.replace(/\u2212/g, "-").trim();
  const fraction = /^([+-]?)(?:(\d+)[\s\u202f]+)?(\d+)\s*\/\s*(\d+)$/.exec(plain);
  if (fraction) {
    const [, sign, whole = "0", above, below] = fraction;
    const value = Number(whole) + Number(above) / Number(below);
    return Number.isFinite(value) ? (sign === "-" ? -value : value) : null;
  }
  // What sets thousands apart has three digits behind it: 5'6 is no 56, and 5 6 neither.
  const tight = plain.replace(/^([+-])\s+/, "$1").replace(/(\d)[\s\u202f\u2009'](?=\d{3}(?!\d))/g, "$1");
  // Of a comma and a dot the last is the decimal sign; the other one sets thousands apart.
  const decimal = tight.lastIndexOf(",") > tight.lastIndexOf(".") ? "," : ".";
  const other = decimal === "," ? "." : ",";
  const number = tight.replaceAll(other, "").replace(decimal, ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(number) ? Number(number) : null;
}

/**
 * A sum of terms that `read` reads: "12+3.5", "-0.3 + 30", "1 in - 2 mm". A sign that begins a term or stands in an exponent is part of
 * it. null where there is one term alone, or where one is none.
 */
function parseSum(text: string, read: (term: string) => number | null): number | null {
  const plain = text.replace(/\u2212/g, "-").trim();
  // Behind a digit, a unit or its end: "5'-6" and "1e-3" are one term.
  const parts = plain.split(/(?<=[\d.,a-z"'\u2032\u2033°]\s*)(?<!\de)([+-])(?=\s*[\d.,])/i);
  if (parts.length < 3) return null;
  let sum = 0;
  for (let at = 0; at < parts.length; at += 2) {
    const term = read(parts[at] ?? "");
    if (term === null) return null;
    sum += parts[at - 1] === "-" ? -term : term;
  }
  return sum;
}

/** Feet and inches: 5'6", 5' 6 1/2", 5'-6", 5 ft 6 in. With room before it a minus takes away: see parseSum. The inches are fewer than a foot has: 1'250 is a number with its thousands apart. */
const FEET = /^([+-]?)\s*(\d+)\s*(?:'|\u2032|ft)(?:-|\s*)((?!\d{3})\d.*?)\s*(?:"|\u2033|in|inch|inches)?$/i;

/** mm; null where the text is no feet and inches. */
function parseFeet(text: string): number | null {
  const [, sign, feet = "", rest = ""] = FEET.exec(text.replace(/\u2212/g, "-")) ?? [];
  const inches = parseOneNumber(rest);
  if (inches === null || inches >= 12) return null;
  const value = Number(feet) * MM_PER_FOOT + inches * MM_PER_INCH;
  return sign === "-" ? -value : value;
}

/** A length in mm, or a sum of several; a number without a unit is in the unit that is shown. */
export function parseLength(text: string, unit: DisplayUnit): number | null {
  return parseOneLength(text, unit) ?? parseSum(text, (term) => parseOneLength(term, unit));
}

function parseOneLength(text: string, unit: DisplayUnit): number | null {
  const feet = parseFeet(text.trim());
  if (feet !== null) return feet;
  const [, before = "", word = ""] = /^(.*?)\s*([a-z]+|["'\u2032\u2033])?$/i.exec(text.trim()) ?? [];
  const value = parseOneNumber(before);
  const factor = word === "" ? unitSize(unit) : LENGTHS[word.toLowerCase()];
  return value === null || factor === undefined ? null : value * factor;
}

/** An angle in degrees: "45", "45°", "45 deg", "0.5 rad", or a sum of several. */
export function parseAngle(text: string): number | null {
  return parseOneAngle(text) ?? parseSum(text, parseOneAngle);
}

function parseOneAngle(text: string): number | null {
  const [, before = "", word = ""] = /^(.*?)\s*(°|deg|degrees|rad)?$/i.exec(text.trim()) ?? [];
  const value = parseOneNumber(before);
  if (value === null) return null;
  return word.toLowerCase() === "rad" ? (value * 180) / Math.PI : value;
}
