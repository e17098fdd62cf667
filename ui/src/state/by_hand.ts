/** The wire that moves by hand make: drawn in the view as they are made, as long as nothing else is shown there. */

import { create } from "zustand";
import type { MachineViewResponse } from "../generated/responses";
import type { Played, PlayedStep, Vec3 } from "../scene/interface";
import { useDesign } from "./design";
import { needMachines, useMachines, viewOf } from "./machines";
import { type Move, operatorEvent, type OperatorEvent, type Phase } from "./operator";
import { bodyOf } from "./played";
import { showDesignAgain, usePlayback } from "./program";
import { useRun } from "./run";
import { hear } from "./work";

interface ByHandStore {
  /** Since the machine was homed or connected, in the order in which they were made. */
  readonly moves: readonly Move[];
  /** What the view shows of them; null where it shows something else. */
  readonly played: Played | null;
}

export const useByHand = create<ByHandStore>()(() => ({ moves: [], played: null }));

/** Feed in mm, rotation and bend in degrees, in canonical signs, as of a step of a program. */
type HandStep = Readonly<Record<"feed" | "rotate" | "bend", number>>;

/** mm that stand for no feed at all: two bends at one place have their directions by it, and nobody sees it. */
const HAIR = 1e-3;
/** mm, of a machine whose wire nobody has chosen. */
const SOME_DIAMETER = 2;
const RADIANS = Math.PI / 180;

/**
 * The moves as steps of a program: a bend ends one. Feeding and rotating do not disturb each other, so that between two bends only
 * their sums count. What is drawn back behind a bend is not drawn: the machine cannot do it to the wire either.
 */
export function stepsOf(moves: readonly Move[]): HandStep[] {
  const steps: HandStep[] = [];
  let [feed, rotate] = [0, 0];
  const end = (bend: number) => {
    steps.push({ feed: Math.max(feed, HAIR), rotate, bend });
    [feed, rotate] = [0, 0];
  };
  for (const move of moves) {
    if (move.move === "feed") feed += move.mm;
    else if (move.move === "rotate") rotate += move.deg;
    else if (move.move === "bend" && move.deg !== 0) end(move.deg);
  }
  end(0);
  return steps;
}

/** Where the wire begins, and where it is after each step, mm: the turtle of the program, which begins at the origin along x, its bend axis z. */
export function cornersOf(steps: readonly HandStep[]): Vec3[] {
  let at: Vec3 = [0, 0, 0];
  let [t, n, b]: [Vec3, Vec3, Vec3] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  /** `u` turned towards `v`, both of length 1 and at right angles. */
  const turned = (u: Vec3, v: Vec3, deg: number): Vec3 => {
    const [c, s] = [Math.cos(deg * RADIANS), Math.sin(deg * RADIANS)];
    return [u[0] * c + v[0] * s, u[1] * c + v[1] * s, u[2] * c + v[2] * s];
  };
  const corners: Vec3[] = [at];
  for (const { feed, rotate, bend } of steps) {
    at = [at[0] + t[0] * feed, at[1] + t[1] * feed, at[2] + t[2] * feed];
    corners.push(at);
    [n, b] = [turned(n, b, rotate), turned(b, n, -rotate)];
    [t, n] = [turned(t, n, bend), turned(n, t, -bend)];
  }
  return corners;
}

/** The wire of moves by hand on its machine, as it is designed: without springback, which only the wire itself knows. */
export function playedByHand(moves: readonly Move[], machine: MachineViewResponse, diameter: number): Played {
  const steps = stepsOf(moves);
  return {
    // A bend by hand is a whole one: the peg is in again at its end.
    steps: steps.map((step): PlayedStep => ({ ...step, bendAxis: step.bend, seconds: [0, 0, 0, 1] })),
    path: cornersOf(steps),
    made: null,
    bodies: machine.shapes.map(bodyOf),
    wireDiameter: diameter,
    orbitOffset: machine.pivot_mm[0],
  };
}

/** Of the design's wire, mm; it is the one that lies in the machine, as far as anybody knows. */
function diameter(): number {
  const chosen = useDesign.getState().state?.material;
  return useMachines.getState().materials?.find(({ id }) => id === chosen)?.diameter_mm ?? SOME_DIAMETER;
}

/** Phases that begin with a wire of their own, or without any. */
const ANEW: ReadonlySet<Phase> = new Set(["connecting", "homing", "making", "closed"]);

/** Draws what was moved, instead of a program that is shown; the wire that a machine makes just now is left alone. */
async function draw(): Promise<void> {
  const { moves } = useByHand.getState();
  const machine = useRun.getState().state?.machine;
  if (machine === undefined || usePlayback.getState().live) return;
  needMachines();
  // Without the machine's picture there is nothing to draw it on; the figures in the section tell all the same.
  const view = await viewOf(machine).catch(() => null);
  // Another move was made meanwhile, or they were forgotten: that is drawn then.
  if (!view || useByHand.getState().moves !== moves) return;
  showDesignAgain();
  useByHand.setState({ played: playedByHand(moves, view, diameter()) });
}

/** The view shows the design again; the next move is drawn with those before it. */
export function hideByHand(): void {
  if (useByHand.getState().played) useByHand.setState({ played: null });
}

function forget(): void {
  useByHand.setState({ moves: [], played: null });
}

export function hearByHand(event: OperatorEvent): void {
  if (event.event === "state" && ANEW.has(event.phase)) return forget();
  if (event.event !== "jogged") return;
  if (event.made.move === "home") return forget();
  useByHand.setState(({ moves }) => ({ moves: [...moves, event.made] }));
  void draw();
}

hear((heard) => {
  const event = operatorEvent(heard);
  if (event) hearByHand(event);
});

// Only one thing is shown: a program that is played, or a design that is changed, takes its place.
usePlayback.subscribe(({ played }) => {
  if (played) hideByHand();
});
useDesign.subscribe(({ vertices, edges }, before) => {
  if (vertices !== before.vertices || edges !== before.edges) hideByHand();
});
