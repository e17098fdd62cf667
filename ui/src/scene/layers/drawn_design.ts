/** The design as it is drawn: rows for quick drawing and picking, with places that a drag has not yet handed over. */

import type { Moved, SceneDesign, SceneEdge, SceneVertex, Selection, Vec3, WireSelection } from "../interface";
import { distance, ORIGIN } from "../vec";

/** What has to be drawn again. */
export type Change = { readonly rows: "all" } | { readonly rows: readonly number[] };

export const NOTHING_SELECTED: Selection = { vertices: new Set(), edges: new Set(), lines: new Set() };

/** mm between vertices that are at the same place. */
const SAME = 1e-6;

export class DrawnDesign {
  /** By row, in the order of the design. */
  vertices: readonly SceneVertex[] = [];
  edges: readonly SceneEdge[] = [];
  /** Where each vertex is shown, mm. */
  readonly at: Vec3[] = [];
  /** Rows of the ends of each edge. */
  ends: readonly (readonly [number, number])[] = [];
  private vertexRows = new Map<number, number>();
  private edgeRows = new Map<number, number>();
  /** Rows of edges at each vertex row. */
  private meeting: number[][] = [];
  private lifted = new Set<number>();

  /** Places that were moved here are given up. Vertices and edges are compared by identity, so one that changed has to be a new object. */
  update(design: SceneDesign): Change {
    if (!this.sameRows(design)) {
      this.rebuild(design);
      return { rows: "all" };
    }
    const changed = new Set(this.lifted);
    this.lifted.clear();
    const vertices = [...design.vertices.values()];
    vertices.forEach((vertex, row) => {
      if (vertex !== this.vertices[row]) changed.add(row);
    });
    this.vertices = vertices;
    for (const row of changed) this.at[row] = vertices[row]?.at ?? ORIGIN;
    return { rows: [...changed] };
  }

  /** Shows vertices elsewhere until the next `update`; those of an earlier move that are not in this one go back. */
  move(moved: readonly Moved[]): Change {
    const changed = new Set(this.lifted);
    for (const row of this.lifted) this.at[row] = this.vertices[row]?.at ?? ORIGIN;
    this.lifted = new Set();
    for (const { vertex, at } of moved) {
      const row = this.vertexRows.get(vertex);
      if (row === undefined) continue;
      this.at[row] = at;
      this.lifted.add(row);
      changed.add(row);
    }
    return { rows: [...changed] };
  }

  vertexRow(id: number): number | undefined {
    return this.vertexRows.get(id);
  }

  edgeRow(id: number): number | undefined {
    return this.edgeRows.get(id);
  }

  edgesAt(vertexRow: number): readonly number[] {
    return this.meeting[vertexRow] ?? [];
  }

  place(id: number): Vec3 | null {
    const row = this.vertexRows.get(id);
    return row === undefined ? null : (this.at[row] ?? null);
  }

  /** The first vertex at a place; null where there is none. */
  vertexAt(place: Vec3): number | null {
    const row = this.at.findIndex((at) => distance(at, place) < SAME);
    return this.vertices[row]?.id ?? null;
  }

  /** Both ends of an edge by row. */
  segment(edgeRow: number): readonly [Vec3, Vec3] {
    const [a, b] = this.ends[edgeRow] ?? [0, 0];
    return [this.at[a] ?? ORIGIN, this.at[b] ?? ORIGIN];
  }

  /** Vertices that move with a selection: its own and the ends of its edges. */
  moving(selection: WireSelection): Set<number> {
    const moving = new Set([...selection.vertices].filter((id) => this.vertexRows.has(id)));
    for (const id of selection.edges) {
      const edge = this.edges[this.edgeRows.get(id) ?? -1];
      if (edge) moving.add(edge.a).add(edge.b);
    }
    return moving;
  }

  /** The same, each with where it is. */
  placesOf(selection: WireSelection): Map<number, Vec3> {
    const places = [...this.moving(selection)].map((id) => [id, this.place(id)] as const);
    return new Map(places.filter((each): each is readonly [number, Vec3] => each[1] !== null));
  }

  /** Everything that hangs together with a vertex. */
  connected(vertex: number): WireSelection {
    const vertices = new Set<number>();
    const edges = new Set<number>();
    const open = [vertex];
    for (let id = open.pop(); id !== undefined; id = open.pop()) {
      const row = this.vertexRows.get(id);
      if (row === undefined || vertices.has(id)) continue;
      vertices.add(id);
      for (const edgeRow of this.edgesAt(row)) {
        const edge = this.edges[edgeRow];
        if (!edge) continue;
        edges.add(edge.id);
        open.push(edge.a === id ? edge.b : edge.a);
      }
    }
    return { vertices, edges };
  }

  private sameRows(design: SceneDesign): boolean {
    if (design.vertices.size !== this.vertices.length || design.edges.size !== this.edges.length) return false;
    let row = 0;
    for (const vertex of design.vertices.values()) {
      const before = this.vertices[row++];
      if (before !== vertex && (before?.id !== vertex.id || before.support !== vertex.support)) return false;
    }
    row = 0;
    for (const edge of design.edges.values()) {
      const before = this.edges[row++];
      if (before !== edge && (before?.id !== edge.id || before.a !== edge.a || before.b !== edge.b)) return false;
    }
    return true;
  }

  private rebuild(design: SceneDesign): void {
    this.vertices = [...design.vertices.values()];
    this.vertexRows = new Map(this.vertices.map((vertex, row) => [vertex.id, row]));
    this.at.length = 0;
    this.at.push(...this.vertices.map((vertex) => vertex.at));
    // An edge without one of its ends cannot be drawn: it would be an error of the program that wrote the design.
    this.edges = [...design.edges.values()].filter(
      (edge) => this.vertexRows.has(edge.a) && this.vertexRows.has(edge.b),
    );
    this.edgeRows = new Map(this.edges.map((edge, row) => [edge.id, row]));
    this.ends = this.edges.map((edge) => [this.vertexRows.get(edge.a) ?? 0, this.vertexRows.get(edge.b) ?? 0] as const);
    this.meeting = this.vertices.map(() => []);
    this.ends.forEach(([a, b], row) => {
      this.meeting[a]?.push(row);
      this.meeting[b]?.push(row);
    });
    this.lifted.clear();
  }
}
