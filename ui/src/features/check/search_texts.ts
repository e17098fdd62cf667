/** The words for what came of a search for an order of the bends that hits nothing. */

import type {
  AvoidedCollisions,
  DiagnosticReport,
  FoundSoFar,
  HelpReport,
  UnfoundReport,
} from "../../generated/responses";
import { count, type DisplayUnit, length, number } from "../../shared/figures/format";

/** What was in the way where the search came farthest: "At vertex 1 the wire would hit the nozzle". */
export function obstacleOf({ vertex, body, search }: DiagnosticReport, unit: DisplayUnit): string | null {
  if (!search?.obstacle) return null;
  // Whether it would be hit, too, the search does not tell apart.
  const { clearance_mm } = search;
  const would = clearance_mm > 0 ? `come within ${length(clearance_mm, unit, clearance_mm < 1 ? 1 : 0)} of` : "hit";
  const what = {
    body: `the wire would ${would} the ${body ?? "machine"}`,
    stock: `the wire would ${would} the wire that is still to be bent`,
    "head-limit": "the head cannot turn far enough",
  };
  const place = vertex === undefined || vertex === null ? "There" : `At vertex ${vertex}`;
  return `${place} ${what[search.obstacle]}`;
}

/**
 * Of a part that was not searched, since it has bends that no order avoids: that, and where they are. Null where it was searched, or
 * was ended before its first step.
 */
export function unsearchedOf({
  vertex,
  vertices,
  search,
}: DiagnosticReport): { readonly why: string; readonly where: string } | null {
  const all = vertices?.length ? vertices : vertex === undefined || vertex === null ? [] : [vertex];
  if (!search || search.steps_checked > 0 || search.passed !== null || all.length === 0) return null;
  const NAMED = 6;
  const named = all.slice(0, NAMED).join(", ");
  const more = all.length - NAMED;
  return all.length === 1
    ? { why: "It was not searched: a bend that no order avoids comes first.", where: `The bend at vertex ${named}` }
    : {
        why: "It was not searched: bends that no order avoids come first.",
        where: `The bends at vertices ${named}${more > 0 ? ` and ${more} more` : ""}`,
      };
}

/** Whether nothing was searched, whatever the settings but the number of wires: then it would not be the next time either. */
export const isUnsearched = ({ found, unfound }: AvoidedCollisions): boolean =>
  !found && unfound.length > 0 && unfound.every((report) => unsearchedOf(report) !== null);

/** What a search has found: "Found so far: 2 wires without a collision, 24.0 mm doubled." */
export function foundSoFar({ part, parts, best }: FoundSoFar, unit: DisplayUnit): string {
  const ofPart = parts > 1 ? ` for part ${part} of ${parts}` : "";
  if (!best) return `No program without a collision found${ofPart} so far.`;
  const doubled = length(best.doubled_mm, unit);
  const more = doubled === length(0, unit) ? "" : `, ${doubled} doubled`;
  return `Found${ofPart} so far: ${count(best.wires, "wire")} without a collision${more}.`;
}

/** How far the search came, and how much of all it has tried. */
export function reachOf({ passed, of, exhausted, steps_checked, ended }: UnfoundReport): string {
  const far =
    passed === null || of === null ? null : `The search got as far as edge ${number(passed, 0)} of ${number(of, 0)}.`;
  const much = exhausted
    ? "Every walk of one wire was tried."
    : steps_checked > 0
      ? `${number(steps_checked, 0)} steps were checked${ended ? " until it was ended" : ""}.`
      : "It was ended before it checked a step.";
  return [far, much].filter(Boolean).join(" ");
}

/** Where a help cuts the wire: "Cut at vertices: from 0 to 4, from 4 to 7"; null where there is one wire. */
export function cutsOf({ walks }: HelpReport): string | null {
  if (walks.length < 2) return null;
  const NAMED = 6;
  const ends = walks.slice(0, NAMED).map(({ from, to }) => `from ${from} to ${to}`);
  const more = walks.length - ends.length;
  return `Cut at vertices: ${ends.join(", ")}${more > 0 ? ` and ${more} more` : ""}`;
}

const KINDS: Readonly<Record<UnfoundReport["tried"][number], string>> = {
  "more-wires": "more wires",
  "double-edges": "an edge run along twice",
  "move-vertex": "a vertex near there moved",
};

/** Which kinds of changes were tried without success, and whether all were. */
export function inVainOf({ helps, tried, ended }: UnfoundReport): string[] {
  const helping = new Set(helps.map(({ help }) => help));
  const vain = tried.filter((kind) => !helping.has(kind)).map((kind) => KINDS[kind]);
  const said = vain.length > 0 ? [`Nothing was found with ${listed(vain)}.`] : [];
  if (!ended) return said;
  return [
    ...said,
    tried.length > 0 ? "Other changes were not tried to the end." : "No change that could help was tried.",
  ];
}

function listed(all: readonly string[]): string {
  const [last, ...before] = all.toReversed();
  return before.length > 0 ? `${before.toReversed().join(", ")} or ${last}` : (last ?? "");
}
