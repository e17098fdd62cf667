/** Selecting by a box on the screen: what lies in it (drawn to the right), or what it touches (drawn to the left). */

import type { Selection } from "../interface";
import type { DrawnDesign } from "../layers/drawn_design";
import type { Projection } from "../view/projection";

/** From where the button was pressed to where the pointer is, CSS pixels. */
export interface Box {
  readonly x0: number;
  readonly y0: number;
  readonly x1: number;
  readonly y1: number;
}

export type Combine = "replace" | "add" | "toggle";

export const touching = (box: Box): boolean => box.x1 < box.x0;

export function inBox(design: DrawnDesign, projection: Projection, box: Box): Selection {
  const [left, right] = [Math.min(box.x0, box.x1), Math.max(box.x0, box.x1)];
  const [top, bottom] = [Math.min(box.y0, box.y1), Math.max(box.y0, box.y1)];
  const within = (x: number, y: number): boolean => x >= left && x <= right && y >= top && y <= bottom;
  const inside = design.at.map((at) => {
    const seen = projection.seen(at);
    return projection.sees(seen) && within(seen.x, seen.y);
  });
  const vertices = new Set(design.vertices.filter((_, row) => inside[row]).map((vertex) => vertex.id));
  const touches = touching(box);
  const edges = design.edges.filter((_, row) => {
    const [a, b] = design.ends[row] ?? [0, 0];
    if (inside[a] && inside[b]) return true;
    if (!touches) return false;
    if (inside[a] || inside[b]) return true;
    const seen = projection.segment(...design.segment(row));
    return seen !== null && crosses(seen.a.x, seen.a.y, seen.b.x, seen.b.y, left, top, right, bottom);
  });
  return { vertices, edges: new Set(edges.map((edge) => edge.id)) };
}

export function combine(before: Selection, found: Selection, how: Combine): Selection {
  if (how === "replace") return found;
  const join = (a: ReadonlySet<number>, b: ReadonlySet<number>): Set<number> => {
    const both = new Set([...a, ...b]);
    if (how === "toggle") for (const id of a) if (b.has(id)) both.delete(id);
    return both;
  };
  return { vertices: join(before.vertices, found.vertices), edges: join(before.edges, found.edges) };
}

/** Whether a line has a part in a rectangle (Liang and Barsky's way of cutting a line off at the sides). */
function crosses(
  ax: number,
  ay: number,
  bx: number,
  by: number,
  left: number,
  top: number,
  right: number,
  bottom: number,
): boolean {
  let [from, to] = [0, 1];
  const sides: [number, number][] = [
    [ax - bx, ax - left],
    [bx - ax, right - ax],
    [ay - by, ay - top],
    [by - ay, bottom - ay],
  ];
  for (const [slope, room] of sides) {
    if (slope === 0) {
      if (room < 0) return false;
    } else if (slope < 0) {
      from = Math.max(from, room / slope);
    } else {
      to = Math.min(to, room / slope);
    }
  }
  return from <= to;
}
