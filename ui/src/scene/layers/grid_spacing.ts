/** How far apart the lines of the grid are, so that they are neither a fog nor missing. */

import type { LengthFormat } from "../interface";

export interface Spacing {
  /** mm. Every tenth line is stronger. */
  readonly mm: number;
  /** 0 to 1: how strong the fine lines are; at 0 they go, and the stronger ones become the fine ones. */
  readonly fine: number;
  /** How far apart the points are that clicks go to, mm; absent or 0 where they go to none. */
  readonly clicks?: number;
}

/** Fine lines are at least this far apart, CSS pixels. */
const NARROWEST = 9;

/** `pixel`: mm a CSS pixel where it is looked at. Powers of ten of the unit; of `snapped` mm where that is given, so that clicks go where lines are. */
export function gridSpacing(pixel: number, lengths: LengthFormat, snapped = 0): Spacing {
  const unit = snapped > 0 ? snapped : lengths.mm;
  const power = Math.ceil(Math.log10((NARROWEST * pixel) / unit) - 1e-9);
  const mm = unit * 10 ** Math.max(power, snapped > 0 ? 0 : -1);
  const apart = Math.log10(mm / pixel / NARROWEST);
  return { mm, fine: Math.min(Math.max(apart, 0), 1) };
}

/**
 * What is said of the grid: how far apart the points are that clicks go to, and below it what the lines stand for that can be seen, where that
 * is not the same; otherwise the latter alone.
 */
export function gridText({ mm, fine, clicks = 0 }: Spacing, lengths: LengthFormat): string {
  const seen = fine < 0.3 ? mm * 10 : mm;
  const text = (apart: number) => `${lengths.short(apart)} ${lengths.name}`;
  if (clicks <= 0 || text(clicks) === text(seen)) return `Grid ${text(seen)}`;
  return `Grid ${text(clicks)}\nLines ${text(seen)}`;
}
