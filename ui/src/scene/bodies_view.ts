/** The view of a machine whose bodies are edited: the second door of the scene. See `BodiesListener` for what it reports. */

import { WebGLRenderer } from "three";
import { BodiesStage } from "./bodies/bodies_stage";
import { BodiesTool } from "./bodies/bodies_tool";
import type { BodiesListener, EditedMachine } from "./bodies/interface";
import { THEMES, type ThemeName } from "./drawing/theme";
import type { LengthFormat, Vec3 } from "./interface";
import { gridText } from "./layers/grid_spacing";
import { Overlay } from "./layers/overlay";
import { Pointer } from "./tools/pointer";
import { Frames } from "./view/frames";
import { turned, type ViewName } from "./view/orbit";
import { ScreenRatio } from "./view/screen_ratio";
import { Turning } from "./view/turning";

export type { BodiesListener, EditedMachine } from "./bodies/interface";

export class BodiesView {
  readonly canvas = document.createElement("canvas");
  private readonly overlay = new Overlay(this.canvas);
  private readonly renderer: WebGLRenderer;
  private readonly stage: BodiesStage;
  private readonly frames: Frames;
  private readonly pointer: Pointer;
  private readonly turning: Turning;
  private readonly tool: BodiesTool;
  private readonly resized: ResizeObserver;
  private readonly stop = new AbortController();
  private readonly ratio: ScreenRatio;
  private framed = false;

  constructor(
    private readonly host: HTMLElement,
    listener: BodiesListener,
    { lengths, label }: { readonly lengths: LengthFormat; readonly label: string },
  ) {
    const { canvas } = this;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: "high-performance" });
    this.ratio = new ScreenRatio(this.renderer, this.stop.signal, () => this.resize());
    this.renderer.autoClear = false;
    this.renderer.info.autoReset = false;
    this.frames = new Frames(
      () => this.pointer.work(),
      () => this.draw(),
    );
    this.stage = new BodiesStage(lengths, () => this.frames.request());
    this.turning = new Turning(this.stage, (name) => listener.viewChanged(name));
    this.tool = new BodiesTool(this.stage, listener, this.overlay, (dx, dy) => {
      this.stage.camera.orbit = turned(this.stage.camera.orbit, dx, dy);
      this.turning.moved(true);
    });
    this.pointer = new Pointer(
      canvas,
      this.stage.camera,
      () => this.tool,
      () => this.frames.schedule(),
      (byHand) => this.turning.moved(byHand),
    );
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application");
    canvas.setAttribute("aria-label", label);
    Object.assign(canvas.style, {
      display: "block",
      width: "100%",
      height: "100%",
      touchAction: "none",
      outlineOffset: "-2px",
    });
    host.append(canvas, this.overlay.element);
    const { signal } = this.stop;
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault(), { signal });
    canvas.addEventListener("webglcontextrestored", () => this.frames.request(), { signal });
    canvas.addEventListener("keydown", (event) => this.key(event), { signal });
    canvas.addEventListener("blur", () => void this.tool.cancel(), { signal });
    this.resized = new ResizeObserver(() => {
      this.resize();
      this.frames.now();
    });
    this.resized.observe(host);
    this.overlay.paint(this.stage.theme);
    this.resize();
  }

  /** A move is given up where the machine is not as it was: what was written comes back the same, maybe during the next move. */
  setMachine(machine: EditedMachine): void {
    if (JSON.stringify(machine) === JSON.stringify(this.stage.machine)) return;
    this.tool.cancel();
    this.stage.show(machine);
    this.frameFirst();
  }

  setChosen(body: number | null, editable: boolean): void {
    if (body !== this.stage.chosen) this.tool.cancel();
    this.stage.editable = editable;
    this.stage.choose(body);
  }

  setTheme(theme: ThemeName): void {
    this.stage.paint(THEMES[theme]);
    this.overlay.paint(THEMES[theme]);
  }

  view(name: ViewName): void {
    this.turning.look(name);
  }

  /** Looks at the chosen body, or at the whole machine. */
  frame(chosen: boolean): void {
    this.stage.frame(chosen);
  }

  /** CSS pixels in the view of a place of the machine. */
  screen(at: Vec3): { x: number; y: number } {
    const { x, y } = this.stage.projection.seen(at);
    return { x, y };
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

  private key(event: KeyboardEvent): void {
    // Escape would close the dialog that the view is in.
    if (this.tool.key(event) || (!this.tool.grab && this.turning.byKey(event))) {
      event.preventDefault();
      event.stopPropagation();
    }
  }

  private draw(): void {
    const { camera } = this.stage;
    if (camera.width < 2 || camera.height < 2 || this.renderer.getContext().isContextLost()) return;
    this.stage.draw(this.renderer);
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

  /** Once there is a machine, and room to see it. */
  private frameFirst(): void {
    if (this.framed || this.stage.machine.bodies.length === 0 || this.stage.camera.width < 2) return;
    this.framed = true;
    this.stage.frame(false);
  }
}
