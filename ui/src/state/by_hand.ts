/** The wire that moves by hand make: drawn in the view as they are made, as long as nothing else is shown there. */

import { create } from "zustand";
import type { MachineViewResponse } from "../generated/responses";
import type { Played, PlayedStep, Vec3 } from "../scene/interface";
import { useDesign } from "./design";
import { needMachines, useMachines, viewOf } from "./machines";
import { type Axes, type Move, operatorEvent, type OperatorEvent, type Phase } from "./operator";
import { bodyOf } from "./played";
import { showDesignAgain, usePlayback } from "./program";
import { useRun } from "./run";
import { hear } from "./work";

interface ByHandStore {
  /** Since the machine was homed or connected, in the order in which they were made. */
  readonly moves: readonly Move[];
  /** What the view shows of them; null where it shows something else. */
  readonly played: Played | null;
  /** The step of `played` that is shown, with its fraction. */
  readonly step: number;
}

export const useByHand = create<ByHandStore>()(() => ({ moves: [], played: null, step: 0 }));

/** A move that was ordered and is under way. */
interface Underway {
  readonly move: Move;
  /** Where the axes were before. */
  readonly from: Axes;
  /** The largest part of a bend that was made: the wire stays bent when its axis goes back. */
  readonly bent: number;
}

let underway: Underway | null = null;
/** Where the last move has ended: places are told more seldom than moves are ordered. */
let ended: Axes | null = null;

function endOf({ move, from }: Underway): Axes {
  switch (move.move) {
    case "feed":
      return { ...from, feed_mm: from.feed_mm + move.mm };
    case "rotate":
      return { ...from, rotate_deg: from.rotate_deg + move.deg };
    // Its axis goes back to where it was.
    case "bend":
    case "home":
      return from;
  }
}

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

/** Of each machine the same ones: it is not built anew for each of its moves. */
const bodies = new WeakMap<MachineViewResponse, Played["bodies"]>();

function bodiesOf(machine: MachineViewResponse): Played["bodies"] {
  const known = bodies.get(machine) ?? machine.shapes.map(bodyOf);
  bodies.set(machine, known);
  return known;
}

/** The wire of moves by hand on its machine, as it is designed: without springback, which only the wire itself knows. */
export function playedByHand(moves: readonly Move[], machine: MachineViewResponse, diameter: number): Played {
  const steps = stepsOf(moves);
  return {
    // A bend by hand is a whole one: the peg is in again at its end.
    steps: steps.map((step): PlayedStep => ({ ...step, bendAxis: step.bend, seconds: [0, 0, 0, 1] })),
    path: cornersOf(steps),
    made: null,
    bodies: bodiesOf(machine),
    wireDiameter: diameter,
    orbitOffset: machine.pivot_mm[0],
  };
}

/** What is made of a move when the axes are somewhere on its way, and where the bend axis is, degrees. */
export function partMade({ move, from, bent }: Underway, now: Axes): { readonly made: Move; readonly axis: number } {
  switch (move.move) {
    case "home":
      return { made: move, axis: 0 };
    case "feed":
      return { made: { move: "feed", mm: now.feed_mm - from.feed_mm }, axis: 0 };
    case "rotate":
      return { made: { move: "rotate", deg: now.rotate_deg - from.rotate_deg }, axis: 0 };
    case "bend": {
      // Its peg may come from the other side first.
      const axis = move.deg === 0 ? 0 : Math.min(Math.max((now.bend_deg - from.bend_deg) / move.deg, 0), 1);
      return { made: { move: "bend", deg: move.deg * Math.max(axis, bent) }, axis: move.deg * axis };
    }
  }
}

/** The same while a bend is under way: its axis is at `axis`, and nothing of what comes after it is shown. */
function inBend(played: Played, axis: number): { readonly played: Played; readonly step: number } {
  const bending = played.steps.length - 2;
  const steps = played.steps.map((step, index): PlayedStep => (index === bending ? { ...step, bendAxis: axis, seconds: [0, 0, 1, 0] } : step));
  return { played: { ...played, steps }, step: bending + 0.5 };
}

/** Of the design's wire, mm; it is the one that lies in the machine, as far as anybody knows. */
function diameter(): number {
  const chosen = useDesign.getState().state?.material;
  return useMachines.getState().materials?.find(({ id }) => id === chosen)?.diameter_mm ?? SOME_DIAMETER;
}

/** Phases that begin with a wire of their own, or without any. */
const ANEW: ReadonlySet<Phase> = new Set(["connecting", "homing", "making", "closed"]);

/** Draws what was moved, instead of a program that is shown; the wire that a machine makes just now is left alone. */
async function draw(now: Axes | null = null): Promise<void> {
  const { moves } = useByHand.getState();
  const part = now && underway && partMade(underway, now);
  const machine = useRun.getState().state?.machine;
  if (machine === undefined || usePlayback.getState().live) return;
  needMachines();
  // Without the machine's picture there is nothing to draw it on; the figures in the section tell all the same.
  const view = await viewOf(machine).catch(() => null);
  // Another move was made meanwhile, or they were forgotten: that is drawn then.
  if (!view || useByHand.getState().moves !== moves) return;
  showDesignAgain();
  const all = part ? [...moves, part.made] : moves;
  const played = playedByHand(all, view, diameter());
  const bends = part?.made.move === "bend" && part.made.deg !== 0;
  useByHand.setState(bends ? inBend(played, part.axis) : { played, step: played.steps.length });
}

/** A person has ordered a move: it is drawn while it is made, as far as the machine tells where its axes are. */
export function beginMove(move: Move): void {
  const from = ended ?? useRun.getState().state?.position;
  underway = from ? { move, from, bent: 0 } : null;
}

/** It was refused. */
export function cancelMove(): void {
  underway = null;
}

function follow(now: Axes): void {
  if (!underway) return;
  const { made } = partMade(underway, now);
  if (made.move === "bend" && underway.move.move === "bend") underway = { ...underway, bent: made.deg / (underway.move.deg || 1) };
  void draw(now);
}

/** The view shows the design again; the next move is drawn with those before it. */
export function hideByHand(): void {
  // What is left of a move that is under way is drawn with the next one.
  underway = null;
  if (useByHand.getState().played) useByHand.setState({ played: null });
}

function forget(): void {
  underway = null;
  ended = null;
  useByHand.setState({ moves: [], played: null, step: 0 });
}

export function hearByHand(event: OperatorEvent): void {
  if (event.event === "state") {
    if (ANEW.has(event.phase)) forget();
    // A refused or stopped move goes no farther.
    else if (event.phase !== "moving" && !event.busy) [underway, ended] = [null, underway ? null : ended];
    return;
  }
  if (event.event === "news" && event.news === "position") return follow(event);
  if (event.event !== "jogged") return;
  ended = underway && endOf(underway);
  underway = null;
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
