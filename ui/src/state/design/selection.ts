import { create } from "zustand";
import type { SceneDesign, Selection } from "../../scene/interface";
import { NOTHING, stillThere } from "./selecting";

export * from "./selecting";

/** What is selected, and what is pointed at in a list. */
interface SelectionStore extends Selection {
  readonly highlight: Selection;
}

export const useSelection = create<SelectionStore>()(() => ({ ...NOTHING, highlight: NOTHING }));

export function select(vertices: Iterable<number>, edges: Iterable<number> = []): void {
  useSelection.setState({ vertices: new Set(vertices), edges: new Set(edges) });
}

export function highlight(vertices: Iterable<number> = [], edges: Iterable<number> = []): void {
  useSelection.setState({ highlight: { vertices: new Set(vertices), edges: new Set(edges) } });
}

/** What is not there any more is not selected. */
export function keepSelected(design: SceneDesign): void {
  const { vertices, edges, highlight: pointed } = useSelection.getState();
  const selection = { vertices, edges };
  const left = stillThere(selection, design);
  if (left !== selection) useSelection.setState(left);
  const still = stillThere(pointed, design);
  if (still !== pointed) useSelection.setState({ highlight: still });
}
