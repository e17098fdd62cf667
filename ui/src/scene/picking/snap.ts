/** What a click would take hold of: the first kind within reach, in a fixed order. */

import type { DrawingPlane, SnapKind, SnapSettings, Vec3 } from "../interface";
import type { DrawnDesign } from "../layers/drawn_design";
import { GROUND, normalOf } from "../layers/grid";
import { add, along, dot, inPlane, middle, onPlane, planeAngle, scale, subtract } from "../vec";
import type { Projection } from "../view/projection";
import { nearest, nearOnSegment, pickEdge, pickVertex } from "./picking";

/** Until a person has chosen otherwise. */
export const DEFAULT_SNAP: SnapSettings = {
  kinds: new Set([
    "vertex",
    "stencil-vertex",
    "stencil-edge",
    "construction",
    "edge-middle",
    "edge",
    "surface",
    "angle",
    "grid",
    "plane",
  ]),
  grid: 10,
  reach: 10,
};

/** Places of which one is in front of the other: so near on the screen, CSS pixels, and so far apart from the eye, mm. */
const TOGETHER = { pixels: 1, depth_mm: 0.01 };

/** Between the directions that an edge is kept to, degrees. */
const STEP = 15;

export interface SnapTarget {
  readonly kind: SnapKind;
  /** mm. */
  readonly at: Vec3;
  /** The vertex that is there already. */
  readonly vertex?: number;
  /** The edge that would be split, and where: 0 at `a`, 1 at `b`. */
  readonly edge?: number;
  readonly along?: number;
  /** The construction line that it is on, between its ends and its middle, or the side of the stencil. */
  readonly line?: Line;
}

/** What of a stencil is near the pointer. */
export interface StencilTargets {
  readonly vertex: Vec3 | null;
  readonly edge: Vec3 | null;
  /** The straight side of the surface that the place on an edge is on, from end to end; none of what is off the surface. */
  readonly side: Line | null;
  readonly surface: Vec3 | null;
}

/** What there is to snap to on the surface that is traced. */
export interface SurfaceTargets {
  /** The nearest corner and edge of triangles within `reach` CSS pixels, and the place under the pointer. */
  near(projection: Projection, x: number, y: number, reach: number): StencilTargets;
  /** Whether the surface is in front of a place. */
  hides(projection: Projection, at: Vec3): boolean;
}

/** A line from one place to another. */
export type Line = readonly [Vec3, Vec3];

export interface SnapPlace {
  readonly design: DrawnDesign;
  readonly projection: Projection;
  readonly stencil: SurfaceTargets | null;
  /** The two ends of each construction line. */
  readonly construction: readonly Line[];
  /** Null for the ground. */
  readonly plane: DrawingPlane | null;
  /** Vertices and edges that do not count, by id: they are moved, or the strand comes from there. */
  readonly without: { readonly vertices: ReadonlySet<number>; readonly edges: ReadonlySet<number> };
}

export function snap(place: SnapPlace, settings: SnapSettings, x: number, y: number): SnapTarget | null {
  const { design, projection, stencil, without } = place;
  const { kinds, reach } = settings;
  // What a surface covers is not meant by a user who traces on it.
  const covered = (at: Vec3): boolean => stencil?.hides(projection, at) ?? false;
  const wanted = kinds.has("stencil-vertex") || kinds.has("stencil-edge") || kinds.has("surface");
  let beside: ReturnType<SurfaceTargets["near"]> | null = null;
  /** What of the stencil is near: asked once, since it takes long. */
  const nearStencil = () => {
    if (wanted) beside ??= stencil?.near(projection, x, y, reach) ?? null;
    return beside;
  };
  if (kinds.has("vertex")) {
    const found = pickVertex(design, projection, x, y, reach, (id) => without.vertices.has(id));
    const corner = found && kinds.has("stencil-vertex") ? nearStencil()?.vertex : null;
    // A vertex on the far rim of a cylinder that is seen from its end is behind the near rim, and no face covers it.
    const behind = found && corner && isInFront(projection, corner, found.at);
    if (found && !behind && !covered(found.at)) return { kind: "vertex", at: found.at, vertex: found.id };
  }
  const line = kinds.has("construction") ? onLines(place.construction, projection, x, y, reach) : null;
  if (line?.point && !covered(line.point)) return { kind: "construction", at: line.point };
  const near = nearStencil();
  if (kinds.has("stencil-vertex") && near?.vertex) {
    // Off the stencil a vertex is seen beside the corner that it was placed by: a click on that means it.
    const there = kinds.has("vertex") ? design.vertexAt(near.vertex) : null;
    if (there !== null && !without.vertices.has(there)) return { kind: "vertex", at: near.vertex, vertex: there };
    return { kind: "stencil-vertex", at: near.vertex };
  }
  if (kinds.has("stencil-edge") && near?.edge) {
    return { kind: "stencil-edge", at: near.edge, ...(near.side && { line: near.side }) };
  }
  if (kinds.has("edge") || kinds.has("edge-middle")) {
    const found = pickEdge(design, projection, x, y, reach, (row) => excluded(design, row, without));
    const half = kinds.has("edge-middle") && found ? middleOf(design, found.id) : null;
    if (found && half && within(projection, half, x, y, reach) && !covered(half))
      return { kind: "edge-middle", at: half, edge: found.id, along: 0.5 };
    // The very end of an edge is its vertex, which had its turn.
    if (kinds.has("edge") && found && found.along > 1e-6 && found.along < 1 - 1e-6 && !covered(found.at)) {
      return { kind: "edge", at: found.at, edge: found.id, along: found.along };
    }
  }
  if (line && !covered(line.at)) return { kind: "construction", at: line.at, line: line.whole };
  if (kinds.has("surface") && near?.surface) return { kind: "surface", at: near.surface };
  return onDrawingPlane(place, settings, x, y);
}

