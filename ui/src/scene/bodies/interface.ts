/** What the view of a machine whose bodies are edited is given, and what it reports. */

import type { MachineBody, Vec3 } from "../interface";

/** A machine whose bodies are edited. */
export interface EditedMachine {
  readonly bodies: readonly MachineBody[];
  readonly wireDiameter: number;
  /** As in `Played`. */
  readonly orbitOffset: number;
}

/** What the view of a machine's bodies reports. A body is its place in `bodies`. */
export interface BodiesListener {
  /** It was clicked on; null: a click beside all. */
  chosen(body: number | null): void;
  /** While it is dragged: where its centre is, mm. */
  dragging(body: number, at: Vec3): void;
  /** The drag is over: one change. The view shows the new place until the machine that it is given has it. */
  dropped(body: number, at: Vec3): void;
  dragCancelled(): void;
  /** As of `SceneListener`. */
  viewChanged(name: string): void;
}
