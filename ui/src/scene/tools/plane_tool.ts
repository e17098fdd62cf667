/** Putting a plane on three points: each click takes one of what is there, and the third puts it. */

import { type Sign, SNAP_SHAPES } from "../drawing/symbols";
import type { Guide } from "../drawing/tubes";
import type { Vec3 } from "../interface";
import type { SnapTarget } from "../picking/snap";
import { cross, distance, length, subtract } from "../vec";
import { ClickTool } from "./click_tool";
import type { Place } from "./pointer";
import { there } from "./there";

/** mm that two points are apart at least. */
const APART = 1e-6;

export class PlaneTool extends ClickTool {
  private taken: readonly SnapTarget[] = [];

  release(at: Place): void {
    this.last = at;
    const target = this.pointed();
    if (target) this.take([...this.taken, target]);
    this.show();
  }

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

  private take(taken: readonly SnapTarget[]): void {
    this.taken = taken.length === 3 ? [] : taken;
    this.listener.planePoints(taken.map(({ at, vertex }) => ({ at, vertex: vertex ?? null })));
  }

  /** What the pointer is on; nothing that is in line with what was taken, which leaves the plane open. */
  private pointed(): SnapTarget | null {
    const { last, stage, taken } = this;
    if (!last || stage.playing || stage.tool !== "plane") return null;
    const target = there(stage, last.x, last.y);
    return target && isOpen(taken, target.at) ? target : null;
  }

  protected show(): void {
    const { stage, taken } = this;
    const pointed = this.pointed();
    const points = [...taken, ...(pointed ? [pointed] : [])];
    const { acted } = stage.theme;
    const signs = points.map(({ kind, at }): Sign => ({ at, shape: SNAP_SHAPES[kind], colour: acted, radius: 8.5 }));
    const sides = points.length === 3 ? [...points, ...points.slice(0, 1)] : points;
    const lines = sides.slice(1).map(({ at }, i): Guide => {
      const from = sides[i]?.at ?? at;
      return { from, to: at, look: { colour: acted } };
    });
    stage.mark("plane", signs, lines);
    this.tellHovered(pointed);
  }
}

/** Whether a place is none of those that were taken, and not in line with two. */
function isOpen(taken: readonly SnapTarget[], place: Vec3): boolean {
  if (taken.some(({ at }) => distance(at, place) < APART)) return false;
  const [first, second] = taken;
  if (!first || !second) return true;
  const way = subtract(second.at, first.at);
  return length(cross(way, subtract(place, first.at))) > APART * length(way);
}
