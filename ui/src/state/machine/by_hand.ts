/** The wire that is bent by jogging: drawn in the view as they run, as long as nothing else is shown there. */

import { create } from "zustand";
import { platform } from "../../platform";
import type { Played } from "../../scene/interface";
import { useDesign } from "../design/design";
import { playedDesign } from "../program/played";
import { showDesignAgain, usePlayback } from "../program/program";
import { diameterOf, needMachines, viewOf } from "./machines";
import type { Move, OperatorEvent, Phase } from "./operator";
import { order, useRun } from "./run";

interface ByHandStore {
  /** How many are done since the machine was homed or connected. */
  readonly moves: number;
  /** What the view shows of them, at its end; null where it shows something else. */
  readonly played: Played | null;
}

const NONE: ByHandStore = { moves: 0, played: null };

export const useByHand = create<ByHandStore>()(() => NONE);

/** mm, of a machine whose wire was not chosen. */
const SOME_DIAMETER = 2;

/** Of the design's wire, mm; it is the one that lies in the machine, as far as anybody knows. */
function diameter(): number {
  return diameterOf(useDesign.getState().state?.material) ?? SOME_DIAMETER;
}

/** Phases that begin with a wire of their own, or without any. */
const ANEW: ReadonlySet<Phase> = new Set(["connecting", "homing", "making", "closed"]);

/** Which of the moves that were ordered here is under way, by its number; null without one. */
let following: number | null = null;
let ordered = 0;
/** Changes when what was asked for is no longer wanted. */
let wanted = 0;
/** One question at a time: what is reported meanwhile asks once more. */
let asked = false;
let again = false;

/** Draws what was moved, instead of a program that is shown; the wire that a machine bends just now is left alone. */
async function draw(): Promise<void> {
  const machine = useRun.getState().state?.machine;
  if (machine === undefined || usePlayback.getState().live) return;
  again = asked;
  if (asked) return;
  asked = true;
  const before = wanted;
  needMachines();
  // Without the machine's picture there is nothing to draw it on; the figures in the section show it anyway.
  const answers = await Promise.all([viewOf(machine), platform.ask("by-hand", {})]).catch(() => null);
  asked = false;
  if (answers && before === wanted && !usePlayback.getState().live) {
    const [view, { moves, wire }] = answers;
    showDesignAgain();
    useByHand.setState({ moves, played: playedDesign(wire, view, diameter()) });
  }
  if (again) await draw();
}

/** Moves as a person has ordered it: drawn while it runs, as far as the machine reports where its axes are. */
export async function jogBy(moves: readonly Move[], record: boolean): Promise<void> {
  const before = following;
  ordered += 1;
  const mine = ordered;
  following = mine;
  // Refused, it goes nowhere; one that was under way goes on.
  if (!(await order({ order: "jog", moves: [...moves], record })) && following === mine) following = before;
}

/** The view shows the design again; the next move is drawn with those before it. */
export function hideByHand(): void {
  // What is left of a move that is under way is drawn with the next one.
  following = null;
  wanted += 1;
  again = false;
  if (useByHand.getState().played) useByHand.setState({ played: null });
}

function forget(): void {
  hideByHand();
  useByHand.setState(NONE);
}

export function hearByHand(event: OperatorEvent): void {
  if (event.event === "state") {
    if (ANEW.has(event.phase)) forget();
    // A refused or stopped move goes no farther.
    else if (event.phase !== "moving" && !event.busy) following = null;
    return;
  }
  if (event.event === "news" && event.news === "position" && following !== null) void draw();
  if (event.event !== "jogged") return;
  following = null;
  if (event.made.move === "home") forget();
  else void draw();
}
