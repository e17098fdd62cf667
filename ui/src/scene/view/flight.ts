/** The way of the eye from one view to another, so that a person sees how the design has turned. Pure. */

import type { Orbit } from "./orbit";

/** ms: long enough to be followed, too short to be waited for. */
const LASTS_MS = 260;

const TURN = 2 * Math.PI;

/** Slow at both ends. */
const eased = (share: number): number => share * share * (3 - 2 * share);

export interface Flight {
  readonly from: Orbit;
  readonly to: Orbit;
  /** As `performance.now` gives it. */
  readonly begun: number;
}

/** The view so many ms later, by the shorter way around; what is without perspective is so from its arrival on. */
export function flown({ from, to, begun }: Flight, now: number): { readonly orbit: Orbit; readonly arrived: boolean } {
  const share = Math.min(Math.max((now - begun) / LASTS_MS, 0), 1);
  if (share === 1) return { orbit: to, arrived: true };
  const by = eased(share);
  const around = to.yaw - from.yaw;
  const yaw = from.yaw + (around - TURN * Math.round(around / TURN)) * by;
  return { orbit: { ...from, yaw, pitch: from.pitch + (to.pitch - from.pitch) * by }, arrived: false };
}
