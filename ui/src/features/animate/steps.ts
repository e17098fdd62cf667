/** The steps of a wire as a table, and what is said of them. */

import type { DiagnosticReport, MadeResponse, PlayedWire } from "../../generated/responses";
import {
  angle,
  count,
  type DisplayUnit,
  deviation,
  lengthNumber,
  number,
  speed,
  time,
} from "../../shared/figures/format";
import { isCollision } from "../../state/design/findings";
import type { Speeds } from "../../state/program/clock";

type Motion = PlayedWire["steps"][number]["designed"];

export interface StepRow {
  /** From 1, as the machine counts. */
  readonly number: number;
  /** Feed, rotate, bend; in the units that the head of the table names. */
  readonly designed: readonly [string, string, string];
  /** Null where the wire is not compensated. */
  readonly told: readonly [string, string, string] | null;
  readonly vertex: number | null;
  /** Numbers of the edges along which it feeds: as many as the column has room for, and all. */
  readonly edges: { readonly short: string; readonly all: string };
}

/** "12", "12, 13", "12 +4"; a dash where it feeds along no edge of the design. */
function edgeNumbers(edges: readonly number[]): StepRow["edges"] {
  const all = edges.join(", ");
  const [first] = edges;
  if (first === undefined) return { short: "–", all };
  return { short: edges.length > 2 ? `${first} +${edges.length - 1}` : all, all };
}

/** A zero has no sign, and an angle that nothing turns by is a dash. */
function motion({ feed_mm, rotate_deg, bend_deg, approach_deg }: Motion, unit: DisplayUnit): StepRow["designed"] {
  const turn = (deg: number) => (Math.abs(deg) < 0.05 ? "–" : number(deg));
  // The axis stops before zero: its sign is not the side of the bend, which is that away from where the peg comes out.
  const bend = approach_deg ? `${number(approach_deg)} to ${number(bend_deg)}` : turn(bend_deg);
  return [lengthNumber(feed_mm, unit), turn(rotate_deg), bend];
}

export function stepRow(wire: PlayedWire, index: number, unit: DisplayUnit): StepRow | null {
  const step = wire.steps[index];
  if (!step) return null;
  return {
    number: index + 1,
    designed: motion(step.designed, unit),
    told: step.told ? motion(step.told, unit) : null,
    vertex: step.vertex,
    edges: edgeNumbers(step.edges),
  };
}

/** What a step does, in words, for those who do not see it. */
export function spoken(wire: PlayedWire, index: number, shown: (mm: number) => string): string {
  const step = wire.steps[index];
  if (!step) return "";
  const { feed_mm, rotate_deg, bend_deg } = step.designed;
  const along =
    step.edges.length === 0 ? "" : ` along ${step.edges.length === 1 ? "edge" : "edges"} ${step.edges.join(", ")}`;
  const parts = [`feed ${shown(feed_mm)}${along}`];
  if (Math.abs(rotate_deg) >= 0.05) parts.push(`rotate ${angle(rotate_deg)}`);
  if (Math.abs(bend_deg) >= 0.05) parts.push(`bend ${angle(bend_deg)}`);
  const pause = step.pause === null ? "" : `; then pause: ${step.pause}`;
  return `step ${index + 1} of ${wire.steps.length}: ${parts.join(", ")}${pause}`;
}

/** Steps that a diagnostic names, collisions aside, each once, ascending. Only for a design of one wire is it known whose steps they are. */
export function namedSteps(diagnostics: readonly DiagnosticReport[], wires: number): readonly number[] {
  if (wires !== 1) return [];
  const steps = diagnostics.flatMap(({ code, step, severity }) =>
    severity === "error" && typeof step === "number" && !isCollision(code) ? [step] : [],
  );
  return [...new Set(steps)].toSorted((a, b) => a - b);
}

/** "worst vertex 0.08 mm"; null before it is known. In inches two more digits than elsewhere: it is small. */
export function worst(made: MadeResponse | null, wire: number, unit: DisplayUnit): string | null {
  const mm = made?.wires[wire]?.worst_mm;
  if (mm === undefined) return null;
  return `worst vertex ${deviation(mm, unit)}`;
}

/** The header of the section: time of all wires, or what there is instead. */
export function phrase(wires: readonly { readonly time_s: number | null }[], without: number): string {
  if (wires.length === 0) return without > 0 ? "no program: see Check" : "no steps";
  const known = wires.every(({ time_s }) => time_s !== null);
  const seconds = wires.reduce((all, { time_s }) => all + (time_s ?? 0), 0);
  const parts = wires.length > 1 ? [count(wires.length, "wire")] : [];
  if (known) parts.push(time(seconds));
  if (without > 0) parts.push(`${without} without a program`);
  return parts.join(" · ");
}

/** How fast each axis goes in the view: the machine's speeds (feed in mm/s, the others in degrees/s) times what they are multiplied by. Nothing is known where `rates` is null. */
export function shownSpeeds(
  rates: readonly [number, number, number] | null,
  speeds: Speeds,
  unit: DisplayUnit,
): Readonly<Partial<Record<keyof Speeds, string>>> {
  if (!rates) return {};
  const [feed, rotate, bend] = rates;
  return {
    feed: speed(feed * speeds.feed * speeds.all, unit),
    rotate: `${angle(rotate * speeds.rotate * speeds.all)}/s`,
    bend: `${angle(bend * speeds.bend * speeds.all)}/s`,
  };
}
