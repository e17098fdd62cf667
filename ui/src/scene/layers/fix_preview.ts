/** What a fix would draw and take away. */

import type { Shared } from "../drawing/shading";
import type { Theme } from "../drawing/theme";
import { Tubes } from "../drawing/tubes";
import type { Preview } from "../interface";
import { EDGE_STYLE } from "./design_layer";

export class FixPreview {
  /** Edges that it would take away, by id. */
  removed: ReadonlySet<number> = new Set();
  private readonly tubes: Tubes;

  constructor(uniforms: Shared) {
    this.tubes = new Tubes(uniforms, { ...EDGE_STYLE, radius: 0.9, most: 2.4, dash: 11, flat: true });
  }

  get mesh(): Tubes["mesh"] {
    return this.tubes.mesh;
  }

  show(preview: Preview | null, theme: Theme): void {
    this.removed = preview?.removed ?? new Set();
    this.tubes.show((preview?.edges ?? []).map(([from, to]) => ({ from, to, look: { colour: theme.acted } })));
  }

  paint(theme: Theme): void {
    for (let row = 0; row < this.tubes.count; row += 1) this.tubes.style(row, { colour: theme.acted });
  }

  dispose(): void {
    this.tubes.dispose();
  }
}
