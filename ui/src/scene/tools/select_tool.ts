/** Selecting, moving and turning with the pointer: clicks, boxes, drags, the gizmo, and a grab that was begun with a key. */

import { type Sign, SNAP_SHAPES } from "../drawing/symbols";
import type { Axis, SceneListener, Selection, SnapKind, Vec3 } from "../interface";
import { NOTHING_SELECTED } from "../layers/drawn_design";
import type { Overlay } from "../layers/overlay";
import { type Box, type Combine, combine, inBox, touching } from "../picking/box_select";
import { type Picked, pick } from "../picking/picking";
import { snap } from "../picking/snap";
import type { Stage } from "../stage";
import { AXES, along, distance, length } from "../vec";
import { type Handle, handleAt, type MoveHandle, turnAt } from "./gizmo_parts";
import { Grab, type Surroundings } from "./grab";
import { FREE } from "./move";
import type { Place, ToolHandler } from "./pointer";
import { Turn } from "./turn";

/** mm that a place may differ by on its way to the design and back. */
const SAME = 1e-6;
const NAMES: readonly Axis[] = ["x", "y", "z"];

export class SelectTool implements ToolHandler {
  /** What is in the hand: moved, or turned. */
  grab: Grab | Turn | null = null;
  private pressed: { at: Place; picked: Picked | null; handle: Handle | null } | null = null;
  private box: Box | null = null;
  /** The stencil that the grab moves or turns; null where it does that to vertices. */
  private stencil: number | null = null;
  private hovered = "";
  private last: Place = { x: 0, y: 0, shift: false, ctrl: false, touch: false };

  constructor(
    private readonly stage: Stage,
    private readonly listener: SceneListener,
    private readonly overlay: Overlay,
  ) {}

  hover(at: Place | null): void {
    if (at) this.last = at;
    if (this.grab) {
      if (at) this.follow();
      return;
    }
    const { stage } = this;
    const handle = at && this.handleAt(at);
    stage.activate(handle);
    const picked = at && !handle && !stage.playing ? pick(stage.pickable, at.x, at.y, at.touch) : null;
    this.overlay.cursor(handle || picked ? "pointer" : "default");
    this.tellHovered(picked);
  }

  press(at: Place): void {
    this.last = at;
    const { stage } = this;
    if (this.grab || stage.playing) return;
    const handle = this.handleAt(at);
    this.pressed = { at, handle, picked: handle ? null : pick(stage.pickable, at.x, at.y, at.touch) };
  }

  drag(at: Place): void {
    this.last = at;
    const { pressed, stage } = this;
    if (this.grab) {
      this.follow();
      return;
    }
    if (!pressed) return;
    if (!this.box && (pressed.handle || pressed.picked)) {
      if (pressed.picked && !this.isSelected(pressed.picked)) this.choose(only(pressed.picked), pressed.at);
      if (pressed.handle?.kind === "turn") this.beginTurn(pressed.at, pressed.handle.axis);
      else this.begin(pressed.at, pressed.handle ?? FREE, pressed.picked?.at ?? null);
      this.follow();
      return;
    }
    this.box = { x0: pressed.at.x, y0: pressed.at.y, x1: at.x, y1: at.y };
    this.overlay.box(this.box, touching(this.box), stage.theme);
  }

  release(at: Place, dragged: boolean): void {
    this.last = at;
    const { pressed, box, stage } = this;
    this.pressed = null;
    if (this.grab) {
      this.drop();
    } else if (box) {
      this.endBox();
      this.choose(inBox(stage.pickable, { ...box, x1: at.x, y1: at.y }), at);
    } else if (pressed && !dragged && !pressed.handle) {
      const found = pressed.picked ? only(pressed.picked) : NOTHING_SELECTED;
      // A click beside everything with a key held is a slip, not a wish to lose the selection.
      if (pressed.picked || (!at.shift && !at.ctrl)) this.choose(found, at);
    }
  }

