/** What another machine changes for a design, in phrases. */

import type { MachineSide, OtherSide, WireDiagnostic } from "../../../generated/responses";
import { count, type DisplayUnit, LIMITS_ONLY, longLength, money, time } from "../../../shared/figures/format";
import type { Tone } from "../../../shared/lists/Mark";

export interface Difference {
  readonly tone: Tone;
  readonly what: string;
  readonly sub: string | null;
}

/** What a diagnostic is about: one, and several. */
const NOUNS: Readonly<Record<string, readonly [string, string]>> = {
  edge_too_short: ["short edge", "short edges"],
  feed_too_short: ["short feed", "short feeds"],
  feed_too_long: ["long feed", "long feeds"],
  arcs_overlap: ["pair of bends that overlap", "pairs of bends that overlap"],
  bend_too_sharp: ["sharp bend", "sharp bends"],
  bend_out_of_reach: ["bend out of reach", "bends out of reach"],
  bend_too_small: ["small bend", "small bends"],
  lead_too_short: ["wire that ends too near its first bend", "wires that end too near their first bend"],
  corner_too_near: ["corner that is too near", "corners that are too near"],
  bend_in_scatter: ["slight bend", "slight bends"],
  corner_not_made: ["gentle corner", "gentle corners"],
  fold_back: ["fold back", "fold backs"],
  rotation_out_of_range: ["rotation out of range", "rotations out of range"],
  stock_too_long: ["wire that is too long", "wires that are too long"],
};

/** What is said of the whole rather than counted: where it becomes feasible, and where it does not any more. */
const WHOLE: Readonly<Record<string, Readonly<Record<"feasible" | "infeasible", string>>>> = {
  wire_does_not_fit: { feasible: "The wire fits", infeasible: "The wire does not fit" },
  no_euler_path: { feasible: "One wire is enough", infeasible: "One wire is not enough" },
};

/** The same kind together, most first. */
function kinds(diagnostics: readonly WireDiagnostic[]): (readonly [string, WireDiagnostic[]])[] {
  const all = new Map<string, WireDiagnostic[]>();
  for (const one of diagnostics) all.set(one.code, [...(all.get(one.code) ?? []), one]);
  return [...all].toSorted(([, a], [, b]) => b.length - a.length);
}

function findings(diagnostics: readonly WireDiagnostic[], becomes: "feasible" | "infeasible"): Difference[] {
  return kinds(diagnostics).map(([code, all]) => {
    const noun = NOUNS[code];
    const what = noun
      ? count(all.length, ...noun)
      : count(all.length, code.replaceAll("_", " "), code.replaceAll("_", " "));
    return {
      tone: becomes === "feasible" ? "fine" : "error",
      what: WHOLE[code]?.[becomes] ?? `${what} ${all.length === 1 ? "becomes" : "become"} ${becomes}`,
      sub: becomes === "infeasible" ? (all[0]?.message ?? null) : null,
    };
  });
}

/** "52:10 → 38:05", or the one where both are the same; null where neither is known. */
function change(before: number | null, after: number | null, shown: (value: number) => string): string | null {
  if (after === null) return before === null ? null : `${shown(before)} → not known`;
  if (before === null || shown(before) === shown(after)) return shown(after);
  return `${shown(before)} → ${shown(after)}`;
}

/** Time, stock, bends and cost of the stock, before and after: each a name and a phrase. */
export function figures(from: MachineSide, to: OtherSide, unit: DisplayUnit): readonly (readonly [string, string])[] {
  // There is no exchange rate between currencies.
  const otherMoney = to.stock_cost !== null && from.currency !== to.currency;
  const rows: readonly (readonly [string, string | null])[] = [
    ["Time", change(from.time_s, to.time_s, time)],
    ["Stock", change(from.stock_mm, to.stock_mm, (mm) => longLength(mm, unit))],
    ["Bends", change(from.bends, to.bends, (many) => String(many))],
    [
      "Cost",
      change(otherMoney ? null : from.stock_cost, to.stock_cost, (value) =>
        money(value, to.stock_cost === null ? from.currency : to.currency),
      ),
    ],
  ];
  return rows.flatMap(([name, phrase]) => (phrase === null ? [] : [[name, phrase] as const]));
}

/** What becomes feasible and what does not any more; that nothing changes is said as well. */
export function differences(from: MachineSide, to: OtherSide): readonly Difference[] {
  const found = [
    ...findings(to.newly_feasible.diagnostics, "feasible"),
    ...findings(to.newly_infeasible.diagnostics, "infeasible"),
  ];
  if (to.feasible && !from.feasible) found.unshift({ tone: "fine", what: `It is ${LIMITS_ONLY}`, sub: null });
  if (!to.feasible && from.feasible) found.unshift({ tone: "error", what: "It cannot be bent as it is", sub: null });
  if (found.length === 0) {
    const what = to.feasible
      ? "Within the limits of both; collisions there not checked"
      : to.errors === 1
        ? "The same error on both"
        : `The same ${to.errors} errors on both`;
    found.push({ tone: to.feasible ? "fine" : "warning", what, sub: null });
  }
  return [...found, ...warnings(to.newly_warned.diagnostics)];
}

/** What there is to look at on the other machine, and was not on the first. */
const warnings = (diagnostics: readonly WireDiagnostic[]): Difference[] =>
  kinds(diagnostics).map(([, all]) => ({
    tone: "warning",
    what: all.length === 1 ? "A new warning" : `${all.length} new warnings`,
    sub: all[0]?.message ?? null,
  }));
