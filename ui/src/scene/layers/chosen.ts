/** The stencil that is chosen: the box around it, and how far it is dragged. */

import type { Theme } from "../drawing/theme";
import type { Guide } from "../drawing/tubes";
import type { ChosenStencil, Vec3 } from "../interface";
import { add, ORIGIN } from "../vec";

export class Chosen {
  stencil: ChosenStencil | null = null;
  /** How far it is dragged, mm. */
  shift: Vec3 = ORIGIN;

  get middle(): Vec3 | null {
    return this.stencil && add(this.stencil.middle, this.shift);
  }

  lines(theme: Theme): Guide[] {
    const look = { colour: theme.selected };
    const lines = this.stencil?.box ?? [];
    return lines.map(([from, to]) => ({ from: add(from, this.shift), to: add(to, this.shift), look }));
  }
}
