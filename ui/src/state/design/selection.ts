import { create } from "zustand";
import type { SceneDesign, Selection } from "../../scene/interface";
import { type Line, placesAfter } from "../construction/lines";
import { NOTHING, stillThere } from "./selecting";

export * from "./selecting";

/** What is selected, and what is pointed at in a list. */
interface SelectionStore extends Selection {
  readonly highlight: Selection;
}

export const useSelection = create<SelectionStore>()(() => ({ ...NOTHING, highlight: NOTHING }));

function of(vertices: Iterable<number>, edges: Iterable<number>, lines: Iterable<number>): Selection {
  return { vertices: new Set(vertices), edges: new Set(edges), lines: new Set(lines) };
}

export function select(vertices: Iterable<number>, edges: Iterable<number> = [], lines: Iterable<number> = []): void {
  useSelection.setState(of(vertices, edges, lines));
}

export function highlight(
  vertices: Iterable<number> = [],
  edges: Iterable<number> = [],
  lines: Iterable<number> = [],
): void {
  useSelection.setState({ highlight: of(vertices, edges, lines) });
}

/** What is not there any more is not selected. */
export function keepSelected(design: SceneDesign): void {
  const { vertices, edges, highlight: pointed } = useSelection.getState();
  const selection = { vertices, edges };
  const left = stillThere(selection, design);
  if (left !== selection) useSelection.setState(left);
  const still = stillThere(pointed, design);
  if (still !== pointed) useSelection.setState({ highlight: { ...pointed, ...still } });
}

/** Construction lines have changed: those stay selected that were, wherever the list has them now. */
export function keepSelectedLines(before: readonly Line[], after: readonly Line[]): void {
  const { lines, highlight: pointed } = useSelection.getState();
  if (lines.size > 0) useSelection.setState({ lines: new Set(placesAfter(lines, before, after)) });
  // What is pointed at is a row of the list, which moves on under the pointer.
  if (pointed.lines.size > 0) useSelection.setState({ highlight: { ...pointed, lines: new Set() } });
}

/** Construction lines are hidden: what is not seen would be moved or deleted unseen. */
export function deselectLines(): void {
  if (useSelection.getState().lines.size > 0) useSelection.setState({ lines: new Set() });
}
