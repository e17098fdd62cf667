import type { FrameShown, LoadCaseEntry } from "../../generated/responses";
import { count, type DisplayUnit, length, number, percent, short, unitSize } from "../../shared/figures/format";
import type { Coloured, FrameView } from "../../state/frame/shape";

/** What is less moves nothing that could be measured; in the unit that is shown. */
const LEAST = 0.0001;

/** A number of the unit, with three digits, and no more than four behind the point. */
export function displacementNumber(mm: number, unit: DisplayUnit): string {
  const shown = mm / unitSize(unit);
  if (shown !== 0 && Math.abs(shown) < LEAST) return `< ${LEAST}`;
  const rounded = Number(shown.toPrecision(3));
  return short(Number(rounded.toFixed(4)));
}

/** How far something moves. */
export const displacement = (mm: number, unit: DisplayUnit): string =>
  `${displacementNumber(mm, unit)} ${unit === "inch" ? "in" : "mm"}`;

/** How exactly something is made: three digits, however small it is. */
export const exactness = (mm: number, unit: DisplayUnit): string =>
  `${short(mm / unitSize(unit), 3)} ${unit === "inch" ? "in" : "mm"}`;

export const force = (newton: number): string => `${short(newton, 3)} N`;
export const stress = (mpa: number): string => `${short(mpa, 3)} MPa`;
export const utilisation = (share: number): string => percent(share, share < 0.1 ? 1 : 0);
export const frequency = (hz: number): string => `${number(hz, hz < 1000 ? 1 : 0)} Hz`;
export const mass = (grams: number): string =>
  grams < 1000 ? `${number(grams, grams < 100 ? 1 : 0)} g` : `${number(grams / 1000, 2)} kg`;

/** By how much displacements are enlarged. */
export const enlarged = (scale: number): string =>
  Math.abs(scale - 1) < 1e-9 ? "true scale" : `${short(scale, 2)} × ${scale < 1 ? "true scale" : "enlarged"}`;

export const COLOURED: Readonly<Record<Coloured, string>> = {
  displacement: "Displacement",
  utilisation: "Utilisation",
  axial: "Axial force",
};

export function viewName(view: FrameView, shown: FrameShown): string {
  switch (view.kind) {
    case "loaded":
      return "Under load";
    case "mode":
      return `Mode ${view.mode + 1}, ${frequency(shown.result.modes[view.mode]?.frequency_hz ?? 0)}`;
    case "made":
      return "As made";
    case "closed":
      return "As closed";
  }
}

/** The ends of a legend. */
export function endsOf(coloured: Coloured, most: number, unit: DisplayUnit): readonly [string, string, string] {
  switch (coloured) {
    case "displacement":
      return ["0", "", displacement(most, unit)];
    case "utilisation":
      return ["0", "", utilisation(most)];
    case "axial":
      return [force(-most), "0", force(most)];
  }
}

const AXIS_NAMES = ["x", "y", "z"] as const;

/** Where a force pulls: the parts that there are. */
export const forceParts = (parts: readonly number[]): string =>
  parts.flatMap((part, axis) => (part === 0 ? [] : [`${AXIS_NAMES[axis]} ${force(part)}`])).join(", ");

/** What a load case has. */
export function caseSays({ forces, moments, along_edges, gravity }: LoadCaseEntry): string {
  const parts = [
    forces.length > 0 ? count(forces.length, "force") : null,
    moments > 0 ? count(moments, "moment") : null,
    along_edges > 0 ? `${count(along_edges, "load")} along edges` : null,
  ].filter(Boolean);
  const weight = gravity
    ? "Its gravity is its own."
    : "It says nothing of gravity: without another choice nothing weighs.";
  return `${parts.length > 0 ? parts.join(", ") : "Nothing but gravity"}. ${weight}`;
}

/** Why a frame does not hold, in a word or two: the worst of what is found foremost. */
function failureOf({ holds, diagnostics, frame }: FrameShown["result"]): string | null {
  const worst = diagnostics.find(({ severity }) => severity === "error");
  if (holds || !worst) return null;
  switch (worst.code) {
    case "frame_unsupported":
      return frame.supports === 0 ? "floats" : "partly floats";
    case "frame_mechanism":
      return "does not stand";
    case "frame_too_soft":
      return "hardly stands";
    case "strut_overstressed":
      return "yields";
    case "strut_near_buckling":
      return "buckles";
    case "edges_meet":
      return "struts meet";
    default:
      return "does not hold";
  }
}

/** What the header of the section says. */
export function phraseOf({ result }: FrameShown, unit: DisplayUnit): string {
  const bends = result.modes.find(({ kind }) => kind !== "rigid");
  const parts = [
    failureOf(result),
    result.static ? `moves ${displacement(result.static.max_displacement_mm, unit)}` : null,
    bends ? frequency(bends.frequency_hz) : null,
  ];
  return parts.filter(Boolean).join(" · ") || length(result.frame.length_mm, unit);
}
