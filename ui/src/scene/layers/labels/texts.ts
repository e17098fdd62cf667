/** What is written over the picture: what the checks say of places, dimensions, and what belongs to the edge that is being drawn. */

import type { Theme } from "../../drawing/theme";
import type { LengthFormat, SceneLabel } from "../../interface";
import type { Projection } from "../../view/projection";
import type { DrawnDesign } from "../drawn_design";
import { dimensionLabels, NO_DIMENSIONS } from "./dimensions";
import { Labels } from "./labels";

export class Texts {
  findings: readonly SceneLabel[] = [];
  dimensions = NO_DIMENSIONS;
  /** Beside the edge that is being drawn. */
  band: SceneLabel | null = null;
  private readonly labels: Labels;

  constructor(overlay: HTMLElement, theme: Theme) {
    this.labels = new Labels(overlay, theme);
  }

  show(design: DrawnDesign, lengths: LengthFormat): void {
    const dimensions = dimensionLabels(design, this.dimensions, lengths);
    this.labels.show([...(this.band ? [this.band] : []), ...this.findings, ...dimensions]);
  }

  place(projection: Projection, shown: boolean): void {
    this.labels.place(projection, shown);
  }

  paint(theme: Theme): void {
    this.labels.paint(theme);
  }

  dispose(): void {
    this.labels.show([]);
  }
}
