/** The view of a design: what the editor's panels call. See `interface.ts` for what it reports. */

import { WebGLRenderer } from "three";
import { THEMES, type ThemeName } from "./drawing/theme";
import type {
  Axis,
  ChosenStencil,
  DrawingPlane,
  LengthFormat,
  Played,
  PlayedBall,
  Preview,
  SceneBall,
  SceneDesign,
  SceneDimensions,
  SceneHeld,
  SceneLabel,
  SceneListener,
  SceneMarks,
  SceneStencil,
  SceneStruts,
  Selection,
  Shown,
  SnapSettings,
  Tool,
  Touch,
  Vec3,
} from "./interface";
import { gridText } from "./layers/grid_spacing";
import { Overlay } from "./layers/overlay";
import { Stage } from "./stage";
import { Pointer, type ToolHandler } from "./tools/pointer";
import { Tools } from "./tools/tools";
import { Frames } from "./view/frames";
import { axes, type ViewName } from "./view/orbit";
import { ScreenRatio } from "./view/screen_ratio";
import { type Seen, Turning } from "./view/turning";

export interface ViewportOptions {
  readonly lengths: LengthFormat;
  /** Smooth edges; without a graphics card they cost most of the time. */
  readonly antialias?: boolean;
  /** What the view is called for a screen reader. */
  readonly label?: string;
}

export class Viewport {
  readonly canvas = document.createElement("canvas");
  private readonly overlay = new Overlay(this.canvas);
  private readonly renderer: WebGLRenderer;
  private readonly stage: Stage;
  private readonly frames: Frames;
  private readonly pointer: Pointer;
  private readonly turning: Turning;
  private readonly tools: Tools;
  private readonly resized: ResizeObserver;
  private readonly stop = new AbortController();
  private framed = false;
  private readonly ratio: ScreenRatio;
  private beforePlay: Seen | null = null;
  /** The direction that the listener was told last. */
  private told: { readonly yaw: number; readonly pitch: number } | null = null;

