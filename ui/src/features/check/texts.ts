import type { Collisions, DiagnosticCode, DiagnosticReport, LiveCheck } from "../../generated/responses";
import { count, type DisplayUnit, length, meetingText, number, sentence } from "../../shared/figures/format";
import type { Tone } from "../../shared/lists/Mark";
import type { Known } from "../../state/design/collisions";
import { isCollision, isNear } from "../../state/design/findings";
import { isCompensated } from "../viewport/marks";

/** A measured value or a limit with its unit, with so many digits more than usual; null where there is none. */
export function valueText(
  value: number | null | undefined,
  unit: string | null | undefined,
  shown: DisplayUnit,
  finer = 0,
): string | null {
  if (value === null || value === undefined) return null;
  if (unit === "mm") return length(value, shown, finer);
  if (unit === "deg") return `${number(value, 1 + finer)}°`;
  if (unit === "mpa") return `${number(value, 1 + finer)} MPa`;
  return number(value, Number.isInteger(value) ? 0 : 1 + finer);
}

/** A value and its limit, with as many digits as tell them apart: a value like its limit is beyond nothing. */
function besideLimit({ value, limit, unit }: DiagnosticReport, shown: DisplayUnit): readonly (string | null)[] {
  const pair = (finer: number) => [value, limit].map((one) => valueText(one, unit, shown, finer));
  const isTold = ([one, other]: readonly (string | null)[]) => one !== other || one === null;
  return value === limit ? pair(0) : ([0, 1, 2].map(pair).find(isTold) ?? pair(3));
}

/** The measured value of a finding, for a label; null where it has none. */
export function measureText(report: DiagnosticReport, shown: DisplayUnit): string | null {
  const { code, value, unit } = report;
  if (isCollision(code)) return meetingText(value ?? 0, shown);
  return unit ? valueText(value, unit, shown) : null;
}

type Place = Pick<DiagnosticReport, "vertex" | "vertices" | "edge" | "edges" | "value" | "limit" | "step" | "body">;

/** How one and how several of a kind are named in a line of the list; null: its own message names it. */
type Title = { one(report: Place): string; many(count: string, first: Place): string } | null;