  double(at: Place): void {
    const { stage } = this;
    const picked = stage.playing ? null : pick(stage.pickable, at.x, at.y, at.touch);
    if (!picked || picked.kind === "line") return;
    const vertex = picked.kind === "vertex" ? picked.id : stage.design.edges[stage.design.edgeRow(picked.id) ?? -1]?.a;
    if (vertex === undefined) return;
    this.choose({ ...NOTHING_SELECTED, ...stage.design.connected(vertex) }, { ...at, ctrl: false });
  }

  /** What is moved is given up; else what is there is chosen, where it is not part of the selection, and its menu shown. */
  context(at: Place): void {
    if (this.cancel()) return;
    const { stage } = this;
    const picked = stage.playing ? null : pick(stage.pickable, at.x, at.y, at.touch);
    if (picked && !this.isSelected(picked)) this.choose(only(picked), { ...at, shift: false, ctrl: false });
    this.listener.menu({ x: at.x, y: at.y });
  }

  abort(): void {
    this.pressed = null;
    this.cancel();
  }

  /** Moves the selection with the pointer until a click; whether there is one to move. */
  startGrab(): boolean {
    if (this.grab || this.stage.playing || this.stage.gizmoAt === null) return false;
    this.begin(this.last, FREE, null);
    return true;
  }

  lock(axis: Axis | null, plane = false): void {
    const { grab } = this;
    if (grab instanceof Grab) grab.lock(axis, plane);
    else if (axis && grab) {
      grab.lock(axis);
      // From where everything was.
      this.show(grab);
    }
    if (grab) this.follow();
  }

  /**
   * Keys of a grab, and Escape of a box; whether it took this one. A grab takes every key: one that changed the design, such as
   * Delete or undo, would take away what is being moved.
   */
  key(event: KeyboardEvent): boolean {
    const { grab } = this;
    if (this.box && event.key === "Escape") return this.cancel();
    if (!grab) return false;
    if (event.ctrlKey || event.metaKey || event.altKey) return true;
    const axis = NAMES.find((name) => name === event.key.toLowerCase());
    if (axis) this.lock(axis, event.shiftKey);
    else if (event.key === "Escape") return this.cancel();
    else if (event.key === "Enter") this.drop();
    else grab.type(event.key);
    if (this.grab) this.follow();
    return true;
  }

  /** What is being moved is given up where the design has it elsewhere now, or not any more; otherwise it stays in the hand. */
  designChanged(): void {
    const { grab, stage } = this;
    // A stencil stays in the hand whatever becomes of the wire.
    if (!grab || this.stencil !== null) return;
    const stays = [...grab.from].every(([id, from]) => {
      const at = stage.design.place(id);
      return at !== null && distance(at, from) < SAME;
    });
    if (stays) this.showHeld(grab);
    else this.cancel();
  }

  /** The places of construction lines are other ones: they would name others in the hand. */
  linesChanged(): void {
    if (this.lines.length > 0) this.cancel();
  }

  /** Of construction lines that are in the hand. */
  private get lines(): readonly number[] {
    return this.grab && this.stencil === null ? [...this.stage.selected.selection.lines] : [];
  }

  /** Gives up a drag or a box; whether there was one. */
  cancel(): boolean {
    this.pressed = null;
    if (this.box) {
      this.endBox();
      return true;
    }
    if (!this.grab) return false;
    this.end();
    this.giveUp();
    return true;
  }

  /** Everything is shown where the design has it. */
  private giveUp(): void {
    this.stage.holdStencil(null);
    this.stage.holdLines(null);
    this.stage.move([]);
    this.listener.dragCancelled();
  }

  private handleAt({ x, y, touch }: Place): Handle | null {
    const { pickable, gizmoAt, turnsAt, projection } = this.stage;
    const moves = gizmoAt && handleAt(projection, gizmoAt, x, y);
    if (moves) return moves;
    const turns = turnsAt && turnAt(projection, turnsAt, x, y);
    // An arc is long enough to be taken beside a vertex that lies on it.
    return turns && pick(pickable, x, y, touch)?.kind === "vertex" ? null : turns;
  }

