/** Records of wires in words. */

import type { RunEntry } from "../../generated/responses";
import { count, type DisplayUnit, number } from "../../shared/format";
import type { Tone } from "../../shared/Mark";

const TONES: Readonly<Record<NonNullable<RunEntry["outcome"]>, Tone>> = { finished: "fine", abandoned: "info", unfinished: "warning" };

/** How far a vertex is off: finer than lengths are shown elsewhere. */
export function deviation(mm: number, unit: DisplayUnit): string {
  return unit === "inch" ? `${number(mm / 25.4, 4)} in` : `${number(mm, 2)} mm`;
}

/** "21 Nov 2026, 20:41". */
const when = (at: string): string => new Date(at).toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" });

function outcome({ outcome: what, made, steps }: RunEntry): string {
  if (what === "finished") return steps === null ? "made" : `${count(steps, "step")} made`;
  return `${what === "abandoned" ? "given up" : "interrupted"} after step ${made ?? "?"} of ${steps ?? "?"}`;
}

/** One record in a line: whose wire and what became of it, and when. */
export function madePhrase(run: RunEntry, unit: DisplayUnit): { readonly tone: Tone; readonly what: string; readonly sub: string } {
  const { name, wire, started, machine, interruptions, worst_deviation_mm: worst, problem } = run;
  const what = `${name ?? "Unknown design"}${wire ? `, wire ${wire}` : ""}`;
  if (problem || !run.outcome) return { tone: "error", what, sub: problem ?? "Its journal cannot be read." };
  const parts = [
    outcome(run),
    worst === null ? "" : `worst vertex ${deviation(worst, unit)}`,
    interruptions ? count(interruptions, "interruption") : "",
    started ? when(started) : "",
    machine ?? "",
  ];
  return { tone: TONES[run.outcome], what, sub: parts.filter((part) => part !== "").join(" · ") };
}
