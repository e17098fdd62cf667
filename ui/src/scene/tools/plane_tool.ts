/** Putting a plane on three points: each click takes one of what is there, and the third puts it. */

import type { Guide } from "../drawing/tubes";
import type { Vec3 } from "../interface";
import type { SnapTarget } from "../picking/snap";
import { cross, distance, length, subtract } from "../vec";
import type { Place } from "./pointer";
import { TakingTool } from "./taking_tool";

/** mm that two points are apart at least. */
const APART = 1e-6;

export class PlaneTool extends TakingTool<SnapTarget> {
  release(at: Place): void {
    this.last = at;
    const target = this.pointed();
    if (target) this.take([...this.taken, target]);
    this.show();
  }

  protected override take(taken: readonly SnapTarget[]): void {
    this.taken = taken.length === 3 ? [] : taken;
    this.listener.planePoints(taken.map(({ at, vertex }) => ({ at, vertex: vertex ?? null })));
  }

  /** What the pointer is on; nothing that is in line with what was taken, which leaves the plane open. */
  private pointed(): SnapTarget | null {
    const target = this.target("plane");
    return target && isOpen(this.taken, target.at) ? target : null;
  }

  protected show(): void {
    const { stage, taken } = this;
    const pointed = this.pointed();
    const points = [...taken, ...(pointed ? [pointed] : [])];
    const { acted } = stage.theme;
    const sides = points.length === 3 ? [...points, ...points.slice(0, 1)] : points;
    const lines = sides.slice(1).map(({ at }, i): Guide => {
      const from = sides[i]?.at ?? at;
      return { from, to: at, look: { colour: acted } };
    });
    stage.mark("plane", this.signs(points), lines);
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