  private beginTurn(at: Place, axis: Axis): void {
    const { stage } = this;
    const centre = stage.turnsAt;
    if (!centre) return;
    this.stencil = stage.stencilInHand?.id ?? null;
    this.tellHovered(null);
    const from = this.stencil === null ? stage.design.placesOf(stage.selected.selection) : new Map<number, Vec3>();
    this.grab = new Turn(from, centre, axis, stage.lengths);
    this.grab.follow(at, stage.projection, false);
    this.overlay.cursor("grabbing");
  }

  private begin(at: Place, constraint: MoveHandle | typeof FREE, anchor: Vec3 | null): void {
    const { stage } = this;
    const { design, projection } = stage;
    const chosen = stage.stencilInHand;
    this.stencil = chosen?.id ?? null;
    const from = chosen ? new Map([[chosen.id, chosen.middle] as const]) : design.placesOf(stage.selected.selection);
    // The vertex, or end of a line, nearest to where the drag began is the one that snaps.
    const off = (place: Vec3): number => {
      const seen = projection.seen(place);
      return Math.hypot(seen.x - at.x, seen.y - at.y);
    };
    const ends = chosen ? [] : stage.construction.endsOf(stage.selected.selection);
    const near = [...from.values(), ...ends].toSorted((a, b) =>
      anchor ? distance(a, anchor) - distance(b, anchor) : off(a) - off(b),
    )[0];
    if (!near) return;
    this.tellHovered(null);
    this.grab = new Grab(from, near, at, stage.lengths, constraint);
    this.overlay.cursor("grabbing");
  }

  private follow(): void {
    const { grab } = this;
    if (grab instanceof Turn) this.followTurn(grab);
    else if (grab) this.followMove(grab);
  }

  private followTurn(turn: Turn): void {
    const { stage } = this;
    const before = turn.deg;
    turn.follow(this.last, stage.projection, !this.last.ctrl);
    this.guide(turn.axis, turn.centre, []);
    stage.activate({ kind: "turn", axis: turn.axis });
    this.overlay.readout(turn.readout);
    if (turn.deg !== before) this.show(turn);
  }

  /** Shows what is in the hand where that has it now. */
  private show(grab: Grab | Turn): void {
    if (this.stencil !== null) this.stage.holdStencil((place) => grab.goes(place));
    else {
      this.showHeld(grab);
      if (grab.from.size > 0) this.listener.dragging(grab.moved);
    }
  }

  private showHeld(grab: Grab | Turn): void {
    this.stage.move(grab.moved);
    this.stage.holdLines((place) => grab.goes(place));
  }

  /** The line of an axis through a place, with signs. */
  private guide(axis: Axis | null, through: Vec3, signs: readonly Sign[]): void {
    const { stage } = this;
    const reach = stage.camera.orbit.distance * 20;
    const line = (name: Axis) => ({
      from: along(through, AXES[name], -reach),
      to: along(through, AXES[name], reach),
      look: { colour: stage.theme.axes[NAMES.indexOf(name)] ?? stage.theme.edge },
    });
    stage.mark("grab", signs, axis ? [line(axis)] : []);
  }

  private followMove(grab: Grab): void {
    const { stage } = this;
    const before = grab.by;
    const signs: Sign[] = [];
    grab.follow(this.last, this.surroundings(grab, signs), !this.last.ctrl);
    this.guide(grab.axis, grab.anchor, signs);
    stage.activate(grab.constraint.kind === "view" ? null : grab.constraint);
    this.overlay.readout(grab.readout);
    if (distance(before, grab.by) > 0) this.show(grab);
  }

