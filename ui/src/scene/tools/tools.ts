/** The tools of the view of a design, of which one has the pointer and the keys. */

import type { SceneListener, Tool } from "../interface";
import type { Overlay } from "../layers/overlay";
import type { Stage } from "../stage";
import { MeasureTool } from "./measure_tool";
import { PlaneTool } from "./plane_tool";
import { SelectTool } from "./select_tool";
import { TraceTool } from "./trace_tool";

export class Tools {
  readonly select: SelectTool;
  private readonly trace: TraceTool;
  private readonly measure: MeasureTool;
  private readonly plane: PlaneTool;

  constructor(stage: Stage, listener: SceneListener, overlay: Overlay) {
    this.select = new SelectTool(stage, listener, overlay);
    this.trace = new TraceTool(stage, listener, overlay);
    this.measure = new MeasureTool(stage, listener, overlay);
    this.plane = new PlaneTool(stage, listener, overlay);
  }

  named(tool: Tool): SelectTool | TraceTool | MeasureTool | PlaneTool {
    return tool === "draw" ? this.trace : this[tool];
  }

  /** With another tool: what was begun is given up. */
  leave(): void {
    this.select.cancel();
    this.select.hover(null);
    this.trace.leave();
    this.measure.leave();
    this.plane.leave();
  }

  /** Clicks of a strand make something else. */
  drawsChanged(): void {
    this.trace.drawsChanged();
  }

  designChanged(): void {
    this.select.designChanged();
    this.trace.designChanged();
    this.measure.designChanged();
    this.plane.designChanged();
  }

  /** Construction lines have changed, or are shown no more. */
  linesChanged(): void {
    this.select.linesChanged();
    this.trace.linesChanged();
    this.measure.designChanged();
    this.plane.designChanged();
  }
}
