import type { Vec3 } from "../../scene/interface";
import { useDesign } from "../../state/design/design";
import { edgesOf, useSelection, verticesOf } from "../../state/design/selection";
import { useView } from "../../state/window/view";

/** px around a vertex that belong to it: its sign. */
const AROUND = 24;
/** px on either side of an edge: its width, and the figure beside it. */
const BESIDE = 8;
/** px from the middle of the gizmo to the tips of its arrows. */
const GIZMO = 66;

interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

interface Spot {
  readonly x: number;
  readonly y: number;
}

/** Whether a line comes nearer than `off` to a box, px: each pair of its sides leaves a stretch of the line between them. */
function meets(box: Box, a: Spot, b: Spot, off: number): boolean {
  const ways = [
    [a.x, b.x - a.x, box.left - off, box.right + off],
    [a.y, b.y - a.y, box.top - off, box.bottom + off],
  ] as const;
  let [from, to] = [0, 1];
  for (const [at, way, low, high] of ways) {
    if (way === 0) {
      if (at <= low || at >= high) return false;
      continue;
    }
    const [one, other] = [(low - at) / way, (high - at) / way];
    from = Math.max(from, Math.min(one, other));
    to = Math.min(to, Math.max(one, other));
  }
  return from < to;
}

/**
 * How much of what is selected or pointed at, which a message speaks of, lies below something that is over the view: vertices, edges
 * along their whole length, and the gizmo.
 */
function covered(element: HTMLElement): number {
  const { handle } = useView.getState();
  const over = element.offsetParent?.getBoundingClientRect();
  if (!handle || !over) return 0;
  const { left, right, top, bottom } = element.getBoundingClientRect();
  const box = { left: left - over.left, right: right - over.left, top: top - over.top, bottom: bottom - over.top };
  const { seen } = handle;
  const isBelow = (from: Vec3, to: Vec3, off: number) => {
    const line = seen.segment(from, to);
    return line !== null && meets(box, line.a, line.b, off);
  };
  const design = useDesign.getState();
  const selection = useSelection.getState();
  const both = [selection, selection.highlight];
  const vertices = new Set(both.flatMap((of) => verticesOf(of, design)));
  const edges = new Set(both.flatMap((of) => edgesOf(of, design)));
  const at = (id: number) => design.vertices.get(id)?.at;
  let count = seen.gizmo && isBelow(seen.gizmo, seen.gizmo, GIZMO) ? 1 : 0;
  for (const id of vertices) {
    const place = at(id);
    if (place && isBelow(place, place, AROUND)) count += 1;
  }
  for (const id of edges) {
    const edge = design.edges.get(id);
    const [a, b] = [edge && at(edge.a), edge && at(edge.b)];
    if (a && b && isBelow(a, b, BESIDE)) count += 1;
  }
  return count;
}

/** Whether it is better at the upper edge: where it covers as much at either, it stays where it is. */
export function belongsAtTop(element: HTMLElement, atTop: boolean): boolean {
  const here = covered(element);
  if (here === 0) return atTop;
  // Measured there, and put back before anything is drawn: as wide and high as it would be.
  element.classList.toggle("top", !atTop);
  const there = covered(element);
  element.classList.toggle("top", atTop);
  return there < here ? !atTop : atTop;
}
