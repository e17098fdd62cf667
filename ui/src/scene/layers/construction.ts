/** Construction lines: to measure and to snap to, never bent. */

import type { Sign } from "../drawing/symbols";
import type { Theme } from "../drawing/theme";
import type { Guide, TubeLook } from "../drawing/tubes";
import type { Selection, Vec3 } from "../interface";
import type { Line } from "../picking/snap";
import type { Held } from "./chosen";

/** Which of the lines are marked, and how. */
interface Marked {
  readonly selection: Selection;
  readonly hovered: Selection;
  readonly highlight: Selection;
}

/** Factor on the width of a line that is selected. */
const WIDE = 2;

export class Construction {
  /** Each by its two ends where the design has them, mm. */
  all: readonly Line[] = [];
  /** Where the selected ones are while they are in the hand; null where the design has them. */
  held: Held | null = null;

  /** Whether anything is other than before. */
  show(lines: readonly Line[]): boolean {
    if (JSON.stringify(lines) === JSON.stringify(this.all)) return false;
    this.all = lines;
    return true;
  }

  /** The ends of those that are selected, where they are shown. */
  endsOf({ lines }: Selection): Vec3[] {
    return [...lines].flatMap((place) => this.all[place] ?? []).map((end) => this.held?.(end) ?? end);
  }

  /** Those that stay where they are when a selection moves. */
  without({ lines }: Selection): readonly Line[] {
    return lines.size === 0 ? this.all : this.all.filter((_, place) => !lines.has(place));
  }

  lines(theme: Theme, marked: Marked): Guide[] {
    return this.all.map(([from, to], place) => {
      const goes = (marked.selection.lines.has(place) && this.held) || ((end: Vec3) => end);
      return { from: goes(from), to: goes(to), look: lookOf(place, theme, marked) };
    });
  }

  /** The ends of lines that are selected. */
  signs(theme: Theme, { selection }: Marked): Sign[] {
    return this.endsOf(selection).map((at) => ({ at, shape: "dot", colour: theme.selected, radius: 5 }));
  }
}

function lookOf(place: number, theme: Theme, { selection, hovered, highlight }: Marked): TubeLook {
  if (selection.lines.has(place)) return { colour: theme.selected, width: WIDE };
  if (hovered.lines.has(place)) return { colour: theme.hovered, width: WIDE };
  if (highlight.lines.has(place)) return { colour: theme.acted, width: WIDE };
  return { colour: theme.stencil };
}
