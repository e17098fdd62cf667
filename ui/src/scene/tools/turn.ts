/** Turning a selection or a stencil about an axis through its middle: by the pointer, or by a typed angle. Pure; right-handed, degrees. */

import type { Axis, LengthFormat, Moved, Vec3 } from "../interface";
import { AXES, add, along, cross, dot, onPlane, scale, subtract } from "../vec";
import type { Projection } from "../view/projection";
import { acrossOf } from "./gizmo_parts";
import type { Pointer } from "./move";
import { NumberEntry } from "./number_entry";

/** Degrees between the angles that it snaps to. */
const STEP = 15;

export class Turn {
  axis: Axis;
  readonly entry = new NumberEntry();
  /** How far it is turned. */
  deg = 0;
  /** As the pointer has it, without snapping: it adds up, so that it may go round more than once. */
  private followed = 0;
  private before: number | null = null;

  /** `from`: where each vertex that turns is. */
  constructor(
    readonly from: ReadonlyMap<number, Vec3>,
    readonly centre: Vec3,
    axis: Axis,
    private readonly lengths: LengthFormat,
  ) {
    this.axis = axis;
  }

  follow(now: Pointer, projection: Projection, snapping: boolean): void {
    const typed = this.entry.value;
    if (typed !== null) {
      this.deg = typed;
      return;
    }
    const seen = this.seen(now, projection);
    if (seen === null) return;
    if (this.before !== null) this.followed += 180 - ((((180 - (seen - this.before)) % 360) + 360) % 360);
    this.before = seen;
    this.deg = snapping ? Math.round(this.followed / STEP) * STEP : this.followed;
  }

  /** Turns about another axis, from where everything was. */
  lock(axis: Axis): void {
    this.axis = axis;
    this.before = null;
    this.followed = 0;
    this.deg = 0;
  }

  /** Whether the key was taken. */
  type(key: string): boolean {
    return this.entry.key(key);
  }

  get moved(): Moved[] {
    return [...this.from].map(([vertex, place]) => ({ vertex, at: this.goes(place) }));
  }

  /** Where a place of what turns goes. */
  goes(place: Vec3): Vec3 {
    const axis = AXES[this.axis];
    const rad = (this.deg * Math.PI) / 180;
    const arm = subtract(place, this.centre);
    const aside = scale(axis, dot(arm, axis));
    const turned = along(scale(subtract(arm, aside), Math.cos(rad)), cross(axis, arm), Math.sin(rad));
    return add(this.centre, add(aside, turned));
  }

  get readout(): string {
    const angle = this.entry.shown === "" ? this.lengths.angle(this.deg) : `${this.entry.shown}▏°`;
    return `about ${this.axis} ${angle}`;
  }

  /** The angle of the pointer about the axis; null where the view does not tell it, as where the axis is seen from its side. */
  private seen({ x, y }: Pointer, projection: Projection): number | null {
    const at = onPlane(projection.ray(x, y), this.centre, AXES[this.axis]);
    // Beyond the horizon of the plane the line of sight meets it behind the eye, on the other side of the axis.
    if (!at || (projection.perspective && projection.depth(at) <= 0)) return null;
    const arm = subtract(at, this.centre);
    const [u, v] = acrossOf(this.axis);
    return (Math.atan2(dot(arm, AXES[v]), dot(arm, AXES[u])) * 180) / Math.PI;
  }
}
