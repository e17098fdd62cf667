/**
 * Where a program is while it is played. A position is a step and a fraction of the time that the machine takes for it,
 * from 0 to the number of steps: the same that the scene takes.
 */

/** Seconds that the machine takes for feed, rotate, the bend axis there and back, and waiting. */
export type StepSeconds = readonly [number, number, number, number];

/** How many seconds of the machine pass in one second of the screen. */
export interface Speeds {
  readonly feed: number;
  readonly rotate: number;
  /** Also of the waiting, which belongs to bends: the peg comes out and goes in. */
  readonly bend: number;
  /** On top of the three. */
  readonly all: number;
}

/** A bend takes most of the time and shows the least. */
export const USUAL_SPEEDS: Speeds = { feed: 1, rotate: 1, bend: 4, all: 1 };

const sum = (seconds: StepSeconds): number => seconds.reduce((all, part) => all + part, 0);

/** Time and rate of the parts. A step without any time is shown for a second: otherwise it could not be seen. */
function parts(seconds: StepSeconds, speeds: Speeds): { seconds: number; rate: number }[] {
  const given = seconds.map((part) => Math.max(part, 0));
  const [feed = 0, rotate = 0, bend = 0, wait = 0] = given;
  const shown = given.some((part) => part > 0) ? wait : speeds.bend;
  const rates = [speeds.feed, speeds.rotate, speeds.bend, speeds.bend].map((rate) => rate * speeds.all);
  return [feed, rotate, bend, shown].map((part, k) => ({ seconds: part, rate: Math.max(rates[k] ?? 1, 1e-6) }));
}

/** The position after so many seconds on the screen. */
export function advance(steps: readonly StepSeconds[], position: number, seconds: number, speeds: Speeds): number {
  let at = Math.max(Math.floor(position), 0);
  let fraction = Math.max(position - at, 0);
  let left = Math.max(seconds, 0);
  for (; at < steps.length; at += 1, fraction = 0) {
    const all = parts(steps[at] ?? [0, 0, 0, 0], speeds);
    const total = all.reduce((whole, part) => whole + part.seconds, 0);
    const begun = fraction * total;
    let end = 0;
    for (const part of all) {
      end += part.seconds;
      const from = Math.max(begun, end - part.seconds);
      const takes = Math.max(end - from, 0) / part.rate;
      if (left < takes) return at + Math.min((from + left * part.rate) / total, 1);
      left -= takes;
    }
  }
  return steps.length;
}

/** Seconds on the screen from one position to the end. */
export function screenSeconds(steps: readonly StepSeconds[], position: number, speeds: Speeds): number {
  let seconds = 0;
  for (let at = Math.max(Math.floor(position), 0); at < steps.length; at += 1) {
    const all = parts(steps[at] ?? [0, 0, 0, 0], speeds);
    const total = all.reduce((whole, part) => whole + part.seconds, 0);
    const begun = Math.max(position - at, 0) * total;
    let end = 0;
    for (const part of all) {
      end += part.seconds;
      seconds += Math.max(end - Math.max(begun, end - part.seconds), 0) / part.rate;
    }
  }
  return seconds;
}

/** Seconds that the machine has worked at a position. */
export function machineSeconds(steps: readonly StepSeconds[], position: number): number {
  const at = Math.min(Math.max(Math.floor(position), 0), steps.length);
  const before = steps.slice(0, at).reduce((all, step) => all + sum(step), 0);
  const here = steps[at];
  return before + (here ? sum(here) * Math.max(position - at, 0) : 0);
}

/** The step that is under way at a position, from 0; at the end the last. -1 without steps. */
export function stepOf(steps: number, position: number): number {
  return Math.min(Math.max(Math.floor(position), 0), steps - 1);
}

/** Where a step forward leads: to the end of the one that is under way. */
export const stepForward = (steps: number, position: number): number =>
  Math.min(Math.floor(position + 1e-9) + 1, steps);

/** Where a step back leads: to the beginning of the one that is under way, or of the one before. */
export const stepBack = (position: number): number => Math.max(Math.ceil(position - 1e-9) - 1, 0);
