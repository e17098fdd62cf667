import { useDesign } from "../../state/design/design";
import { useSelection, verticesOf } from "../../state/design/selection";
import { useView } from "../../state/window/view";

/** px around a vertex that belong to it: its sign, and the gizmo's middle. */
const AROUND = 24;

/** Whether something that lies over the view covers a vertex that is selected or pointed at: what a message speaks of. */
export function coversSelection(element: HTMLElement): boolean {
  const { handle } = useView.getState();
  const over = element.offsetParent?.getBoundingClientRect();
  if (!handle || !over) return false;
  const box = element.getBoundingClientRect();
  const design = useDesign.getState();
  const selection = useSelection.getState();
  const ids = [...verticesOf(selection, design), ...verticesOf(selection.highlight, design)];
  return ids.some((id) => {
    const at = design.vertices.get(id)?.at;
    const seen = at && handle.screen(at);
    if (!seen) return false;
    const [x, y] = [seen.x + over.left, seen.y + over.top];
    return x > box.left - AROUND && x < box.right + AROUND && y > box.top - AROUND && y < box.bottom + AROUND;
  });
}