/** A title for every kind of finding: one that is new does not compile before it is decided how it is named. */
const TITLES: Readonly<Record<DiagnosticCode, Title>> = {
  no_euler_path: {
    one: ({ value, limit }) => `${tooFew(limit ?? 2)} (${count(value ?? 0, "odd corner")})`,
    many: (n) => `${n} parts with too many odd corners`,
  },
  edge_too_short: { one: (r) => `${edgeName(r)} too short`, many: (n) => `${n} edges too short` },
  edge_near_limit: {
    one: (r) => `${edgeName(r)} close to the shortest`,
    many: (n) => `${n} edges close to the shortest`,
  },
  feed_too_short: {
    one: (r) => `${edgeName(r)}: feed too short`,
    many: (n) => `${n} feeds too short after compensation`,
  },
  feed_near_limit: {
    one: (r) => `${edgeName(r)}: feed close to the shortest`,
    many: (n) => `${n} feeds close to the shortest`,
  },
  feed_too_long: { one: (r) => `${edgeName(r)}: feed too long`, many: (n) => `${n} feeds too long` },
  arcs_overlap: {
    one: (r) => `${edgeName(r)} too short for the bends at its ends`,
    many: (n) => `${n} edges too short for the bends at their ends`,
  },
  bend_too_sharp: { one: (r) => `Bend${at(r)} too sharp`, many: (n) => `${n} bends too sharp` },
  bend_near_limit: { one: (r) => `Bend${at(r)} close to the limit`, many: (n) => `${n} bends close to the limit` },
  bend_out_of_reach: {
    one: (r) => `Bend${at(r)} out of reach of the axis`,
    many: (n) => `${n} bends out of reach of the axis`,
  },
  lead_too_short: {
    one: (r) => `Wire too short before its first bend${at(r)}`,
    many: (n) => `${n} wires too short before their first bend`,
  },
  corner_too_near: {
    one: (r) => `Corner too near before the bend${at(r)}`,
    many: (n) => `${n} corners too near before a bend`,
  },
  corner_within_reach: {
    one: (r) => `The peg touches bent wire${at(r)}`,
    many: (n) => `The peg touches bent wire at ${n} bends`,
  },
  head_not_measured: null,
  bend_too_small: { one: (r) => `Bend${at(r)} too small`, many: (n) => `${n} bends too small` },
  fold_back: { one: (r) => `The wire folds back${at(r)}`, many: (n) => `The wire folds back at ${n} places` },
  bend_in_scatter: {
    one: (r) => `Bend${at(r)} smaller than bends scatter`,
    many: (n) => `${n} bends smaller than bends scatter`,
  },
  corner_not_made: {
    one: (r) => `Corner${at(r)} gentler than the axis resolves`,
    many: (n) => `${n} corners gentler than the axis resolves`,
  },
  meets_machine: {
    one: (r) => `The wire ${meets(r)} the ${r.body ?? "machine"}${inStep(r)}`,
    many: (n, first) => `The wire ${meets(first)} ${n} bodies of the machine`,
  },
  meets_stock: {
    one: (r) => `The wire ${meets(r)} itself${inStep(r)}`,
    many: (n, first) => `The wire ${meets(first)} itself: ${n} times`,
  },
  frame_unsupported: { one: () => "Nothing holds the frame", many: (n) => `Nothing holds ${n} parts of the frame` },
  frame_mechanism: { one: (r) => `The frame does not stand${at(r)}`, many: (n) => `${n} parts do not stand` },
  strut_overstressed: { one: (r) => `${edgeName(r)} yields`, many: (n) => `${n} edges yield` },
  strut_near_buckling: {
    one: nearBuckling,
    many: (n, first) => (buckles(first) ? `${n} edges buckle` : `${n} edges are near buckling`),
  },
  frame_too_soft: {
    one: (r) => `The frame sags too far${at(r)}`,
    many: (n) => `The frame sags too far at ${n} places`,
  },
  strut_floating: { one: (r) => `${edgeName(r)} hangs on nothing`, many: (n) => `${n} edges hang on nothing` },
  no_head_direction: {
    one: (r) => `The head cannot place ${edgeName(r).toLowerCase()}`,
    many: (n) => `The head cannot place ${n} edges`,
  },
  out_of_workspace: { one: (r) => `Out of the workspace${at(r)}`, many: (n) => `${n} vertices out of the workspace` },
  sequence_not_found: null,
  sequence_wrong: null,
  no_clear_program: {
    one: (r) => `No program without a collision was found${at(r)}`,
    many: (n) => `${n} parts have no program without a collision`,
  },
  rotation_out_of_range: {
    one: (r) => `The head would have to turn too far${at(r)}`,
    many: (n) => `The head would have to turn too far at ${n} places`,
  },
  coincident_vertices: {
    one: (r) => `Vertices lie on each other${at(r)}`,
    many: (n) => `${n} pairs of vertices lie on each other`,
  },
  edges_meet: { one: meeting, many: (n) => `${n} places where the wire meets itself` },
  isolated_vertex: { one: (r) => `Vertex ${r.vertex ?? "?"} has no edge`, many: (n) => `${n} vertices have no edge` },
  zero_length_edge: { one: (r) => `${edgeName(r)} has no length`, many: (n) => `${n} edges have no length` },
  parallel_edges: { one: (r) => `${edgeName(r)} lies on another`, many: (n) => `${n} edges lie on others` },
  several_wires: {
    one: ({ value }) => `The parts are not connected: ${count(value ?? 0, "wire")}`,
    many: (n) => `${n} designs of several wires`,
  },
  doubled_edge: { one: (r) => `${edgeName(r)} is laid twice`, many: (n) => `${n} edges are laid twice` },
  no_edges: null,
  route_refused: null,
  stock_too_long: null,
  wire_does_not_fit: null,
  bend_torque_low: null,
  bend_radius_small: null,
  part_sags: null,
};

/** Two vertices may be odd for each open wire. */
const tooFew = (allowed: number): string =>
  allowed === 0
    ? "Cannot be a closed wire"
    : `Needs more than ${allowed === 2 ? "one wire" : count(allowed / 2, "wire")}`;

function edgeName({ edge, edges }: Place): string {
  const all = edges && edges.length > 1 ? edges : null;
  return all ? `Edges ${all.join(", ")}` : `Edge ${edge ?? "?"}`;
}

/** The value is the share of the load at which it buckles. */
const buckles = ({ value }: Place): boolean => (value ?? 0) >= 1;

/** Below zero is how near it comes. */
const meets = ({ value }: Place): string => ((value ?? 0) < 0 ? "comes near" : "hits");

/** Of several edges the value is that of the worst, which is the first. */
function nearBuckling(report: Place): string {
  const more = (report.edges?.length ?? 1) - 1;
  const others = `${more} more ${more === 1 ? "is" : "are"} near buckling`;
  if (!buckles(report)) return `${edgeName(report)} ${more > 0 ? "are" : "is"} near buckling`;
  return `Edge ${report.edge ?? "?"} buckles${more > 0 ? `; ${others}` : ""}`;
}