/** The nearest place on a line within reach, and its end or middle where that is within reach as well. */
function onLines(
  lines: readonly Line[],
  projection: Projection,
  x: number,
  y: number,
  reach: number,
): { readonly at: Vec3; readonly point: Vec3 | null; readonly whole: Line } | null {
  const found = lines.flatMap((line) => {
    const near = nearOnSegment(projection, line[0], line[1], x, y);
    return near && near.off <= reach ? [{ line, ...near }] : [];
  });
  const best = nearest(found);
  if (!best) return null;
  const points = [...best.line, middle(best.line)];
  return {
    at: best.at,
    whole: best.line,
    point: points.find((point) => within(projection, point, x, y, reach)) ?? null,
  };
}

/** Whether a place is seen where another one is, and nearer to the eye. */
function isInFront(projection: Projection, place: Vec3, other: Vec3): boolean {
  const [a, b] = [projection.seen(place), projection.seen(other)];
  return Math.hypot(a.x - b.x, a.y - b.y) <= TOGETHER.pixels && a.depth < b.depth - TOGETHER.depth_mm;
}

/** Whether the pointer is so near to a place, in CSS pixels. */
function within(projection: Projection, at: Vec3, x: number, y: number, reach: number): boolean {
  const seen = projection.seen(at);
  return Math.hypot(seen.x - x, seen.y - y) <= reach;
}

/** Half way along an edge. */
function middleOf(design: DrawnDesign, id: number): Vec3 | null {
  const row = design.edgeRow(id);
  return row === undefined ? null : middle(design.segment(row));
}

/** A point of the grid, or of the plane. */
function onDrawingPlane(
  { projection, plane }: SnapPlace,
  { kinds, grid, reach }: SnapSettings,
  x: number,
  y: number,
): SnapTarget | null {
  const drawn = plane ?? GROUND;
  const ray = projection.ray(x, y);
  const at = onPlane(ray, drawn.origin, normalOf(drawn));
  if (!at || (projection.perspective && dot(subtract(at, ray.origin), ray.direction) < 0)) return null;
  if (kinds.has("grid") && grid > 0) {
    const rounded = roundedOn(drawn, at, grid);
    if (!kinds.has("plane") || within(projection, rounded, x, y, reach)) return { kind: "grid", at: rounded };
  }
  return kinds.has("plane") ? { kind: "plane", at } : null;
}

/** The nearest point of a plane's grid. */
function roundedOn(plane: DrawingPlane, at: Vec3, grid: number): Vec3 {
  const off = subtract(at, plane.origin);
  const [a, b] = [plane.u, plane.v].map((axis) => Math.round(dot(off, axis) / grid) * grid) as [number, number];
  return add(plane.origin, add(scale(plane.u, a), scale(plane.v, b)));
}

/**
 * The place on a plane along the nearest direction from `from` that is a multiple of 15°, as far as `at` is; how far is in steps of
 * `grid`, where it is given.
 */
export function inDirections(plane: DrawingPlane, from: Vec3, at: Vec3, grid: number | null = null): Vec3 {
  const off = subtract(at, from);
  const way = inPlane(plane, Math.round(planeAngle(plane, off) / STEP) * STEP);
  const size = dot(off, way);
  return along(from, way, grid ? Math.round(size / grid) * grid : size);
}

function excluded(design: DrawnDesign, row: number, without: SnapPlace["without"]): boolean {
  const edge = design.edges[row];
  if (!edge) return true;
  return without.edges.has(edge.id) || without.vertices.has(edge.a) || without.vertices.has(edge.b);
}
