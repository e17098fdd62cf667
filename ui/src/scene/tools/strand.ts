/** A strand: edges that follow each other, a click for each. Pure; the scene draws its rubber band. */

import type { Stroke, Vec3 } from "../interface";
import type { SnapTarget } from "../picking/snap";
import { distance } from "../vec";

/** Where the next edge begins: a vertex or an edge that is there, the end of a construction line, or a place that the first click has chosen and nothing has yet. */
export type StrandEnd =
  | { readonly kind: "vertex"; readonly id: number; readonly at: Vec3 }
  | { readonly kind: "place" | "line"; readonly at: Vec3 }
  | { readonly kind: "edge"; readonly id: number; readonly along: number; readonly at: Vec3 };

/** A click whose place hangs on where its edge begins; null where there is none. */
export type Asked = (from: Vec3) => SnapTarget | null;

/** Clicks nearer than this ask for an edge without length, mm. */
const SAME = 1e-6;

export class Strand {
  end: StrandEnd | null = null;
  /** The click that is being taken ends it. */
  private ending = false;
  /** Clicks are taken in order, each after the stroke of the one before was made. */
  private queue: Promise<void> = Promise.resolve();
  /** Clicks from before the strand was broken off were meant for it, and do not begin another. */
  private generation = 0;

  constructor(
    private readonly stroke: (stroke: Stroke) => Promise<number | null>,
    private readonly line: (from: Vec3, to: Vec3) => Promise<boolean>,
    private readonly changed: () => void,
    private readonly ended: () => void,
  ) {}

  /**
   * Resolves when the click was dealt with; rejects when the stroke could not be made, the strand is over then. `draws`: an edge, or a
   * construction line.
   */
  click(target: SnapTarget | Asked, draws: "edge" | "line" = "edge"): Promise<void> {
    const { generation } = this;
    const done = this.queue.then(async () => {
      if (generation === this.generation) await this.take(target, draws);
    });
    this.queue = done.catch(() => undefined);
    return done;
  }

  /** Whether another edge is to come: what is typed then is of that one. */
  get goesOn(): boolean {
    return this.end !== null && !this.ending;
  }

  /** Ends it; whether there was one. */
  cancel(): boolean {
    const open = this.end !== null;
    this.generation += 1;
    if (open) this.finish();
    return open;
  }

  private async take(asked: SnapTarget | Asked, draws: "edge" | "line"): Promise<void> {
    const { end } = this;
    const target = typeof asked === "function" ? end && asked(end.at) : asked;
    if (!target) return;
    if (!end) {
      this.end = begun(target);
      this.changed();
      return;
    }
    if (distance(end.at, target.at) < SAME || (end.kind === "vertex" && end.id === target.vertex)) return;
    const { generation } = this;
    const ends = draws === "line" ? meets(target) : target.vertex !== undefined || target.edge !== undefined;
    this.ending = ends;
    try {
      if (draws === "line") {
        const made = await this.line(end.at, target.at);
        if (generation !== this.generation) return;
        if (ends) return this.finish();
        if (!made) return void this.cancel();
        this.end = { kind: "line", at: target.at };
        this.changed();
        return;
      }
      let from = end.kind === "vertex" ? end.id : null;
      if (end.kind === "edge" && target.edge !== undefined) {
        from = await this.stroke({
          from: null,
          through: [],
          to: null,
          split: { edge: end.id, at: end.along, end: "from" },
        });
        if (generation !== this.generation) return;
        if (from === null) return void this.cancel();
        this.end = { kind: "vertex", id: from, at: end.at };
      }
      const next = await this.stroke(strokeTo(from === null ? end : { kind: "vertex", id: from, at: end.at }, target));
      if (generation !== this.generation) return;
      if (ends) return this.finish();
      if (next === null) return void this.cancel();
      this.end = { kind: "vertex", id: next, at: target.at };
      this.changed();
    } catch (error) {
      if (generation === this.generation) this.cancel();
      throw error;
    }
  }

  private finish(): void {
    this.end = null;
    this.ending = false;
    this.changed();
    this.ended();
  }
}

function begun({ at, vertex, edge, along }: SnapTarget): StrandEnd {
  if (vertex !== undefined) return { kind: "vertex", id: vertex, at };
  if (edge !== undefined) return { kind: "edge", id: edge, along: along ?? 0.5, at };
  return { kind: "place", at };
}

/** Whether a construction line ends there: at the wire, or at another line. */
function meets({ kind, vertex, edge }: SnapTarget): boolean {
  return vertex !== undefined || edge !== undefined || kind === "construction";
}

function strokeTo(end: StrandEnd, target: SnapTarget): Stroke {
  const through = end.kind === "place" || end.kind === "line" ? [end.at] : [];
  const from = end.kind === "vertex" ? end.id : null;
  if (target.vertex !== undefined) return { from, through, to: target.vertex, split: splitAtEnd(end) };
  if (target.edge !== undefined)
    return { from, through, to: null, split: { edge: target.edge, at: target.along ?? 0.5, end: "to" } };
  return { from, through: [...through, target.at], to: null, split: splitAtEnd(end) };
}

function splitAtEnd(end: StrandEnd): Stroke["split"] {
  return end.kind === "edge" ? { edge: end.id, at: end.along, end: "from" } : null;
}
