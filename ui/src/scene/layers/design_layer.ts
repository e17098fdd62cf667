/** The design and what the checks say of it, as balls and tubes. */

import { Group } from "three";
import type { Shared } from "../drawing/shading";
import { type SphereLook, Spheres } from "../drawing/spheres";
import type { Rgb, Theme } from "../drawing/theme";
import { type TubeLook, type TubeStyle, Tubes } from "../drawing/tubes";
import type { SceneMarks, Verdict } from "../interface";
import type { Change, DrawnDesign } from "./drawn_design";

/** Radius in mm, and its limits in CSS pixels. */
export const EDGE_STYLE: TubeStyle = { radius: 0.75, least: 0.95, most: 2.1 };

export const NO_MARKS: SceneMarks = {
  vertices: new Map(),
  edges: new Map(),
  odd: new Set(),
  doubled: new Set(),
  colours: new Map(),
  start: null,
  checked: false,
};

/** CSS pixels from the middle to each of the two lines. */
const DOUBLED_APART = 2.3;

export class DesignLayer {
  readonly group = new Group();
  private readonly spheres: Spheres;
  private readonly tubes: Tubes;
  /** Row of the second line of each doubled edge, by row of the edge. */
  private second = new Map<number, number>();
  private marks: SceneMarks = NO_MARKS;
  private removed: ReadonlySet<number> = new Set();

  constructor(
    uniforms: Shared,
    private theme: Theme,
  ) {
    this.spheres = new Spheres(uniforms, 2.2, 2.8, 5.6);
    this.tubes = new Tubes(uniforms, EDGE_STYLE);
    this.group.add(this.tubes.mesh, this.spheres.mesh);
  }

  /** Draws what has changed: a moved vertex and the edges that meet there, or everything. */
  sync(design: DrawnDesign, { rows }: Change): void {
    if (rows === "all") {
      this.restyle(design);
      return;
    }
    const edges = new Set<number>();
    for (const row of rows) {
      this.spheres.place(row, design.at[row] ?? [0, 0, 0]);
      for (const edge of design.edgesAt(row)) edges.add(edge);
    }
    for (const row of edges) {
      const [from, to] = design.segment(row);
      this.tubes.place(row, from, to);
      const second = this.second.get(row);
      if (second !== undefined) this.tubes.place(second, from, to);
    }
  }

  /** `removed`: edges that a fix would take away, by id. */
  mark(design: DrawnDesign, marks: SceneMarks, removed: ReadonlySet<number>): void {
    this.marks = marks;
    this.removed = removed;
    this.restyle(design);
  }

  paint(design: DrawnDesign, theme: Theme): void {
    this.theme = theme;
    this.restyle(design);
  }

  /** One for each line that an edge is drawn as. */
  looks(id: number): TubeLook[] {
    const { marks, theme } = this;
    // Edges that are fine stay as they are, checked or not: green is for the vertices, and among a hundred green tubes nobody would
    // find the red one.
    const verdict = marks.edges.get(id) ?? "fine";
    const look = {
      colour: verdict === "fine" ? (marks.colours.get(id) ?? theme.edge) : theme[verdict],
      width: WIDTHS[verdict],
      dim: this.removed.has(id) ? 0.72 : 0,
    };
    if (!marks.doubled.has(id)) return [look];
    return [DOUBLED_APART, -DOUBLED_APART].map((offset) => ({ ...look, offset, width: look.width * 0.78 }));
  }

  dispose(): void {
    this.spheres.dispose();
    this.tubes.dispose();
  }

  private restyle(design: DrawnDesign): void {
    this.spheres.count = design.vertices.length;
    design.vertices.forEach(({ id, support }, row) =>
      this.spheres.set(row, design.at[row] ?? [0, 0, 0], this.vertexLook(id, support)),
    );
    this.second.clear();
    const looks = design.edges.map((edge) => this.looks(edge.id));
    this.tubes.count = looks.reduce((sum, lines) => sum + lines.length, 0);
    let free = design.edges.length;
    looks.forEach(([first, second], row) => {
      const [from, to] = design.segment(row);
      if (first) this.tubes.set(row, from, to, first);
      if (!second) return;
      this.second.set(row, free);
      this.tubes.set(free, from, to, second);
      free += 1;
    });
  }

  private vertexLook(id: number, cube: boolean): SphereLook {
    const { marks, theme } = this;
    const odd = marks.odd.has(id);
    const verdict = marks.vertices.get(id) ?? (odd ? "error" : marks.checked ? "fine" : null);
    const colour: Rgb = verdict ? theme[verdict] : theme.vertex;
    return { colour, size: (verdict ? SIZES[verdict] : 1) * (odd ? 1.12 : 1) * (cube ? 1.15 : 1), cube };
  }
}

const WIDTHS: Readonly<Record<Verdict, number>> = { fine: 1, warning: 1.4, error: 1.9 };
const SIZES: Readonly<Record<Verdict, number>> = { fine: 1, warning: 1.25, error: 1.45 };
