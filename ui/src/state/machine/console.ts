/** Lines to a machine and from it, as they are kept and shown. */

export interface ConsoleLine {
  /** Counts up, so that a line stays the same one. */
  readonly id: number;
  /** Null of what is no line on the wire, such as that a stop was pressed which nothing was sent for. */
  readonly toMachine: boolean | null;
  /** When it was heard, ms since 1970. */
  readonly at: number;
  readonly text: string;
}

/** More are not kept: the oldest go. */
const MAX_LINES = 2000;

/** Adds lines by their time, which may be before that of lines already there; what is too much goes at the beginning. */
export function withLines(
  lines: readonly ConsoleLine[],
  more: readonly Omit<ConsoleLine, "id">[],
  most = MAX_LINES,
): readonly ConsoleLine[] {
  const first = lines.reduce((largest, { id }) => Math.max(largest, id), 0) + 1;
  const all = [...lines, ...more.map((line, k) => ({ ...line, id: first + k }))];
  return all.sort((one, other) => one.at - other.at).slice(-most);
}

/** Which lines are shown: every word of the filter has to be in the line, whatever its case. */
export function filtered(lines: readonly ConsoleLine[], filter: string): readonly ConsoleLine[] {
  const words = filter
    .toLowerCase()
    .split(/\s+/)
    .filter((word) => word !== "");
  if (words.length === 0) return lines;
  return lines.filter(({ text }) => words.every((word) => text.toLowerCase().includes(word)));
}

/** "14:03:07.250", by the clock of this computer. */
export function clockOf(at: number): string {
  const when = new Date(at);
  const two = (value: number) => String(value).padStart(2, "0");
  const ms = String(when.getMilliseconds()).padStart(3, "0");
  return `${two(when.getHours())}:${two(when.getMinutes())}:${two(when.getSeconds())}.${ms}`;
}

/** Most lines are recalled within a few. */
const MAX_TYPED = 100;

/** What was typed, the last at the end; a line that is typed again is not kept twice in a row. */
export function withTyped(typed: readonly string[], line: string): readonly string[] {
  return typed.at(-1) === line ? typed : [...typed, line].slice(-MAX_TYPED);
}

/** Which line is recalled; past the last it is the draft that was being typed. */
export interface Recalled {
  readonly at: number;
  readonly draft: string;
}

/** The line before (-1) or after (1). */
export function recall(typed: readonly string[], { at, draft }: Recalled, way: -1 | 1): Recalled {
  return { at: Math.min(Math.max(at + way, 0), typed.length), draft };
}

const signOf = (toMachine: boolean | null): string => (toMachine === null ? "-" : toMachine ? ">" : "<");

/** The lines as text to be copied: when, and `>` to the machine, `<` from it, `-` neither. */
export function asText(lines: readonly ConsoleLine[]): string {
  return lines.map(({ toMachine, at, text }) => `${clockOf(at)} ${signOf(toMachine)} ${text}`).join("\n");
}
