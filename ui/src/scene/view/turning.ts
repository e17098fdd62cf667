/** From where the design is seen, and what that view is called. */

import type { DrawingPlane, Tool, Vec3 } from "../interface";
import { normalOf } from "../layers/grid";
import type { Camera } from "./camera";
import { type Flight, flown } from "./flight";
import { facingPlane, looking, lookingFrom, type Orbit, squareness, turned, type ViewName, viewOf } from "./orbit";
import { afterKey } from "./view_keys";

/** A view from anywhere without perspective, beside those of `ViewName`. */
type AnyView = ViewName | "parallel";

/** A view that can be gone back to. */
export interface Seen {
  readonly orbit: Orbit;
  readonly view: AnyView;
}

/** As it is told: "Front". */
const shownName = (view: AnyView): string => (view[0] ?? "").toUpperCase() + view.slice(1);

/** How squarely a plane is seen that need not be turned to: 30° from its edge. */
const FACED = 0.5;
/** Nearer to its edge than 8° a plane that is drawn on cannot be turned. */
const EDGE_ON = 0.14;

/** What is seen from there. */
interface Turned {
  readonly camera: Camera;
  readonly tool: Tool;
  readonly plane: DrawingPlane | null;
  readonly playing: boolean;
  viewMoved(): void;
}

export class Turning {
  private view: AnyView = "perspective";
  /** Where the plane that is drawn on was last seen from well. */
  private upright: Orbit | null = null;
  /** On the way to a view, what it looks like on the way, and what it is called there. */
  private flight: (Flight & { readonly seen: Orbit; readonly view: AnyView }) | null = null;

  /** `named`: hears what the view is called now. */
  constructor(
    private readonly stage: Turned,
    private readonly named: (name: string) => void,
  ) {}

  get seen(): Seen {
    return { orbit: this.stage.camera.orbit, view: this.view };
  }

  look(name: ViewName): void {
    this.goBack({ orbit: looking(this.stage.camera.orbit, name), view: name });
  }

  /** Turns to a side, or to where a direction points, frame by frame or at once. */
  fly(to: ViewName | Vec3, atOnce: boolean): void {
    const { orbit } = this.stage.camera;
    const seen = typeof to === "string" ? { orbit: looking(orbit, to), view: to } : this.seenFrom(to);
    if (atOnce) this.goBack(seen);
    else {
      this.flight = { from: orbit, to: seen.orbit, begun: performance.now(), seen: orbit, view: seen.view };
      this.stage.viewMoved();
    }
  }

  /** Once a frame; whether another is needed. What has turned the view meanwhile ends the flight. */
  advance(now: number): boolean {
    const { flight, stage } = this;
    if (!flight) return false;
    this.flight = null;
    if (stage.camera.orbit !== flight.seen) return false;
    const { orbit, arrived } = flown(flight, now);
    if (arrived) this.goBack({ orbit, view: flight.view });
    else {
      this.flight = { ...flight, seen: orbit };
      stage.camera.orbit = orbit;
      stage.viewMoved();
    }
    return !arrived;
  }

  /** Ends a turn that is under way where it goes. */
  land(): void {
    const { flight } = this;
    this.flight = null;
    if (flight && this.stage.camera.orbit === flight.seen) this.goBack({ orbit: flight.to, view: flight.view });
  }

  /** Turned by hand, as dragging in the view does. */
  turn(dx: number, dy: number): void {
    this.stage.camera.orbit = turned(this.stage.camera.orbit, dx, dy);
    this.moved(true);
  }

  goBack({ orbit, view }: Seen): void {
    this.stage.camera.orbit = orbit;
    this.name(view);
    this.stage.viewMoved();
  }

  /** Turns straight at a plane that is seen from its edge, or nearly so; whether it had to. */
  face(plane: DrawingPlane): boolean {
    const { camera, playing } = this.stage;
    const normal = normalOf(plane);
    if (playing || squareness(camera.orbit, normal) >= FACED) return false;
    const orbit = facingPlane(camera.orbit, normal);
    this.goBack({ orbit, view: viewOf(orbit) ?? "parallel" });
    return true;
  }

  /** From the perspective to the same view without it, and back; from the side of an axis to the perspective. */
  toggleParallel(): void {
    const { orbit } = this.stage.camera;
    if (this.view === "perspective") this.goBack({ orbit: { ...orbit, orthographic: true }, view: "parallel" });
    else if (this.view === "parallel") this.goBack({ orbit: { ...orbit, orthographic: false }, view: "perspective" });
    else this.look("perspective");
  }

  /** Another plane is drawn on, or none. */
  forget(): void {
    this.upright = null;
  }

  /** Turns by a key of the view; whether it was one. */
  byKey(event: KeyboardEvent): boolean {
    const { camera } = this.stage;
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const after = afterKey(camera.orbit, event, camera.height);
    if (!after) return false;
    camera.orbit = after.orbit;
    this.moved(after.turned);
    return true;
  }

  /** The view was moved by hand. */
  moved(turned: boolean): void {
    const { camera, plane, tool, playing } = this.stage;
    if (turned && tool === "draw" && plane && !playing) {
      // Seen from its edge nothing can be drawn on it: the turn ends before.
      if (squareness(camera.orbit, normalOf(plane)) >= EDGE_ON) this.upright = camera.orbit;
      else if (this.upright) camera.orbit = this.upright;
    }
    if (turned && this.view === "parallel") camera.orbit = { ...camera.orbit, orthographic: true };
    else if (turned) this.name("perspective");
    this.stage.viewMoved();
  }

  /** With or without perspective as a turn by hand would have it. */
  private seenFrom(direction: Vec3): Seen {
    const view = this.view === "parallel" ? "parallel" : "perspective";
    return { orbit: { ...lookingFrom(this.stage.camera.orbit, direction), orthographic: view === "parallel" }, view };
  }

  private name(view: AnyView): void {
    if (view === this.view) return;
    this.view = view;
    this.named(shownName(view));
  }
}
