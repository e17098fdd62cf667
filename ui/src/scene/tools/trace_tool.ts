/** Tracing on a surface and drawing on a plane: where the next click would go is shown before it, and strands grow click by click. */

import { type Sign, SNAP_SHAPES } from "../drawing/symbols";
import type { Guide } from "../drawing/tubes";
import type { DrawingPlane, SceneListener, SnapKind } from "../interface";
import { GROUND } from "../layers/grid";
import type { Overlay } from "../layers/overlay";
import { inDirections, type Line, type SnapTarget, snap } from "../picking/snap";
import type { Stage } from "../stage";
import { distance, middle } from "../vec";
import { ClickTool } from "./click_tool";
import type { Place } from "./pointer";
import { type Asked, Strand } from "./strand";
import { TypedEdge } from "./typed_edge";

/** mm that a place may differ by on its way to the design and back. */
const SAME = 1e-6;

/** Clicks nearer than this are one, CSS pixels. */
const ONE_PLACE = 4;

/** What a flat part can begin and end at, and the plane itself. */
const ON_PLANE: ReadonlySet<SnapKind> = new Set([
  "vertex",
  "construction",
  "edge-middle",
  "edge",
  "angle",
  "grid",
  "plane",
]);

/** What of the design a strand can join. */
const JOINS: ReadonlySet<SnapKind> = new Set(["vertex", "construction", "edge-middle", "edge"]);

export class TraceTool extends ClickTool {
  private readonly strand: Strand;
  private readonly typed = new TypedEdge();
  private reads = false;

  constructor(stage: Stage, listener: SceneListener, overlay: Overlay) {
    super(stage, listener, overlay);
    this.strand = new Strand(
      (stroke) => listener.stroke(stroke),
      (from, to) => listener.line(from, to),
      () => this.show(),
      () => {
        this.typed.clear();
        listener.strandEnded();
      },
    );
  }

  release(at: Place): void {
    this.last = at;
    const target = this.target();
    const { end } = this.strand;
    const seen = [end, target].map((one) => one && this.stage.projection.seen(one.at));
    const apart = seen[0] && seen[1] ? Math.hypot(seen[0].x - seen[1].x, seen[0].y - seen[1].y) : Infinity;
    // The second click of a double one asks for nothing.
    if (apart < ONE_PLACE && target?.vertex === undefined) return;
    this.take(this.edge() ?? target);
  }

  private take(target: SnapTarget | Asked | null): void {
    this.typed.clear();
    // The code that makes the stroke reports why it could not be made; the strand is over then.
    if (target) this.strand.click(target, this.stage.draws).catch(() => undefined);
    this.show();
  }

  key(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const { key } = event;
    if (this.strand.goesOn && key === "Tab") {
      this.typed.other();
      this.show();
      return true;
    }
    if (this.strand.goesOn && this.typed.type(key)) {
      this.show();
      return true;
    }
    if (key !== "Escape" && key !== "Enter") return false;
    if (!this.typed.begun) return this.cancel();
    // Without a way for it to go, a length says nothing yet.
    if (key === "Enter" && this.ending()) this.take(this.edge());
    else if (key === "Escape") this.typed.clear();
    this.show();
    return true;
  }

  /** Ends the strand; whether there was one. */
  cancel(): boolean {
    return this.strand.cancel();
  }

  /** With another tool. */
  leave(): void {
    this.cancel();
    this.last = null;
    this.show();
  }

  /** The strand does not continue from a vertex that was undone. */
  designChanged(): void {
    const { end } = this.strand;
    const { design } = this.stage;
    if (end?.kind === "vertex") {
      const at = design.place(end.id);
      if (at) this.strand.end = { ...end, at };
      else this.cancel();
    } else if (end?.kind === "edge" && design.edgeRow(end.id) === undefined) {
      this.cancel();
    }
    this.show();
  }

  /** Nor from the end of a construction line that was undone. */
  linesChanged(): void {
    const { end } = this.strand;
    const isThere = (line: Line): boolean => line.some((at) => end && distance(at, end.at) < SAME);
    if (end?.kind === "line" && !this.stage.construction.all.some(isThere)) this.cancel();
    this.show();
  }

