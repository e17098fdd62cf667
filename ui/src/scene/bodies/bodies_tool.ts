/** Choosing and moving bodies of a machine: clicks, the gizmo, and a move that is begun with a key. */

import type { Axis, Vec3 } from "../interface";
import type { Overlay } from "../layers/overlay";
import { handleAt, type MoveHandle } from "../tools/gizmo_parts";
import { Grab, type Surroundings } from "../tools/grab";
import { FREE } from "../tools/move";
import type { Place, ToolHandler } from "../tools/pointer";
import { AXES, along, distance } from "../vec";
import type { BodiesStage } from "./bodies_stage";
import type { BodiesListener } from "./interface";

const NAMES: readonly Axis[] = ["x", "y", "z"];
/** Where a body comes to lie has no more digits than a caliper shows, mm. */
const FINE = 0.001;

export class BodiesTool implements ToolHandler {
  grab: Grab | null = null;
  private pressed: { at: Place; handle: MoveHandle | null; body: number | null } | null = null;
  private last: Place = { x: 0, y: 0, shift: false, ctrl: false, touch: false };

  /** `turn`: the view by so many CSS pixels of a drag. */
  constructor(
    private readonly stage: BodiesStage,
    private readonly listener: BodiesListener,
    private readonly overlay: Overlay,
    private readonly turn: (dx: number, dy: number) => void,
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
    const body = at && !handle ? stage.bodyAt(at.x, at.y) : null;
    stage.hover(body);
    this.overlay.cursor(handle || body !== null ? "pointer" : "default");
    this.overlay.readout(body === null ? null : (stage.machine.bodies[body]?.name ?? null));
  }

  press(at: Place): void {
    this.last = at;
    if (this.grab) return;
    const handle = this.handleAt(at);
    this.pressed = { at, handle, body: handle ? null : this.stage.bodyAt(at.x, at.y) };
  }

  /** What is measured is not moved by a slip: the gizmo moves it, a drag beside that turns the view. */
  drag(at: Place): void {
    const before = this.last;
    this.last = at;
    const { pressed } = this;
    if (this.grab) this.follow();
    else if (pressed?.handle) {
      this.begin(pressed.at, pressed.handle);
      this.follow();
    } else if (pressed) this.turn(at.x - before.x, at.y - before.y);
  }

  release(at: Place, dragged: boolean): void {
    this.last = at;
    const { pressed } = this;
    this.pressed = null;
    if (this.grab) this.drop();
    else if (pressed && !dragged && !pressed.handle) this.listener.chosen(pressed.body);
  }

  double(): void {
    this.stage.frame(true);
  }

  context(): void {
    this.cancel();
  }

  abort(): void {
    this.pressed = null;
    this.cancel();
  }

  /** Keys of the view; whether it took this one. A move takes every key. */
  key(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return this.grab !== null;
    const { grab } = this;
    if (!grab) {
      if (event.key.toLowerCase() === "f") this.stage.frame(true);
      else if (event.key.toLowerCase() === "g" && this.stage.gizmoAt) this.begin(this.last, FREE);
      else return false;
      return true;
    }
    // Tab leaves the view, and what is moved stays where it was.
    if (event.key === "Tab") return !this.cancel();
    const axis = NAMES.find((name) => name === event.key.toLowerCase());
    if (axis) grab.lock(axis, event.shiftKey);
    else if (event.key === "Escape") return this.cancel();
    else if (event.key === "Enter") {
      this.drop();
      return true;
    } else grab.type(event.key);
    this.follow();
    return true;
  }

  /** Gives up a move; whether there was one. */
  cancel(): boolean {
    if (!this.grab) return false;
    this.end();
    this.stage.drag(null);
    this.listener.dragCancelled();
    return true;
  }

  private handleAt({ x, y }: Place): MoveHandle | null {
    const { gizmoAt, projection } = this.stage;
    return gizmoAt && handleAt(projection, gizmoAt, x, y);
  }

  private begin(at: Place, constraint: MoveHandle | typeof FREE): void {
    const { stage } = this;
    const { chosen, chosenBody } = stage;
    if (chosen === null || !chosenBody) return;
    stage.hover(null);
    this.grab = new Grab(new Map([[chosen, chosenBody.at]]), chosenBody.at, at, stage.lengths, constraint);
    this.overlay.cursor("grabbing");
  }

  private follow(): void {
    const { grab, stage } = this;
    if (!grab || stage.chosen === null) return;
    const before = grab.by;
    grab.follow(this.last, this.surroundings, !this.last.ctrl);
    const { axis } = grab;
    const far = stage.camera.orbit.distance * 20;
    const ends = (way: Vec3): { from: Vec3; to: Vec3 } => ({
      from: along(grab.anchor, way, -far),
      to: along(grab.anchor, way, far),
    });
    const colour = stage.theme.axes[axis ? NAMES.indexOf(axis) : 0] ?? stage.theme.edge;
    const { constraint } = grab;
    stage.activate(
      constraint.kind === "view" ? null : constraint,
      axis ? [{ ...ends(AXES[axis]), look: { colour } }] : [],
    );
    this.overlay.readout(grab.readout);
    if (distance(before, grab.by) === 0) return;
    const at = this.placeOf(grab);
    stage.drag(at);
    this.listener.dragging(stage.chosen, at);
  }

  private placeOf(grab: Grab): Vec3 {
    const at = grab.moved[0]?.at ?? grab.anchor;
    return at.map((mm) => Math.round(mm / FINE) / (1 / FINE)) as unknown as Vec3;
  }

  /** Places are whole mm, or twentieths of an inch. */
  private get surroundings(): Surroundings {
    const { projection, lengths } = this.stage;
    const spacing = lengths.mm === 1 ? 1 : lengths.mm / 20;
    return { projection, spacing, target: () => null, grid: () => true };
  }

  private drop(): void {
    const { grab, stage } = this;
    if (!grab) return;
    this.follow();
    const at = this.placeOf(grab);
    const moved = distance(at, grab.anchor) > 0;
    this.end();
    if (moved && stage.chosen !== null) this.listener.dropped(stage.chosen, at);
    else this.listener.dragCancelled();
  }

  private end(): void {
    this.grab = null;
    this.pressed = null;
    this.stage.activate(null);
    this.overlay.readout(null);
    this.overlay.cursor("default");
  }
}
