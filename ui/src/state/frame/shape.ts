/** What the view shows of a frame: which of its shapes, in which colours, enlarged by how much, and whether it swings. */

import { create } from "zustand";
import { hideByHand } from "../machine/by_hand";
import { showDesignAgain, usePlayback } from "../program/program";

/** One of the shapes of a frame. */
export type FrameView =
  /** under what acts on it; */
  | { readonly kind: "loaded" }
  /** as it vibrates, by the place of the mode; */
  | { readonly kind: "mode"; readonly mode: number }
  /** its wires as the machine bends them; */
  | { readonly kind: "made" }
  /** the same once their joints are closed. */
  | { readonly kind: "closed" };

export type Coloured = "displacement" | "utilisation" | "axial";

interface ShapeStore {
  /** Null: the view shows the design. */
  readonly view: FrameView | null;
  readonly coloured: Coloured;
  /** By how much the displacements are enlarged; null: so much that they are well seen. */
  readonly scale: number | null;
  /** A mode swings. */
  readonly swinging: boolean;
  /** Where it is in its swing, −1 to 1. */
  readonly swing: number;
}

export const useShape = create<ShapeStore>()(() => ({
  view: null,
  coloured: "displacement",
  scale: null,
  swinging: false,
  swing: 1,
}));

/** What else the view may show gives way; null shows the design again. */
export function showFrame(view: FrameView | null): void {
  // A machine that bends a wire is seen.
  if (view && usePlayback.getState().live) return;
  const before = useShape.getState().view;
  if (view) {
    showDesignAgain();
    hideByHand();
  }
  const same = before?.kind === view?.kind;
  useShape.setState((shape) => ({ view, swinging: false, swing: 1, scale: same ? shape.scale : null }));
}

export function colourBy(coloured: Coloured): void {
  useShape.setState({ coloured });
}

export function enlarge(scale: number): void {
  useShape.setState({ scale });
}

export function toggleSwing(): void {
  useShape.setState(({ swinging, view }) => ({ swinging: !swinging && view?.kind === "mode", swing: 1 }));
}

/** Seconds from one end of a swing to the other and back: modes are too fast to be seen as they are. */
const SWING_S = 1.6;

/** From −1 to 1 and back, gently at the ends; `part` of a whole swing. */
export function swingAt(part: number): number {
  const within = part - Math.floor(part);
  const half = within < 0.5 ? within * 2 : 2 - within * 2;
  return 1 - 2 * half * half * (3 - 2 * half);
}

let waiting = 0;
let begun: number | null = null;

function frame(now: number): void {
  waiting = 0;
  if (!useShape.getState().swinging) return;
  begun ??= now;
  useShape.setState({ swing: swingAt((now - begun) / 1000 / SWING_S) });
  waiting = requestAnimationFrame(frame);
}

/** Runs while a mode swings. */
export function runSwing(): void {
  if (waiting !== 0) return;
  begun = null;
  waiting = requestAnimationFrame(frame);
}

export function stopSwing(): void {
  if (waiting !== 0) cancelAnimationFrame(waiting);
  waiting = 0;
}