  /** The edge or construction line that a click makes: another one from now on. */
  drawsChanged(): void {
    this.show();
  }

  /** The edge of the typed length and angle, towards what the pointer is on; at a vertex that is there it ends the strand. */
  private edge(): Asked | null {
    const way = this.pointed();
    const asked = way && this.typed.towards(way.at, this.plane, this.stage.lengths);
    return (
      asked &&
      ((from) => {
        const target = asked(from);
        const there = target && this.stage.design.vertexAt(target.at);
        return there === null || target === null ? target : { ...target, kind: "vertex", vertex: there };
      })
    );
  }

  private get plane(): DrawingPlane {
    return (this.stage.tool === "draw" ? this.stage.plane : null) ?? GROUND;
  }

  /** Where it ends. */
  private ending(): SnapTarget | null {
    const { end } = this.strand;
    return end && (this.edge()?.(end.at) ?? null);
  }

  /** What a click takes. */
  private target(): SnapTarget | null {
    return this.ending() ?? this.pointed();
  }

  /** What the pointer is on. */
  private pointed(): SnapTarget | null {
    const { last, stage } = this;
    if (!last || stage.playing) return null;
    const { end } = this.strand;
    const drawing = stage.tool === "draw";
    // A vertex that the design has not shown yet would be taken for one that is not there.
    const kinds = new Set(
      [...stage.snap.kinds].filter(
        (kind) => (!drawing || ON_PLANE.has(kind)) && (!last.ctrl || kind === "surface" || kind === "plane"),
      ),
    );
    const without = {
      vertices: new Set(end?.kind === "vertex" ? [end.id] : []),
      edges: new Set(end?.kind === "edge" ? [end.id] : []),
    };
    const place = {
      design: stage.design,
      projection: stage.projection,
      stencil: drawing || stage.stencils.empty ? null : stage.stencils,
      construction: stage.pickable.lines,
      plane: stage.plane,
      without,
    };
    // On a surface, and with Ctrl, directions are free until Shift is held; else Shift frees them.
    const kept = kinds.has("angle") && (drawing || place.stencil === null);
    if (!end || kept === last.shift) return snap(place, { ...stage.snap, kinds }, last.x, last.y);
    const joining = new Set([...kinds].filter((kind) => kept && JOINS.has(kind)));
    const there = snap(place, { ...stage.snap, kinds: joining }, last.x, last.y);
    const free = there ?? snap(place, { ...stage.snap, kinds: new Set(["plane"]) }, last.x, last.y);
    if (there || !free) return there;
    const grid = kept && kinds.has("grid") ? stage.snap.grid : null;
    return { kind: "angle", at: inDirections(stage.plane ?? GROUND, end.at, free.at, grid) };
  }

  protected show(): void {
    const { stage } = this;
    const { end } = this.strand;
    const target = this.target();
    const constructs = stage.draws === "line";
    const colour = constructs ? stage.theme.stencil : stage.theme.acted;
    const signs: Sign[] = [];
    const lines: Guide[] = [];
    if (end) signs.push({ at: end.at, shape: "dot", colour, radius: 9 });
    if (target) signs.push({ at: target.at, shape: SNAP_SHAPES[target.kind], colour: stage.theme.acted, radius: 8.5 });
    if (end && target) lines.push({ from: end.at, to: target.at, look: { colour } });
    stage.mark("trace", signs, lines);
    const text = end && target && this.typed.dimensions(end.at, target.at, this.plane, stage.lengths);
    stage.setBand(
      text ? { at: middle([end.at, target.at]), text, verdict: null, beside: [end.at, target.at], first: true } : null,
    );
    this.read(text && this.typed.readout(text, stage.draws));
    this.tellHovered(this.typed.begun ? null : target);
  }

  /** Another tool writes there too, and keeps what it has written. */
  private read(text: string | null): void {
    if (text !== null || this.reads) this.overlay.readout(text);
    this.reads = text !== null;
  }
}