/** Two edges, an edge and a vertex, or two vertices; one or no vertex comes as `vertex` alone. */
function meeting({ vertex, vertices, edges }: Place): string {
  if (vertices && vertices.length > 1) return `Vertices ${vertices.join(" and ")} meet`;
  const both = edges?.join(" and ") ?? "?";
  return `Edges ${both} meet${vertex === null || vertex === undefined ? "" : ` at vertex ${vertex}`}`;
}

function inStep({ step }: Place): string {
  return step === null || step === undefined ? "" : ` in step ${step + 1}`;
}

function at({ vertex }: Place): string {
  return vertex === null || vertex === undefined ? "" : ` at vertex ${vertex}`;
}

/** Diagnostics of the same kind and severity, in the order in which they came; what is hit apart from what the wire only comes near. */
export interface Group {
  readonly key: string;
  readonly severity: DiagnosticReport["severity"];
  readonly reports: readonly DiagnosticReport[];
}

export function groupsOf(check: LiveCheck): Group[] {
  const groups = new Map<string, DiagnosticReport[]>();
  for (const report of check.diagnostics) {
    const key = `${report.severity}:${report.code}${isNear(report) ? ":near" : ""}`;
    groups.set(key, [...(groups.get(key) ?? []), report]);
  }
  return [...groups].map(([key, reports]) => ({ key, severity: reports[0]?.severity ?? "info", reports }));
}

/** One diagnostic in a line. */
export function whatOf(report: DiagnosticReport): string {
  return TITLES[report.code]?.one(report) ?? sentence(report.message);
}

/** A group in a line. */
export function titleOf({ reports }: Group): string {
  const [first] = reports;
  if (!first) return "";
  if (reports.length === 1) return whatOf(first);
  return (
    TITLES[first.code]?.many(number(reports.length, 0), first) ??
    `${sentence(first.message)} (${count(reports.length, "place")})`
  );
}

/** Whether the limit is a least: an error is below it, what is close to it is above. How deep a collision is has no least. */
function isLeast({ code, value, limit, severity }: DiagnosticReport): boolean {
  // Below the diameter wires touch; how far below says how bad that is.
  if (code === "edges_meet") return true;
  if (isCollision(code)) return false;
  const below = Math.abs(value ?? 0) < Math.abs(limit ?? 0);
  return severity === "error" ? below : !below;
}

/** The value that is farthest from what is allowed: the smallest where the limit is a least, else the largest. */
export function worstOf(reports: readonly DiagnosticReport[]): DiagnosticReport | undefined {
  const [first] = reports;
  const sign = first && isLeast(first) ? 1 : -1;
  // Of collisions the deepest, and of what is only near the nearest.
  const size = ({ code, value }: DiagnosticReport) => (isCollision(code) ? (value ?? 0) : Math.abs(value ?? 0)) * sign;
  return reports.toSorted((a, b) => size(a) - size(b))[0];
}

/** Findings whose value is a length that is fed. */
const OF_FEEDS: ReadonlySet<DiagnosticCode> = new Set(["feed_too_short", "feed_near_limit", "feed_too_long"]);

/** Whether it depends on dimensions of the machine that nobody has measured. */
export const isEstimated = ({ remedies }: DiagnosticReport): boolean =>
  remedies?.some(({ remedy }) => remedy === "measure_body") ?? false;

/** The grey line: value, limit and where the limit comes from. */
export function figuresOf({ reports }: Group, unit: DisplayUnit): string {
  const worst = worstOf(reports);
  if (!worst) return "";
  // A count says it all in the line above; what to do about it says more.
  if (!worst.unit) return sentence(worst.help);
  if (isCollision(worst.code)) {
    const figure = measureText(worst, unit);
    const deep = `${reports.length === 1 || isNear(worst) ? "" : "up to "}${figure}`;
    return isEstimated(worst) ? `${deep}; dimensions are estimates` : deep;
  }
  const [value, limit] = besideLimit(worst, unit);
  const which = reports.length === 1 ? "" : isLeast(worst) ? "least " : "most ";
  const what = OF_FEEDS.has(worst.code) ? "fed " : "";
  const parts = [value && `${what}${which}${value}`, limit && `limit ${limit}`];
  const figures = parts.filter(Boolean).join(", ");
  if (!figures) return sentence(worst.help);
  // The key of the profile is for the title.
  const source = worst.limit_reason ?? worst.limit_source;
  return source ? `${figures} \u00b7 ${source}` : figures;
}

/** Where the limit comes from, to the key of the profile. */
export function sourceOf({ reports }: Group): string | undefined {
  return worstOf(reports)?.limit_source ?? undefined;
}

