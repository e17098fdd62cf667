/** Selecting by a box on the screen: what lies in it (drawn to the right), or what it touches (drawn to the left). */

import type { Selection, Vec3 } from "../interface";
import type { Pickable } from "./picking";

/** From where the button was pressed to where the pointer is, CSS pixels. */
export interface Box {
  readonly x0: number;
  readonly y0: number;
  readonly x1: number;
  readonly y1: number;
}

export type Combine = "replace" | "add" | "toggle";

export const touching = (box: Box): boolean => box.x1 < box.x0;

export function inBox({ design, projection, lines: drawn }: Pickable, box: Box): Selection {
  const [left, right] = [Math.min(box.x0, box.x1), Math.max(box.x0, box.x1)];
  const [top, bottom] = [Math.min(box.y0, box.y1), Math.max(box.y0, box.y1)];
  const within = (x: number, y: number): boolean => x >= left && x <= right && y >= top && y <= bottom;
  const isIn = (at: Vec3): boolean => {
    const seen = projection.seen(at);
    return projection.sees(seen) && within(seen.x, seen.y);
  };
  const inside = design.at.map(isIn);
  const vertices = new Set(design.vertices.filter((_, row) => inside[row]).map((vertex) => vertex.id));
  const touches = touching(box);
  const takes = (a: boolean | undefined, b: boolean | undefined, segment: readonly [Vec3, Vec3]): boolean => {
    if (a && b) return true;
    if (!touches) return false;
    if (a || b) return true;
    const seen = projection.segment(...segment);
    return seen !== null && crosses(seen.a.x, seen.a.y, seen.b.x, seen.b.y, left, top, right, bottom);
  };
  const edges = design.edges.filter((_, row) => {
    const [a, b] = design.ends[row] ?? [0, 0];
    return takes(inside[a], inside[b], design.segment(row));
  });
  const lines = drawn.flatMap((line, place) => (takes(isIn(line[0]), isIn(line[1]), line) ? [place] : []));
  return { vertices, edges: new Set(edges.map((edge) => edge.id)), lines: new Set(lines) };
}

export function combine(before: Selection, found: Selection, how: Combine): Selection {
  if (how === "replace") return found;
  const join = (a: ReadonlySet<number>, b: ReadonlySet<number>): Set<number> => {
    const both = new Set([...a, ...b]);
    if (how === "toggle") for (const id of a) if (b.has(id)) both.delete(id);
    return both;
  };
  return {
    vertices: join(before.vertices, found.vertices),
    edges: join(before.edges, found.edges),
    lines: join(before.lines, found.lines),
  };
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
