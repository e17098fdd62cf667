/** The pointer: turning, shifting and zooming the view, and handing the rest to the tool. */

import type { Camera } from "../view/camera";
import { shifted, turned, zoomed } from "../view/orbit";

/** CSS pixels from the upper left corner of the viewport. */
export interface Place {
  readonly x: number;
  readonly y: number;
  readonly shift: boolean;
  readonly ctrl: boolean;
  readonly touch: boolean;
}

/**
 * What a tool does with the left button and the pointer. `hover` comes once a frame at most; so does `drag`, and once more at the
 * first move of a frame.
 */
export interface ToolHandler {
  hover(at: Place | null): void;
  press(at: Place): void;
  /** Once the pointer has gone far enough to mean it. */
  drag(at: Place): void;
  release(at: Place, dragged: boolean): void;
  double(at: Place): void;
  /** Right click without dragging, or the key for it. */
  context(at: Place): void;
  /** The system has taken the pointer away. */
  abort(): void;
}

/** CSS pixels that a hand may tremble. */
const STILL = 4;

type Mode = "tool" | "turn" | "shift";

const areSame = (a: Place, b: Place): boolean => a.x === b.x && a.y === b.y && a.shift === b.shift && a.ctrl === b.ctrl;

export class Pointer {
  private mode: Mode | null = null;
  private pressed: Place | null = null;
  private last: Place | null = null;
  private far = false;
  private waiting: Place | null = null;
  /** Whether a drag has been followed since the last frame: what comes then waits for the next. */
  private followed = false;
  private dragged: Place | null = null;
  /** Of the canvas in the window, while it has the pointer: to ask for it lays the page out anew. */
  private corner: { x: number; y: number } | null = null;
  /** Where it hovers, to look again when the view moves under it. */
  private hovering: Place | null = null;
  private left = false;
  private readonly touches = new Map<number, { x: number; y: number }>();
  private readonly stop = new AbortController();

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly camera: Camera,
    private readonly tool: () => ToolHandler,
    private readonly schedule: () => void,
    private readonly viewMoved: (turned: boolean) => void,
  ) {
    const on = <K extends keyof HTMLElementEventMap>(name: K, heard: (event: HTMLElementEventMap[K]) => void): void => {
      canvas.addEventListener(name, heard, { signal: this.stop.signal, passive: false });
    };
    on("pointerdown", (event) => this.down(event));
    on("pointermove", (event) => this.move(event));
    // Where there is such an event, a move is known by it up to a frame earlier.
    on("pointerrawupdate", (event) => void (event instanceof PointerEvent && this.dragging && this.move(event)));
    on("pointerup", (event) => this.up(event));
    on("pointercancel", (event) => this.aborted(event));
    on("pointerleave", () => this.leave());
    // The middle button would scroll, or paste.
    on("mousedown", (event) => void (event.button === 1 && event.preventDefault()));
    on("wheel", (event) => this.wheel(event));
    on("dblclick", (event) => this.tool().double(this.place(event)));
    on("contextmenu", (event) => this.asked(event));
  }

  /** What came since the last frame. */
  work(): void {
    this.followed = false;
    const at = this.waiting;
    this.waiting = null;
    if (this.left) this.tool().hover(null);
    this.left = false;
    if (!at) return;
    if (this.dragging) this.follow(at);
    else if (this.mode === null) this.tool().hover(at);
  }

  dispose(): void {
    this.stop.abort();
  }

  private down(event: PointerEvent): void {
    if (event.pointerType === "touch") {
      this.touches.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
      if (this.touches.size === 2) {
        if (this.mode === "tool") this.tool().abort();
        this.mode = "shift";
        return;
      }
    }
    if (this.mode !== null) return;
    // Where the pointer continues to be heard outside; there is none to hold for a made-up event.
    if (event.isTrusted) this.canvas.setPointerCapture(event.pointerId);
    this.work();
    const at = this.place(event);
    this.corner = { x: event.clientX - at.x, y: event.clientY - at.y };
    [this.pressed, this.last, this.far, this.dragged] = [at, at, false, null];
    if (event.button === 0 && !event.altKey) {
      this.mode = "tool";
      this.tool().press(at);
    } else {
      this.mode = event.shiftKey ? "shift" : "turn";
    }
  }

  private move(event: PointerEvent): void {
    const at = this.place(event);
    if (this.touches.size === 2 && this.touches.has(event.pointerId)) {
      this.pinch(event);
      return;
    }
    const { pressed, last } = this;
    if (pressed && !this.far) this.far = Math.hypot(at.x - pressed.x, at.y - pressed.y) > STILL;
    if (last && this.far && (this.mode === "turn" || this.mode === "shift")) {
      const [dx, dy] = [at.x - last.x, at.y - last.y];
      const { camera } = this;
      camera.orbit = this.mode === "turn" ? turned(camera.orbit, dx, dy) : shifted(camera.orbit, dx, dy, camera.height);
      this.viewMoved(this.mode === "turn");
    }
    // Before it is far enough nothing has moved: the first move then makes up for it.
    if (this.far || !pressed) this.last = at;
    this.waiting = at;
    this.hovering = at;
    this.schedule();
    // At once: what is asked about it is answered while the frame waits.
    if (!this.dragging || this.followed) return;
    this.work();
    this.followed = true;
  }

  private follow(at: Place): void {
    // The same move, reported a second time.
    if (this.dragged && areSame(this.dragged, at)) return;
    this.dragged = at;
    this.tool().drag(at);
  }

  private get dragging(): boolean {
    return this.mode === "tool" && this.far;
  }

  private up(event: PointerEvent): void {
    this.touches.delete(event.pointerId);
    if (this.mode === null || this.touches.size > 0) return;
    this.work();
    const { mode, far } = this;
    const at = this.place(event);
    this.mode = null;
    this.pressed = null;
    this.corner = null;
    if (mode === "tool") this.tool().release(at, far);
    else if (event.button === 2 && !far) this.tool().context(at);
  }

  private aborted(event: PointerEvent): void {
    this.touches.delete(event.pointerId);
    if (this.mode === "tool") this.tool().abort();
    this.mode = null;
    this.pressed = null;
    this.corner = null;
    this.waiting = null;
  }

  private leave(): void {
    if (this.mode !== null) return;
    this.waiting = null;
    this.hovering = null;
    this.left = true;
    this.schedule();
  }

  /** By the button it comes with the press, of which is not known yet whether it turns the view; by a key there is no press. */
  private asked(event: MouseEvent): void {
    event.preventDefault();
    if (event.button === 2) return;
    const [x, y] = [this.camera.width / 2, this.camera.height / 2];
    this.tool().context({ x, y, shift: false, ctrl: false, touch: false });
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const lines =
      event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 33 : event.deltaMode === WheelEvent.DOM_DELTA_PAGE ? 400 : 1;
    // With Ctrl it is a pinch on a touch pad, which counts finer.
    const factor = Math.exp(Math.max(-240, Math.min(240, event.deltaY * lines)) * (event.ctrlKey ? 0.01 : 0.0016));
    this.zoom(factor, event.offsetX, event.offsetY);
  }

  private pinch(event: PointerEvent): void {
    const other = [...this.touches].find(([id]) => id !== event.pointerId)?.[1];
    const before = this.touches.get(event.pointerId);
    const now = { x: event.offsetX, y: event.offsetY };
    this.touches.set(event.pointerId, now);
    if (!other || !before) return;
    const apart = (at: { x: number; y: number }): number => Math.max(Math.hypot(at.x - other.x, at.y - other.y), 1);
    const { camera } = this;
    camera.orbit = shifted(camera.orbit, (now.x - before.x) / 2, (now.y - before.y) / 2, camera.height);
    this.zoom(apart(before) / apart(now), (now.x + other.x) / 2, (now.y + other.y) / 2);
  }

  private zoom(factor: number, x: number, y: number): void {
    const { camera } = this;
    camera.orbit = zoomed(camera.orbit, factor, x - camera.width / 2, camera.height / 2 - y, camera.height);
    if (this.mode === null) this.waiting ??= this.hovering;
    this.viewMoved(false);
  }

  private place(event: MouseEvent): Place {
    const touch = event instanceof PointerEvent && event.pointerType === "touch";
    const { corner } = this;
    const [x, y] = corner ? [event.clientX - corner.x, event.clientY - corner.y] : [event.offsetX, event.offsetY];
    return { x, y, shift: event.shiftKey, ctrl: event.ctrlKey || event.metaKey, touch };
  }
}
