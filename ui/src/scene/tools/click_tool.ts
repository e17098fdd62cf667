/** What tools share that take a place at each click: the pointer shows beforehand what the next one takes. */

import type { SceneListener, SnapKind, Vec3 } from "../interface";
import type { Overlay } from "../layers/overlay";
import type { Stage } from "../stage";
import type { Place, ToolHandler } from "./pointer";

export abstract class ClickTool implements ToolHandler {
  /** Where the pointer is; null outside of the view. */
  protected last: Place | null = null;
  private hovered = "";

  constructor(
    protected readonly stage: Stage,
    protected readonly listener: SceneListener,
    protected readonly overlay: Overlay,
  ) {}

  abstract release(at: Place): void;
  abstract key(event: KeyboardEvent): boolean;
  /** Forgets what was begun; whether there was something. */
  abstract cancel(): boolean;
  /** Draws what was taken, and what the next click would take. */
  protected abstract show(): void;

  hover(at: Place | null): void {
    this.last = at;
    this.overlay.cursor("crosshair");
    this.show();
  }

  press(at: Place): void {
    this.hover(at);
  }

  drag(at: Place): void {
    this.hover(at);
  }

  double(): void {
    // Each of its clicks was taken already.
  }

  context(at: Place): void {
    if (!this.cancel()) this.listener.menu({ x: at.x, y: at.y });
  }

  abort(): void {
    this.last = null;
    this.show();
  }

  /** Tells what the pointer is on, once for each place. */
  protected tellHovered(place: { readonly kind: SnapKind; readonly at: Vec3 } | null): void {
    const key = place ? `${place.kind} ${place.at.join()}` : "";
    if (key === this.hovered) return;
    this.hovered = key;
    const seen = place && this.stage.projection.seen(place.at);
    this.listener.hovered(
      place && seen ? { kind: "snap", snap: place.kind, at: place.at, x: seen.x, y: seen.y } : null,
    );
  }
}
