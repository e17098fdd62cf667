/** A tool whose clicks take one after the other of what is there. */

import { type Sign, SNAP_SHAPES } from "../drawing/symbols";
import type { SnapTarget } from "../picking/snap";
import { ClickTool } from "./click_tool";
import { there } from "./there";

export abstract class TakingTool<Taken extends Pick<SnapTarget, "kind" | "at">> extends ClickTool {
  protected taken: readonly Taken[] = [];

  key(event: KeyboardEvent): boolean {
    return event.key === "Escape" && this.cancel();
  }

  cancel(): boolean {
    const had = this.taken.length > 0;
    if (had) this.take([]);
    this.show();
    return had;
  }

  /** With another tool. */
  leave(): void {
    this.last = null;
    this.cancel();
  }

  /** What was taken may be elsewhere, or gone. */
  designChanged(): void {
    this.cancel();
  }

  protected take(taken: readonly Taken[]): void {
    this.taken = taken;
  }

  /** What the pointer is on while this is the tool. */
  protected target(tool: "measure" | "plane"): SnapTarget | null {
    const { last, stage } = this;
    return last && !stage.playing && stage.tool === tool ? there(stage, last.x, last.y) : null;
  }

  /** Signs of what was taken and of what the pointer is on. */
  protected signs(things: readonly Taken[]): Sign[] {
    const { acted } = this.stage.theme;
    return things.map(({ kind, at }) => ({ at, shape: SNAP_SHAPES[kind], colour: acted, radius: 8.5 }));
  }
}