  constructor(
    private readonly host: HTMLElement,
    private readonly listener: SceneListener,
    options: ViewportOptions,
  ) {
    const { canvas } = this;
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: options.antialias ?? true,
      powerPreference: "high-performance",
    });
    this.ratio = new ScreenRatio(this.renderer, this.stop.signal, () => this.resize());
    this.renderer.autoClear = false;
    this.renderer.info.autoReset = false;
    this.frames = new Frames(
      () => {
        this.pointer.work();
        if (this.turning.advance(performance.now())) this.frames.request();
      },
      () => this.draw(),
    );
    this.stage = new Stage(this.overlay.element, options.lengths, () => this.frames.request());
    this.turning = new Turning(this.stage, (name) => listener.viewChanged(name));
    this.tools = new Tools(this.stage, listener, this.overlay);
    this.pointer = new Pointer(
      canvas,
      this.stage.camera,
      () => this.handler,
      () => this.frames.schedule(),
      (turned) => this.turning.moved(turned),
    );
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application");
    canvas.setAttribute("aria-label", options.label ?? "View of the design");
    Object.assign(canvas.style, {
      display: "block",
      width: "100%",
      height: "100%",
      touchAction: "none",
      outlineOffset: "-2px",
    });
    if (getComputedStyle(host).position === "static") host.style.position = "relative";
    host.append(canvas, this.overlay.element);
    const { signal } = this.stop;
    // Restored by three.js itself, which needs the event not to end there.
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault(), { signal });
    canvas.addEventListener("keydown", (event) => this.turnByKey(event), { signal });
    canvas.addEventListener("webglcontextrestored", () => this.frames.request(), { signal });
    this.resized = new ResizeObserver(() => {
      this.resize();
      // A canvas that gets another size is empty: it would flicker if the picture came with the next frame.
      this.frames.now();
    });
    this.resized.observe(host);
    this.overlay.paint(this.stage.theme);
    this.resize();
  }

  /** All of the design, whenever any of it has changed: what is the same object is not drawn again. Ends what a drop has left shown. */
  setDesign(design: SceneDesign): void {
    this.stage.setDesign(design);
    this.tools.designChanged();
    this.frameFirst();
  }

  setMarks(marks: SceneMarks): void {
    this.stage.setMarks(marks);
  }

  setSelection(selection: Selection): void {
    this.stage.select(selection);
  }

  /** Pointed at elsewhere: hovered or focused in a list. */
  setHighlight(highlight: Selection): void {
    this.stage.point("highlight", highlight);
  }

  setPreview(preview: Preview | null): void {
    this.stage.setPreview(preview);
  }

  /** Struts instead of the edges of the design; null shows those again. */
  setStruts(struts: SceneStruts | null): void {
    this.stage.setStruts(struts);
  }

  /** Balls within which vertices come out; none shows none. */
  setSpread(balls: readonly SceneBall[]): void {
    this.stage.spread.show(balls);
    this.frames.request();
  }

  /** By how much the displacements of struts are enlarged: 1 is true scale. */
  setStrutScale(scale: number): void {
    this.stage.enlarge(scale);
  }

  setHeld(held: SceneHeld): void {
    this.stage.hold(held);
  }

  setStencils(stencils: readonly SceneStencil[]): void {
    this.stage.setStencils(stencils);
    this.frameFirst();
  }

  /** Lines that are no wire, each by its two ends. */
  setConstruction(lines: readonly (readonly [Vec3, Vec3])[]): void {
    if (this.stage.setConstruction(lines)) this.tools.linesChanged();
    this.frameFirst();
  }

  /** Marks a stencil; it moves with the gizmo where nothing is selected. */
  setChosenStencil(chosen: ChosenStencil | null): void {
    this.stage.chooseStencil(chosen);
  }

  /** `opacity` from 0 to 1; `offset`: how far off their surfaces a click places vertices, mm. */
  setStencilsShown(shown: boolean, opacity: number, offset: number): void {
    this.stage.stencils.group.visible = shown;
    this.stage.stencils.opacity = opacity;
    this.stage.stencils.offset = offset;
    this.frames.request();
  }

  setTool(tool: Tool): void {
    if (tool === this.stage.tool) return;
    this.tools.leave();
    this.stage.tool = tool;
    this.turning.forget();
    this.overlay.cursor(tool === "select" ? "default" : "crosshair");
    this.frames.request();
  }

  /** Whether strands are edges or construction lines. */
  setDraws(draws: "edge" | "line"): void {
    this.stage.draws = draws;
    this.tools.drawsChanged();
  }

  setSnap(snap: SnapSettings): void {
    this.stage.snap = snap;
    this.frames.request();
  }

  /** Null for the ground. */
  setPlane(plane: DrawingPlane | null): void {
    this.stage.plane = plane;
    this.turning.forget();
    this.frames.request();
  }

  /** None switches them off. */
  setLabels(labels: readonly SceneLabel[]): void {
    this.stage.setLabels(labels);
  }

  setDimensions(dimensions: SceneDimensions): void {
    this.stage.setDimensions(dimensions);
  }

  setTheme(theme: ThemeName): void {
    this.stage.paint(THEMES[theme]);
    this.overlay.paint(THEMES[theme]);
    this.frames.request();
  }

  setLengths(lengths: LengthFormat): void {
    this.stage.setLengths(lengths);
  }

  /** Locks what is being moved to an axis; the same again, or null, frees it. */
  lockAxis(axis: Axis | null): void {
    this.tools.select.lock(axis);
  }

  /** Moves the selection with the pointer until a click; whether there is a selection to move. */
  startGrab(): boolean {
    return this.stage.tool === "select" && this.tools.select.startGrab();
  }

  /** While something is moved or a strand is open, its keys; whether this was one. Call it before the editor's own keys. */
  handleKey(event: KeyboardEvent): boolean {
    return this.tool.key(event);
  }

  /** Ends a strand, gives up a drag or a box; whether there was one. */
  cancel(): boolean {
    return this.tool.cancel();
  }

  view(name: ViewName): void {
    this.turning.look(name);
  }

  /** Turns to a side, or to where a direction points, so that it is seen how; at once for a person who wants no motion. */
  fly(to: ViewName | Vec3): void {
    this.turning.fly(to, matchMedia("(prefers-reduced-motion: reduce)").matches);
  }

  /** Turns by a drag of so many CSS pixels, as one with the right button does. */
  turn(dx: number, dy: number): void {
    this.turning.turn(dx, dy);
  }

  /** Turns straight at a plane that is seen from its edge, or nearly so; whether it had to. */
  face(plane: DrawingPlane): boolean {
    return this.turning.face(plane);
  }

  /** From the perspective to the same view without it, and back; from the side of an axis to the perspective. */
  toggleParallel(): void {
    this.turning.toggleParallel();
  }

  /** Looks at these, or at everything. */
  frame(selection?: Selection): void {
    this.framed = true;
    this.turning.land();
    this.stage.frame(selection ?? null);
  }

  /** Shows a wire on its machine instead of the design; null goes back to the view before. */
  play(played: Played | null): void {
    const { playback } = this.stage;
    const begins = played !== null && !this.stage.playing;
    const ends = played === null && this.stage.playing;
    if (begins) {
      this.cancel();
      this.tools.select.hover(null);
      this.beforePlay = this.turning.seen;
    }
    playback.play(played);
    this.stage.bound();
    if (begins) {
      this.turning.look("perspective");
      this.stage.frame(null);
    }
    if (ends && this.beforePlay) this.turning.goBack(this.beforePlay);
    this.frames.request();
  }

  /** Step with its fraction, from 0 to the number of steps. The clock is the caller's. */
  setTime(step: number, shown: Shown): void {
    this.stage.playback.setTime(step, shown);
    this.frames.request();
  }

  /** So many steps of what is played were really done; null or 0 for none. */
  setProgress(steps: number | null): void {
    this.stage.playback.setProgress(steps ?? 0);
    this.frames.request();
  }

  /** What touches what where it is played, drawn red. */
  setTouches(touches: readonly Touch[]): void {
    this.stage.playback.setTouches(touches);
    this.frames.request();
  }

  /** Balls around places of the wire that is played, in its order. */
  setPlayedSpread(balls: readonly PlayedBall[]): void {
    this.stage.playback.setSpread(balls);
    this.frames.request();
  }

  /** CSS pixels in the viewport of a place of the design; null where it is behind the eye. */
  screen(at: readonly [number, number, number]): { x: number; y: number } | null {
    const seen = this.stage.projection.seen(at);
    return this.stage.projection.sees(seen) ? { x: seen.x, y: seen.y } : null;
  }

  /** The parts of segments that are in front of the eye, as `screen`, and the middle of the gizmo, mm; null where it is not shown. */
  get seen() {
    return { segment: (a: Vec3, b: Vec3) => this.stage.projection.segment(a, b), gizmo: this.stage.gizmoAt };
  }

  dispose(): void {
    this.stop.abort();
    this.resized.disconnect();
    this.pointer.dispose();
    this.frames.dispose();
    this.stage.dispose();
    this.renderer.dispose();
    // A window has few contexts: without this it is kept until the canvas is collected.
    this.renderer.forceContextLoss();
    this.canvas.remove();
    this.overlay.element.remove();
  }

  private get handler(): ToolHandler {
    return this.stage.playing ? this.tools.select : this.tool;
  }

  private get tool(): ReturnType<Tools["named"]> {
    return this.tools.named(this.stage.tool);
  }

  private draw(): void {
    if (this.stage.camera.width < 2 || this.stage.camera.height < 2 || this.renderer.getContext().isContextLost())
      return;
    this.stage.draw(this.renderer);
    const { yaw, pitch } = this.stage.camera.orbit;
    if (this.told?.yaw !== yaw || this.told.pitch !== pitch) {
      this.told = { yaw, pitch };
      this.listener.viewTurned(axes(this.stage.camera.orbit));
    }
    this.overlay.grid(gridText(this.stage.spacing, this.stage.lengths));
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    const { camera } = this.stage;
    [camera.width, camera.height] = [clientWidth, clientHeight];
    this.ratio.follow();
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.stage.viewMoved();
    this.frameFirst();
  }

  /** The first thing there is to see, once there is room to see it. */
  private frameFirst(): void {
    if (this.framed || this.stage.empty || this.stage.camera.width < 2) return;
    this.frame();
  }

  /** Keys of the view alone, which count while it has the focus; to what is in the hand they are digits and signs. */
  private turnByKey(event: KeyboardEvent): void {
    if (!this.tools.select.grab && this.turning.byKey(event)) event.preventDefault();
  }
}
