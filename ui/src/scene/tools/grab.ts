/** Moving a selection: by the pointer, along a locked axis, by a typed distance, with or without snapping. Pure. */

import type { Axis, LengthFormat, Moved, Vec3 } from "../interface";
import { AXES, add, ORIGIN, scale, subtract } from "../vec";
import type { Projection } from "../view/projection";
import { allowed, type Constraint, displacement, FREE, onGrid, type Pointer } from "./move";
import { NumberEntry } from "./number_entry";

/** What a grab asks about the surroundings. */
export interface Surroundings {
  readonly projection: Projection;
  /** A target near a place on the screen: a vertex, a stencil. Null where there is none. */
  target(x: number, y: number): Vec3 | null;
  /** mm; null where the grid does not count, or is not near enough to `at`. */
  grid(at: Vec3, snapped: Vec3): boolean;
  readonly spacing: number;
}

export class Grab {
  constraint: Constraint;
  readonly entry = new NumberEntry();
  /** Displacement so far, mm. */
  by: Vec3 = ORIGIN;
  private readonly start: Pointer;

  /** `from`: where each vertex that moves is; `anchor`: the one of these places that snaps. */
  constructor(
    readonly from: ReadonlyMap<number, Vec3>,
    readonly anchor: Vec3,
    start: Pointer,
    private readonly lengths: LengthFormat,
    constraint: Constraint = FREE,
  ) {
    this.start = start;
    this.constraint = constraint;
  }

  /** Follows the pointer; `snapping` as it counts now. */
  follow(now: Pointer, around: Surroundings, snapping: boolean): void {
    const typed = this.typed;
    if (typed !== null) {
      this.by = scale(AXES[this.axis ?? "x"], typed);
      return;
    }
    const free = displacement(this.constraint, this.anchor, this.start, now, around.projection);
    this.by = snapping ? this.snapped(free, around) : free;
  }

  /** Locks an axis, or its plane; the same again frees it. */
  lock(axis: Axis | null, plane = false): void {
    const wanted: Constraint = axis === null ? FREE : plane ? { kind: "plane", normal: axis } : { kind: "axis", axis };
    const same = JSON.stringify(wanted) === JSON.stringify(this.constraint);
    this.constraint = same ? FREE : wanted;
  }

  /** Whether the key was taken. A number without an axis goes along x, as its readout says. */
  type(key: string): boolean {
    if (!this.entry.key(key)) return false;
    if (this.entry.value !== null && this.axis === null) this.constraint = { kind: "axis", axis: "x" };
    return true;
  }

  get moved(): Moved[] {
    return [...this.from].map(([vertex, at]) => ({ vertex, at: this.goes(at) }));
  }

  /** Where a place of what moves goes. */
  goes(place: Vec3): Vec3 {
    return add(place, this.by);
  }

  get axis(): Axis | null {
    return this.constraint.kind === "axis" ? this.constraint.axis : null;
  }

  /** How far it goes, as it is written beside the view. */
  get readout(): string {
    const { name } = this.lengths;
    const write = (mm: number): string => this.lengths.number(mm);
    if (this.axis && this.entry.shown !== "") return `${this.axis} ${this.entry.shown}▏ ${name}`;
    const [x, y, z] = this.by;
    if (this.axis) return `${this.axis} ${write({ x, y, z }[this.axis])} ${name}`;
    return `x ${write(x)}   y ${write(y)}   z ${write(z)} ${name}`;
  }

  /** mm. */
  private get typed(): number | null {
    const value = this.entry.value;
    return value === null ? null : value * this.lengths.mm;
  }

  private snapped(free: Vec3, around: Surroundings): Vec3 {
    const at = add(this.anchor, free);
    const seen = around.projection.seen(at);
    const target = around.target(seen.x, seen.y);
    if (target) return allowed(this.constraint, subtract(target, this.anchor));
    const rounded = onGrid(this.constraint, at, around.spacing, around.projection.axes.back);
    return around.grid(at, rounded) ? subtract(rounded, this.anchor) : free;
  }
}