export const TONES: Readonly<Record<DiagnosticReport["severity"], Tone>> = {
  error: "error",
  warning: "warning",
  info: "info",
};

/** How many diagnostics of a severity there are: places, not lines of the list. */
function many(check: LiveCheck, severity: DiagnosticReport["severity"]): number {
  return check.diagnostics.filter((report) => report.severity === severity).length;
}

/** As short as the head of a section is narrow. */
const OF_COLLISIONS: Readonly<Record<Known, string>> = {
  checked: "no collision found",
  checking: "checking collisions",
  unchecked: "no collision check",
};

/** The state of the checks in a phrase. */
export function phraseOf(
  check: LiveCheck | null,
  machine: boolean,
  empty: boolean,
  collisions: Known,
): { phrase: string; tone: Tone | null } {
  if (empty) return { phrase: "nothing to check yet", tone: null };
  if (!machine) return { phrase: "no machine chosen", tone: null };
  if (!check) return { phrase: "not checked", tone: null };
  const errors = many(check, "error");
  if (errors > 0) return { phrase: `${errors} to fix`, tone: "error" };
  const warnings = many(check, "warning");
  const rest = collisions === "checked" ? "" : `; ${OF_COLLISIONS[collisions]}`;
  if (warnings > 0) return { phrase: `${warnings} to look at${rest}`, tone: "warning" };
  return check.feasible
    ? { phrase: `within limits; ${OF_COLLISIONS[collisions]}`, tone: "fine" }
    : { phrase: "cannot be made", tone: "error" };
}

/** Why the design is refused, in a sentence or two, and what follows where it is bent all the same. */
export function refusalOf(check: LiveCheck | null): { readonly sub: string; readonly consequence: string } {
  const errors = check?.diagnostics.filter(({ severity }) => severity === "error") ?? [];
  const hits = errors.filter(({ code }) => isCollision(code)).length;
  const found =
    errors.length === 0
      ? "errors"
      : hits === errors.length
        ? count(hits, "collision")
        : `${count(errors.length, "error")}${hits > 0 ? `, ${count(hits, "collision")} among them` : ""}`;
  const consequence =
    hits === 0
      ? "The wire will not come out as designed, or the machine stops in the middle of it."
      : hits === errors.length
        ? "The wire will hit the machine or itself: watch it, with STOP at hand."
        : "The wire will hit the machine or itself, and not come out as designed: watch it, with STOP at hand.";
  return { sub: `Check found ${found}. Fix the problems in Check, or go on anyway.`, consequence };
}

/** How many bodies of the machine are only estimated: "5 of 6 bodies are estimates"; null where all are measured. */
export function estimatesOf({ bodies, estimates }: Pick<Collisions, "bodies" | "estimates">): string | null {
  if (bodies === 0) return "The machine's profile has no bodies: only the wire itself was looked at.";
  if (estimates === 0) return null;
  if (estimates < bodies) return `${estimates} of ${bodies} bodies of the machine are estimates.`;
  return bodies === 1
    ? "The machine's only body is an estimate."
    : `All ${bodies} bodies of the machine are estimates.`;
}

/** What was checked and is fine: only what the figures show to have been checked, of all wires. */
export function fineOf(check: LiveCheck): string[] {
  const { wires, diagnostics } = check;
  if (wires.length === 0) return [];
  const free = (...codes: DiagnosticCode[]) =>
    !diagnostics.some(({ code, severity }) => severity !== "info" && codes.includes(code));
  const routed = wires.every(({ length_mm }) => length_mm !== null);
  const fine: string[] = [];
  if (routed && free("no_euler_path", "route_refused")) {
    fine.push(wires.length === 1 ? "One wire runs through every edge" : `${wires.length} wires run through every edge`);
  }
  if (!isCompensated(check)) return fine;
  const bends = wires.reduce((sum, wire) => sum + (wire.bends ?? 0), 0);
  if (free("edges_meet")) fine.push("No wire through another");
  if (free("edge_too_short", "edge_near_limit", "arcs_overlap", "zero_length_edge")) fine.push("Edges long enough");
  if (free("feed_too_short", "feed_near_limit", "feed_too_long")) fine.push("Feeds within the machine's limits");
  if (
    free(
      "bend_too_sharp",
      "bend_near_limit",
      "bend_out_of_reach",
      "bend_too_small",
      "corner_too_near",
      "lead_too_short",
      "fold_back",
    )
  )
    fine.push(`${count(bends, "bend")} within reach`);
  if (free("rotation_out_of_range")) fine.push("Rotation within the head's limits");
  if (free("stock_too_long")) fine.push("Stock fits the machine");
  if (free("wire_does_not_fit")) fine.push("Wire fits the machine");
  return fine;
}
