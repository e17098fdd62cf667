/** Lines to a machine and from it, as they are kept and shown. */

export interface ConsoleLine {
  /** Counts up, so that a line stays the same one. */
  readonly id: number;
  readonly toMachine: boolean;
  /** When it was heard, ms since 1970. */
  readonly at: number;
  readonly text: string;
}

/** More are not kept: the oldest go. */
const MAX_LINES = 2000;

/** Adds lines; what is too much goes at the beginning. */
export function withLines(
  lines: readonly ConsoleLine[],
  more: readonly Omit<ConsoleLine, "id">[],
  most = MAX_LINES,
): readonly ConsoleLine[] {
  const first = (lines.at(-1)?.id ?? 0) + 1;
  return [...lines, ...more.map((line, k) => ({ ...line, id: first + k }))].slice(-most);
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

/** The lines as text to be copied: when, and `>` to the machine, `<` from it. */
export function asText(lines: readonly ConsoleLine[]): string {
  return lines.map(({ toMachine, at, text }) => `${clockOf(at)} ${toMachine ? ">" : "<"} ${text}`).join("\n");
}
