/** Plays the program in the view: the clock runs only while it plays. */

import { create } from "zustand";
import { store, stored } from "../window/ui";
import { advance, type Speeds, stepBack, stepForward, USUAL_SPEEDS } from "./clock";
import { stopBetween } from "./contacts";
import { goTo, pause, show, usePlayback } from "./program";

const KEY = "wirebend.speeds";

/** The least and the most that a person can ask for. */
export const SPEED = { least: 0.1, most: 100 } as const;

/** What was kept, as far as it makes sense. */
export function keptSpeeds(text: string | null): Speeds {
  let read: Partial<Record<keyof Speeds, unknown>> = {};
  try {
    const parsed: unknown = JSON.parse(text ?? "{}");
    if (typeof parsed === "object" && parsed !== null) read = parsed;
  } catch {
    // As if nothing were kept.
  }
  const speed = (key: keyof Speeds): number => {
    const value = read[key];
    return typeof value === "number" && value >= SPEED.least && value <= SPEED.most ? value : USUAL_SPEEDS[key];
  };
  return { feed: speed("feed"), rotate: speed("rotate"), bend: speed("bend"), all: speed("all") };
}

export const useSpeeds = create<Speeds>()(() => keptSpeeds(stored(KEY)));

export function setSpeed(key: keyof Speeds, value: number): void {
  useSpeeds.setState({ [key]: Math.min(Math.max(value, SPEED.least), SPEED.most) });
  store(KEY, JSON.stringify(useSpeeds.getState()));
}

/** Seconds between two pictures at most: after a pause of the window the wire does not jump. */
const LONGEST_S = 0.25;

let before: number | null = null;
/** The picture that is waited for; 0 where none is. */
let waiting = 0;

function frame(now: number): void {
  waiting = 0;
  const { played, step, playing } = usePlayback.getState();
  if (!playing || !played) {
    before = null;
    return;
  }
  const passed = before === null ? 0 : Math.min((now - before) / 1000, LONGEST_S);
  before = now;
  const seconds = played.steps.map((one) => one.seconds);
  const next = advance(seconds, step, passed, useSpeeds.getState());
  const stop = stopBetween(step, next);
  if (stop !== null) {
    usePlayback.setState({ step: stop, playing: false });
    before = null;
    return;
  }
  if (next >= seconds.length) {
    usePlayback.setState({ step: seconds.length, playing: false });
    before = null;
    return;
  }
  usePlayback.setState({ step: next });
  waiting = requestAnimationFrame(frame);
}

/** Plays a picture at a time, until the program is over or playing is. */
export function runClock(): void {
  if (before === null) waiting = requestAnimationFrame(frame);
}

/** Plays no further, whatever is shown as playing. */
export function stopClock(): void {
  cancelAnimationFrame(waiting);
  waiting = 0;
  before = null;
}

const length = (): number => usePlayback.getState().played?.steps.length ?? 0;

export function forward(): void {
  const { played, step } = usePlayback.getState();
  void (played ? goTo(stepForward(length(), step)) : goTo(1));
}

export function back(): void {
  void goTo(stepBack(usePlayback.getState().step));
}

export function reset(): void {
  void goTo(0);
}

/** To a moment of the program, such as where the wire hits something. */
export function jump(position: number): void {
  void goTo(position);
}

/** While a person slides: nothing is asked for, and playing pauses. */
export function scrub(step: number): void {
  if (usePlayback.getState().live) return;
  pause();
  if (usePlayback.getState().played) show(step);
  else void goTo(step);
}
