/** The stencil that is chosen: the box around it, and where it is while it is in the hand. */

import type { Theme } from "../drawing/theme";
import type { Guide } from "../drawing/tubes";
import type { ChosenStencil, Vec3 } from "../interface";

/** Where a place of what is in the hand goes: it is moved or turned, and keeps its size. */
export type Held = (place: Vec3) => Vec3;

export class Chosen {
  stencil: ChosenStencil | null = null;
  /** Null where it lies as the design has it. */
  held: Held | null = null;

  get middle(): Vec3 | null {
    return this.stencil && this.goes(this.stencil.middle);
  }

  lines(theme: Theme): Guide[] {
    const look = { colour: theme.selected };
    const lines = this.stencil?.box ?? [];
    return lines.map(([from, to]) => ({ from: this.goes(from), to: this.goes(to), look }));
  }

  private goes(place: Vec3): Vec3 {
    return this.held ? this.held(place) : place;
  }
}
