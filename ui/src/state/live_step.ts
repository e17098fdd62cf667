/** How far a machine is in the step that it makes, from where it says that its axes are. */

import type { StepSeconds } from "./clock";
import type { Axes } from "./operator";

/** A step as the machine is told it, and how long its parts take. */
export interface ToldStep {
  readonly told: Axes;
  readonly seconds: StepSeconds;
}

/** A step is over when that is told, and not before. */
const MOST = 0.999;
/** An axis that is so near the end of its way has gone it, and one so near the beginning is at rest: places are rounded to steps of motors. */
const NEAR = 0.005;

/** What was gone of a way, from 0 to 1; of no way, all. */
const part = (gone: number, whole: number): number => (whole === 0 ? 1 : Math.min(Math.max(gone / whole, 0), 1));

/** Follows a machine from step to step. Where its zeros are is its own matter, and of some it changes between wires. */
export class StepWatch {
  private made: number | null = null;
  private step: ToldStep | undefined;
  /** Where feed and head were when the step began, as far as that is known. */
  private from: Axes | null = null;
  /** What was told before. */
  private last: Axes | null = null;
  /** Where the bend axis rests, degrees. */
  private rest = 0;
  /** The farthest that the bend axis has come, in part of its way: below that it is on its way back. */
  private farthest = 0;
  private fraction = 0;

  /** Forgets the wire that it has followed. */
  reset(): void {
    this.made = null;
    this.from = null;
    this.last = null;
    this.rest = 0;
  }

  /** The steps that are made and the part of the next one's time that is over, which does not go back. */
  at(made: number, step: ToldStep | undefined, axes: Axes | null): number {
    if (made !== this.made) this.begin(made, axes);
    this.step = step;
    this.from ??= axes;
    if (!step || !axes || !this.from) return made;
    // Its zero was set anew: nothing draws the wire back so far.
    if (this.last && axes.feed_mm < this.last.feed_mm - Math.max(step.told.feed_mm, 1)) this.from = axes;
    this.last = axes;
    this.fraction = Math.max(this.fraction, Math.min(this.over(step, this.from, axes), MOST));
    return made + this.fraction;
  }

  private begin(made: number, axes: Axes | null): void {
    const { from, step } = this;
    // The end of a step is told when the next one may be under way, and places are told more seldom still: it begins where the one before ends.
    const follows = this.made !== null && made === this.made + 1;
    this.from = follows && from && step ? { feed_mm: from.feed_mm + step.told.feed_mm, rotate_deg: from.rotate_deg + step.told.rotate_deg, bend_deg: 0 } : axes;
    this.made = made;
    this.farthest = 0;
    this.fraction = 0;
  }

  /** Feed, rotate, the peg comes out, the bend axis goes there and comes back, the peg goes in. */
  private over({ told, seconds }: ToldStep, from: Axes, axes: Axes): number {
    const [feed, rotate, bend, wait] = seconds;
    const all = feed + rotate + bend + wait;
    if (!(all > 0)) return 0;
    const fed = part(axes.feed_mm - from.feed_mm, told.feed_mm);
    const turned = part(axes.rotate_deg - from.rotate_deg, told.rotate_deg);
    const isFed = fed >= 1 - NEAR;
    if (!isFed || turned < 1 - NEAR) {
      // Nothing is fed or turned before the bend axis is back.
      if (isFed ? turned > NEAR : fed > NEAR) this.rest = axes.bend_deg;
      return (feed * fed + rotate * (isFed ? turned : 0)) / all;
    }
    const bent = told.bend_deg === 0 ? 0 : part(axes.bend_deg - this.rest, told.bend_deg);
    this.farthest = Math.max(this.farthest, bent);
    const back = bent < this.farthest - NEAR;
    return (feed + rotate + (this.farthest > NEAR ? wait / 2 : 0) + bend * (back ? 1 - bent / 2 : bent / 2)) / all;
  }
}
