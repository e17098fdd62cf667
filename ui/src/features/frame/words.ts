import type { FrameShown } from "../../generated/responses";
import { type DisplayUnit, length, number, percent, short } from "../../shared/figures/format";
import type { Coloured, FrameView } from "../../state/frame/shape";

/** What is less moves nothing that could be measured; in the unit that is shown. */
const LEAST = 0.0001;

/** A number of the unit, with three digits, and no more than four behind the point. */
export function displacementNumber(mm: number, unit: DisplayUnit): string {
  const shown = unit === "inch" ? mm / 25.4 : mm;
  if (shown !== 0 && Math.abs(shown) < LEAST) return `< ${LEAST}`;
  const rounded = Number(shown.toPrecision(3));
  return short(Number(rounded.toFixed(4)));
}

/** How far something moves. */
export const displacement = (mm: number, unit: DisplayUnit): string =>
  `${displacementNumber(mm, unit)} ${unit === "inch" ? "in" : "mm"}`;

/** How exactly something is made: three digits, however small it is. */
export const exactness = (mm: number, unit: DisplayUnit): string =>
  `${short(unit === "inch" ? mm / 25.4 : mm, 3)} ${unit === "inch" ? "in" : "mm"}`;

export const force = (newton: number): string => `${short(newton, 3)} N`;
export const stress = (mpa: number): string => `${short(mpa, 3)} MPa`;
export const utilisation = (share: number): string => percent(share, share < 0.1 ? 1 : 0);
export const frequency = (hz: number): string => `${number(hz, hz < 1000 ? 1 : 0)} Hz`;
export const mass = (grams: number): string =>
  grams < 1000 ? `${number(grams, grams < 100 ? 1 : 0)} g` : `${number(grams / 1000, 2)} kg`;

/** By how much displacements are enlarged. */
export const enlarged = (scale: number): string =>
  Math.abs(scale - 1) < 1e-9 ? "true scale" : `${short(scale, 2)} × enlarged`;

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

/** What the header of the section says. */
export function phraseOf({ result }: FrameShown, unit: DisplayUnit): string {
  const bends = result.modes.find(({ kind }) => kind !== "rigid");
  const parts = [
    result.static ? `moves ${displacement(result.static.max_displacement_mm, unit)}` : null,
    bends ? frequency(bends.frequency_hz) : null,
  ];
  return parts.filter(Boolean).join(" · ") || (result.holds ? length(result.frame.length_mm, unit) : "does not stand");
}
