/**
 * What happens without a person having asked for it just now. Nothing of it begins before `start`: importing a module does nothing, so
 * that a test has only those effects that it starts.
 */

import { begin } from "../state/files/beginning";
import { followSheet } from "./calibration";
import { type End, together } from "./changes";
import { followDesign } from "./design";
import { listenToSystem } from "./files";
import { followFrame } from "./frame";
import { listenToKeys } from "./keyboard";
import { followMachine, followPlayback } from "./machine";
import { listenToRightClicks } from "./right_click";
import { followSequence } from "./sequence";
import { followWindow } from "./window";

/** Starts all of them; the function that is returned ends them. */
export function start(): End {
  return together([
    followWindow(),
    followDesign(),
    followPlayback(),
    followMachine(),
    followFrame(),
    followSequence(),
    followSheet(),
    listenToKeys(),
    listenToRightClicks(),
    listenToSystem(),
  ]);
}

/** Brings the window to life: the effects, and then what is open and what the window was started with. */
export function open(): End {
  const end = start();
  begin();
  return end;
}
