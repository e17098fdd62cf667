/** Construction lines: to measure and to snap to, never bent. */

import type { Theme } from "../drawing/theme";
import type { Guide } from "../drawing/tubes";
import type { Line } from "../picking/snap";

export class Construction {
  /** Each by its two ends, mm. */
  all: readonly Line[] = [];
  /** The place in the list of the one that is pointed at elsewhere. */
  private pointed: number | null = null;

  /** Whether anything is other than before. */
  show(lines: readonly Line[], pointed: number | null): boolean {
    if (pointed === this.pointed && JSON.stringify(lines) === JSON.stringify(this.all)) return false;
    this.all = lines;
    this.pointed = pointed;
    return true;
  }

  lines(theme: Theme): Guide[] {
    return this.all.map(([from, to], index) => {
      const colour = index === this.pointed ? theme.selected : theme.stencil;
      return { from, to, look: { colour } };
    });
  }
}