  private surroundings(grab: Grab, signs: Sign[]): Surroundings {
    const { stage } = this;
    const { design, projection } = stage;
    const kinds = new Set<SnapKind>([...stage.snap.kinds].filter((kind) => kind !== "grid" && kind !== "plane"));
    const settings = { ...stage.snap, kinds };
    const moving = this.stencil === null ? grab.from.keys() : [];
    const without = { vertices: new Set(moving), edges: new Set<number>() };
    // A stencil that is moved would snap to itself.
    const stencil = stage.stencils.empty || this.stencil !== null ? null : stage.stencils;
    const construction = stage.construction.without(
      this.stencil === null ? stage.selected.selection : NOTHING_SELECTED,
    );
    const show = (kind: SnapKind, at: Vec3): void =>
      void signs.push({ at, shape: SNAP_SHAPES[kind], colour: stage.theme.acted, radius: 8 });
    return {
      projection,
      spacing: stage.snap.grid,
      target: (x, y) => {
        const found =
          kinds.size > 0
            ? snap({ design, projection, stencil, construction, plane: null, without }, settings, x, y)
            : null;
        if (found) show(found.kind, found.at);
        return found?.at ?? null;
      },
      grid: (at, rounded) => {
        if (!stage.snap.kinds.has("grid")) return false;
        const [a, b] = [projection.seen(at), projection.seen(rounded)];
        const near = !stage.snap.kinds.has("plane") || Math.hypot(a.x - b.x, a.y - b.y) <= stage.snap.reach;
        if (near) show("grid", rounded);
        return near;
      },
    };
  }

  private drop(): void {
    const { grab } = this;
    if (!grab) return;
    this.follow();
    // Enter may come while the button is still held: what it holds is not taken up once more.
    this.pressed = null;
    const { stencil, lines } = this;
    this.end();
    if (grab instanceof Turn && grab.deg % 360 === 0) this.giveUp();
    else if (stencil !== null) {
      const { listener } = this;
      const placed =
        grab instanceof Turn
          ? listener.stencilTurned(stencil, grab.axis, grab.deg)
          : listener.stencilMoved(stencil, grab.by);
      // It may be in the hand again by then.
      void placed.finally(() => this.stencil === null && this.stage.holdStencil(null));
    } else if (grab instanceof Turn) {
      this.listener.turned([...grab.from.keys()], lines, grab.axis, grab.centre, grab.deg);
    } else if (length(grab.by) > 0) this.listener.dropped(grab.moved, lines, grab.by);
    else this.listener.dragCancelled();
  }

  private end(): void {
    this.grab = null;
    this.stencil = null;
    this.stage.mark("grab", []);
    this.stage.activate(null);
    this.overlay.readout(null);
    this.overlay.cursor("default");
  }

  private endBox(): void {
    this.box = null;
    this.overlay.box(null, false, this.stage.theme);
  }

  private choose(found: Selection, at: Place): void {
    const how: Combine = at.shift ? "add" : at.ctrl ? "toggle" : "replace";
    const selection = combine(this.stage.selected.selection, found, how);
    this.stage.select(selection);
    this.listener.selected(selection);
  }

  private isSelected({ kind, id }: Picked): boolean {
    return this.stage.selected.selection[LISTS[kind]].has(id);
  }

  private tellHovered(picked: Picked | null): void {
    const key = picked ? `${picked.kind} ${picked.id}` : "";
    if (key === this.hovered) return;
    this.hovered = key;
    this.stage.point("hovered", picked ? only(picked) : NOTHING_SELECTED);
    const seen = picked && this.stage.projection.seen(picked.at);
    this.listener.hovered(picked && seen ? { kind: picked.kind, id: picked.id, x: seen.x, y: seen.y } : null);
  }
}

/** Where a selection has what was picked. */
const LISTS = { vertex: "vertices", edge: "edges", line: "lines" } as const;

function only({ kind, id }: Picked): Selection {
  return { ...NOTHING_SELECTED, [LISTS[kind]]: new Set([id]) };
}
