/** How far the parts of a step have come. */

import type { PlayedStep } from "./interface";

/** Each from 0 to 1. */
export interface Phase {
  readonly feed: number;
  readonly rotate: number;
  /** Of the wire: it stays bent. */
  readonly bend: number;
  /** Of the bend axis: it goes out and comes back. */
  readonly peg: number;
}

const BEFORE: Phase = { feed: 0, rotate: 0, bend: 0, peg: 0 };
const AFTER: Phase = { feed: 1, rotate: 1, bend: 1, peg: 0 };

/** `fraction` of the step's time: feed, then rotate, then bend (half of it out, half back), then waiting. */
export function phase(step: PlayedStep, fraction: number): Phase {
  if (fraction <= 0) return BEFORE;
  if (fraction >= 1) return AFTER;
  const moves = [step.feed !== 0, step.rotate !== 0, step.bend !== 0 || step.bendAxis !== 0];
  let seconds = step.seconds.map((time) => (time > 0 ? time : 0));
  // A machine that tells no times: each part takes as long.
  if (!seconds.some((time) => time > 0)) seconds = [...moves.map((moving) => (moving ? 1 : 0)), 0];
  let left = fraction * seconds.reduce((sum, time) => sum + time, 0);
  const parts = seconds.slice(0, 3).map((time) => {
    const done = time > 0 ? Math.min(left / time, 1) : left > 0 ? 1 : 0;
    left = Math.max(left - time, 0);
    return done;
  });
  const [feed = 0, rotate = 0, bending = 0] = parts;
  return { feed, rotate, bend: Math.min(bending * 2, 1), peg: 1 - Math.abs(bending * 2 - 1) };
}

/** Step and fraction within it; the last step at its end where the time is past it. Null without steps. */
export function stepAt(steps: number, time: number): { step: number; fraction: number } | null {
  if (steps === 0) return null;
  if (!(time > 0)) return { step: 0, fraction: 0 };
  if (time >= steps) return { step: steps - 1, fraction: 1 };
  return { step: Math.floor(time), fraction: time - Math.floor(time) };
}
