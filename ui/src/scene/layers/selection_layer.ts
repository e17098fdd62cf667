/** What is selected, under the pointer, or pointed at from a list: outlines around edges, rings around vertices. */

import type { Shared } from "../drawing/shading";
import type { Sign } from "../drawing/symbols";
import type { Rgb, Theme } from "../drawing/theme";
import { Tubes } from "../drawing/tubes";
import type { SceneMarks, Selection } from "../interface";
import { subtract } from "../vec";
import type { DesignLayer } from "./design_layer";
import { EDGE_STYLE } from "./design_layer";
import { type DrawnDesign, NOTHING_SELECTED } from "./drawn_design";

/** CSS pixels. */
const RING = 9;
const HOVER_RING = 11;

export class SelectionLayer {
  readonly outlines: Tubes;
  selection: Selection = NOTHING_SELECTED;
  /** By the panel, or by the pointer. */
  highlight: Selection = NOTHING_SELECTED;
  hovered: Selection = NOTHING_SELECTED;

  constructor(uniforms: Shared) {
    this.outlines = new Tubes(uniforms, { ...EDGE_STYLE, outline: 2.2, flat: true });
  }

  /** Outlines are made anew, which is as quick as finding those that changed. */
  sync(design: DrawnDesign, layer: DesignLayer, theme: Theme): void {
    const wanted = new Map<number, Rgb>();
    for (const id of this.highlight.edges) wanted.set(id, theme.acted);
    for (const id of this.selection.edges) wanted.set(id, theme.selected);
    for (const id of this.hovered.edges) if (!this.selection.edges.has(id)) wanted.set(id, theme.hovered);
    const rows = [...wanted].flatMap(([id, colour]) => {
      const row = design.edgeRow(id);
      return row === undefined ? [] : layer.looks(id).map((look) => ({ row, look: { ...look, colour } }));
    });
    this.outlines.count = rows.length;
    rows.forEach(({ row, look }, at) => this.outlines.set(at, ...design.segment(row), look));
  }

  signs(design: DrawnDesign, start: SceneMarks["start"], theme: Theme): Sign[] {
    const ring = (ids: Iterable<number>, colour: Rgb, radius: number): Sign[] =>
      [...ids].flatMap((id) => {
        const at = design.place(id);
        return at ? [{ at, shape: "ring", colour, radius } satisfies Sign] : [];
      });
    const signs = [
      ...ring(this.highlight.vertices, theme.acted, HOVER_RING),
      ...ring(this.selection.vertices, theme.selected, RING),
      ...ring(
        [...this.hovered.vertices].filter((id) => !this.selection.vertices.has(id)),
        theme.hovered,
        RING,
      ),
    ];
    const [from, to] = start ? [design.place(start.vertex), design.place(start.towards)] : [null, null];
    if (from && to)
      signs.push({ at: from, shape: "arrow", colour: theme.acted, radius: 10, towards: subtract(to, from), off: 19 });
    return signs;
  }

  dispose(): void {
    this.outlines.dispose();
  }
}
