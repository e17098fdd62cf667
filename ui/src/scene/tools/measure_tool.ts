/** Measuring between any two things: a click takes the first, what the pointer is on is measured to it, a second click keeps that. */

import type { MeasuredThing, SnapKind } from "../interface";
import type { SnapTarget } from "../picking/snap";
import type { Place } from "./pointer";
import { TakingTool } from "./taking_tool";

interface Taken extends MeasuredThing {
  readonly kind: SnapKind;
  /** Where the pointer has taken it: on an edge that is measured as a whole. */
  readonly at: MeasuredThing["from"];
}

const areSame = (one: MeasuredThing, other: MeasuredThing): boolean =>
  one.from.join() === other.from.join() && one.to.join() === other.to.join();

export class MeasureTool extends TakingTool<Taken> {
  private told = "";

  release(at: Place): void {
    this.last = at;
    const thing = this.pointed();
    const last = this.taken.at(-1);
    // The second click of a double one asks for nothing.
    if (thing && !(last && areSame(last, thing)))
      this.taken = this.taken.length === 1 ? [...this.taken, thing] : [thing];
    this.show();
  }

  /** What the pointer is on. */
  private pointed(): Taken | null {
    const target = this.target("measure");
    return target && { kind: target.kind, at: target.at, ...this.extent(target) };
  }

  /** An edge, a construction line and a side of a stencil are measured as a whole, anything else is a place. */
  private extent({ kind, at, edge, line }: SnapTarget): MeasuredThing {
    const row = kind === "edge" && edge !== undefined ? this.stage.design.edgeRow(edge) : undefined;
    const whole = row === undefined ? line : this.stage.design.segment(row);
    return whole ? { from: whole[0], to: whole[1] } : { from: at, to: at };
  }

  protected show(): void {
    const { stage, taken } = this;
    const pointed = this.pointed();
    const { acted } = stage.theme;
    const shown = [...taken, ...(pointed ? [pointed] : [])];
    const lines = shown
      .filter(({ from, to }) => from !== to)
      .map(({ from, to }) => ({ from, to, look: { colour: acted } }));
    stage.mark("measure", this.signs(shown), lines);
    const [first] = taken;
    const other = taken.length === 1 && first && pointed && !areSame(first, pointed) ? [pointed] : [];
    const things = [...taken, ...other];
    const told = things.map(({ from, to }) => [...from, ...to].join()).join(";");
    if (told !== this.told) this.listener.measuring(things.map(({ from, to }) => ({ from, to })));
    this.told = told;
    this.tellHovered(pointed);
  }
}
