/** Lines to a machine and from it, as they are kept and shown. */

export interface ConsoleLine {
  /** Counts up, so that a line stays the same one. */
  readonly id: number;
  readonly toMachine: boolean;
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

/** The lines as text to be copied: `>` to the machine, `<` from it. */
export function asText(lines: readonly ConsoleLine[]): string {
  return lines.map(({ toMachine, text }) => `${toMachine ? ">" : "<"} ${text}`).join("\n");
}
