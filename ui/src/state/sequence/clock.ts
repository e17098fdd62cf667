/** Plays a sequence in the view: the clock runs only while it plays. */

import { shownSequence, useSequence } from "./sequence";

/** Seconds of a step; of many struts less, so that all of it plays within a minute. */
const STEP_S = 0.8;
const ALL_S = 60;
/** After a pause of the window it does not jump. */
const LONGEST_S = 0.25;

let waiting = 0;
let before: number | null = null;

/** How far it is after so many seconds. */
export function advanced(at: number, steps: number, seconds: number): number {
  return Math.min(at + seconds / Math.min(STEP_S, ALL_S / Math.max(steps, 1)), steps);
}

function frame(now: number): void {
  waiting = 0;
  const state = useSequence.getState();
  const steps = shownSequence(state)?.sequence.steps.length ?? 0;
  if (!state.playing || steps === 0) return;
  const passed = before === null ? 0 : Math.min((now - before) / 1000, LONGEST_S);
  before = now;
  const at = advanced(state.at, steps, passed);
  useSequence.setState({ at, playing: at < steps });
  if (at < steps) waiting = requestAnimationFrame(frame);
}

export function runSequence(): void {
  if (waiting !== 0) return;
  before = null;
  waiting = requestAnimationFrame(frame);
}

export function stopSequenceClock(): void {
  if (waiting !== 0) cancelAnimationFrame(waiting);
  waiting = 0;
}
