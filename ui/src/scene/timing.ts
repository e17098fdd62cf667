/** How far the parts of a step have come. */

import type { PlayedStep } from "./interface";

/** Each from 0 to 1. */
export interface Phase {
  readonly feed: number;
  readonly rotate: number;
  /** Of the wire: it stays bent. */
  readonly bend: number;
  /** Of the bend axis: it goes there and comes back. */
  readonly axis: number;
  /** Of the peg along its own axis: at 0 it is in, so that the wire can pass it, at 1 it is out and bends. */
  readonly out: number;
}

const BEFORE: Phase = { feed: 0, rotate: 0, bend: 0, axis: 0, out: 0 };
const AFTER: Phase = { feed: 1, rotate: 1, bend: 1, axis: 0, out: 0 };

/** What a machine waits for at a bend is its peg, which comes out and goes in: whether any of these steps does. */
export const waitsForPeg = (steps: readonly PlayedStep[]): boolean => steps.some(({ seconds }) => seconds[3] > 0);

/** `fraction` of the step's time: feed, rotate, the peg comes out, the bend axis goes there and back, the peg goes in. */
export function phase(step: PlayedStep, fraction: number): Phase {
  if (fraction <= 0) return BEFORE;
  if (fraction >= 1) return AFTER;
  const moves = [step.feed !== 0, step.rotate !== 0, step.bend !== 0 || step.bendAxis !== 0];
  let seconds = step.seconds.map((time) => (time > 0 ? time : 0));
  // A machine that tells no times: each part takes as long.
  if (!seconds.some((time) => time > 0)) seconds = [...moves.map((moving) => (moving ? 1 : 0)), 0];
  let left = fraction * seconds.reduce((sum, time) => sum + time, 0);
  const [feeding = 0, rotating = 0, bending = 0, waiting = 0] = seconds;
  const parts = [feeding, rotating, waiting / 2, bending, waiting / 2].map((time) => {
    const done = time > 0 ? Math.min(left / time, 1) : left > 0 ? 1 : 0;
    left = Math.max(left - time, 0);
    return done;
  });
  const [feed = 0, rotate = 0, comes = 0, bent = 0, goes = 0] = parts;
  return { feed, rotate, bend: Math.min(bent * 2, 1), axis: 1 - Math.abs(bent * 2 - 1), out: comes - goes };
}

/** Step and fraction within it; the last step at its end where the time is past it. Null without steps. */
export function stepAt(steps: number, time: number): { step: number; fraction: number } | null {
  if (steps === 0) return null;
  if (!(time > 0)) return { step: 0, fraction: 0 };
  if (time >= steps) return { step: steps - 1, fraction: 1 };
  return { step: Math.floor(time), fraction: time - Math.floor(time) };
}
