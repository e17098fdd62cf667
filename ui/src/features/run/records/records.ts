/** Records of wires in words. */

import type { RunEntry } from "../../../generated/responses";
import { count, type DisplayUnit, deviation } from "../../../shared/figures/format";
import type { Tone } from "../../../shared/lists/Mark";
import { isInWire, type MachineState, type WireState } from "../../../state/machine/operator";

const TONES: Readonly<Record<NonNullable<RunEntry["outcome"]>, Tone>> = {
  finished: "fine",
  sent: "warning",
  abandoned: "info",
  unfinished: "warning",
};

/** "21 Nov 2026, 20:41". */
const when = (at: string): string =>
  new Date(at).toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" });

function outcome({ outcome: what, made, steps }: RunEntry): string {
  if (what === "finished") return steps === null ? "finished" : `${count(steps, "step")} done`;
  if (what === "sent") return `${steps === null ? "sent" : `${count(steps, "step")} sent`}, not acknowledged`;
  const ended = what === "abandoned" ? "given up" : "interrupted";
  return made === 0
    ? `${ended} before its first step was done`
    : `${ended} after step ${made ?? "?"} of ${steps ?? "?"}`;
}

/**
 * The record of the wire that the connected machine is bending; null where it bends none. A journal without an end is that of a wire
 * under way as much as of an interrupted one. `runs` has the last one first: what was begun before it on this machine is over.
 */
export function bentNow(runs: readonly RunEntry[] | null, state: MachineState | null): RunEntry | null {
  if (!state?.wire || !isInWire(state.phase)) return null;
  const { job_hash, wire, piece } = state.wire;
  const isIt = (run: RunEntry) =>
    run.outcome === "unfinished" &&
    run.machine === state.machine &&
    run.job_hash === job_hash &&
    run.wire === wire &&
    (run.piece?.number ?? null) === (piece?.number ?? null);
  return runs?.find(isIt) ?? null;
}

/** "being bent: 2 of 5 steps done"; what the machine reports is newer than the record. */
const underWay = ({ phase }: MachineState, { made, of, done_by }: WireState): string =>
  `${phase === "holding" ? "paused" : "being bent"}: ${made} of ${of} steps ${done_by === "machine" ? "done" : "by the clock"}`;

/** Whether its job has several wires, as far as the records tell: another one of them was begun. */
const isOneOfSeveral = ({ job_hash }: RunEntry, runs: readonly RunEntry[]): boolean =>
  job_hash !== null && runs.some((other) => other.job_hash === job_hash && (other.wire ?? 0) > 0);

/**
 * One record in a line: which wire and what became of it, and when. `by`: the machine that is bending it; `among`: the other records, which
 * tell whether it is the first of several wires.
 */
export function madePhrase(
  run: RunEntry,
  unit: DisplayUnit,
  by: MachineState | null = null,
  among: readonly RunEntry[] = [],
): { readonly tone: Tone; readonly what: string; readonly sub: string } {
  const { name, wire, piece, started, machine, interruptions, pauses, worst_deviation_mm: worst, problem } = run;
  const numbered = wire !== null && (wire > 0 || isOneOfSeveral(run, among));
  const which = `${numbered ? `, wire ${wire + 1}` : ""}${piece ? `, piece ${piece.number} of ${piece.of}` : ""}`;
  const what = `${name ?? "Unknown design"}${which}`;
  if (problem || !run.outcome) return { tone: "error", what, sub: problem ?? "Its journal cannot be read." };
  const now = by?.wire ? underWay(by, by.wire) : null;
  const parts = [
    now ?? outcome(run),
    worst === null ? "" : `worst vertex ${deviation(worst, unit)}`,
    interruptions ? count(interruptions, "interruption") : "",
    pauses ? count(pauses, "pause") : "",
    started ? when(started) : "",
    machine ?? "",
  ];
  return { tone: now ? "info" : TONES[run.outcome], what, sub: parts.filter((part) => part !== "").join(" · ") };
}

/** Wires that were begun and neither finished nor given up, the last one first. */
export const unfinishedOf = (runs: readonly RunEntry[] | null): readonly RunEntry[] =>
  (runs ?? []).filter(({ outcome }) => outcome === "unfinished");

/** What is said of them before a machine is connected, which then asks about its own; null where there is none. */
export function interruptedPhrase(
  runs: readonly RunEntry[] | null,
  unit: DisplayUnit,
): { readonly what: string; readonly sub: string } | null {
  const left = unfinishedOf(runs);
  const [last] = left;
  if (!last) return null;
  const one = left.length === 1;
  const { what, sub } = madePhrase(last, unit, null, runs ?? []);
  return {
    what: one ? "A wire was interrupted" : `${count(left.length, "wire")} were interrupted`,
    sub: `${one ? "" : "The last: "}${what}, ${sub}. It may still be in the machine: connect that machine to resume, or to give the wire up.`,
  };
}
