/** What is in the picture while the bodies of a machine are edited: the machine at its reference, the wire through it, the gizmo. */

import { Scene, type WebGLRenderer } from "three";
import { paintPicture } from "../drawing/painting";
import { paint, shared } from "../drawing/shading";
import { Symbols } from "../drawing/symbols";
import { THEMES, type Theme } from "../drawing/theme";
import { GUIDE_STYLE, type Guide, Tubes } from "../drawing/tubes";
import type { LengthFormat, MachineBody, Tool, Vec3 } from "../interface";
import { Backdrop } from "../layers/backdrop";
import { Gizmo } from "../layers/gizmo";
import { facing, Grid } from "../layers/grid";
import { gridSpacing, type Spacing } from "../layers/grid_spacing";
import { edgesOf, Machine, reach } from "../playback/machine";
import type { Handle } from "../tools/gizmo_parts";
import { ballAround, ORIGIN } from "../vec";
import { Camera } from "../view/camera";
import { axes, framedAspect, framing, pixelAtTarget } from "../view/orbit";
import type { Projection } from "../view/projection";
import type { EditedMachine } from "./interface";

/** mm of wire behind the bend point and before it: so that the side is seen to which it leaves. */
const WIRE: readonly [Vec3, Vec3] = [
  [-260, 0, 0],
  [80, 0, 0],
];

/** A small body is framed with so much of what is around it, mm. */
const AROUND = 60;

export class BodiesStage {
  readonly camera = new Camera();
  /** What `Turning` asks of a view: nothing is drawn or played here. */
  readonly tool: Tool = "select";
  readonly plane = null;
  readonly playing = false;
  theme: Theme = THEMES.dark;
  spacing: Spacing = { mm: 10, fine: 1 };
  machine: EditedMachine = { bodies: [], wireDiameter: 1, orbitOffset: 0 };
  chosen: number | null = null;
  /** Whether the chosen one can be moved. */
  editable = true;
  private hovered: number | null = null;
  private handle: Handle | null = null;
  /** Where the chosen body is while it is dragged. */
  private dragged: Vec3 | null = null;
  private line: readonly Guide[] = [];
  private seen: Projection | null = null;
  private readonly uniforms = shared();
  private readonly world = new Scene();
  private readonly above = new Scene();
  private readonly backdrop = new Backdrop(this.uniforms);
  private readonly grid = new Grid(this.uniforms);
  private readonly solids = new Machine(this.uniforms, ({ selected }) => selected, 0.5);
  private readonly wire = new Tubes(this.uniforms, { radius: 0.5, least: 1.1, most: 1000, sides: 10, round: true });
  private readonly guides = new Tubes(this.uniforms, GUIDE_STYLE);
  private readonly gizmo = new Gizmo(this.uniforms);
  private readonly symbols = new Symbols(this.uniforms);

  constructor(
    readonly lengths: LengthFormat,
    private readonly changed: () => void,
  ) {
    this.world.add(this.backdrop.mesh, this.grid.mesh, this.wire.mesh, this.solids.group);
    this.above.add(this.guides.mesh, this.gizmo.mesh, this.symbols.mesh);
    this.gizmo.mesh.renderOrder = 1;
    this.symbols.mesh.renderOrder = 2;
    this.paint(this.theme);
  }

  get projection(): Projection {
    this.seen ??= this.camera.update();
    return this.seen;
  }

  get gizmoAt(): Vec3 | null {
    return this.editable ? (this.dragged ?? this.chosenBody?.at ?? null) : null;
  }

  get chosenBody(): MachineBody | null {
    return this.chosen === null ? null : (this.bodies[this.chosen] ?? null);
  }

  viewMoved(): void {
    this.seen = null;
    this.changed();
  }

  show(machine: EditedMachine): void {
    this.machine = machine;
    this.dragged = null;
    this.build();
    const ball = ballAround(this.places);
    this.camera.ball = ball ?? { centre: ORIGIN, radius: 100 };
    this.viewMoved();
  }

  choose(chosen: number | null): void {
    this.chosen = chosen;
    this.dragged = null;
    this.build();
  }

  hover(body: number | null): void {
    if (body === this.hovered) return;
    this.hovered = body;
    this.mark();
  }

  activate(handle: Handle | null, line: readonly Guide[] = []): void {
    const same = JSON.stringify([handle, line]) === JSON.stringify([this.handle, this.line]);
    [this.handle, this.line] = [handle, line];
    if (!same) this.changed();
  }

  /** Shows the chosen body elsewhere while it is dragged; null: where it is. */
  drag(at: Vec3 | null): void {
    this.dragged = at;
    this.build();
  }

  bodyAt(x: number, y: number): number | null {
    return this.solids.bodyOn(this.projection.ray(x, y));
  }

  paint(theme: Theme): void {
    this.theme = theme;
    paint(this.uniforms, theme);
    this.solids.paint(theme);
    this.gizmo.paint(theme);
    this.symbols.halo = theme.halo;
    this.build();
  }

  /** Looks at the chosen body, or at everything. */
  frame(chosen: boolean): void {
    const { camera, chosenBody } = this;
    const places = chosen && chosenBody ? reach(chosenBody) : this.places;
    camera.orbit = framing(camera.orbit, places, framedAspect(camera.width, camera.height), AROUND);
    this.viewMoved();
  }

  draw(renderer: WebGLRenderer): void {
    const { camera, theme } = this;
    this.seen ??= camera.update();
    this.uniforms.ratio.value = renderer.getPixelRatio();
    camera.describe(this.uniforms);
    this.uniforms.fade.value.z = theme.fade * 0.45;
    this.spacing = gridSpacing(pixelAtTarget(camera.orbit, camera.height), this.lengths);
    const ground = Math.min(0, ...this.places.map(([, , z]) => z));
    const plane = facing(axes(camera.orbit).back, camera.orbit.orthographic);
    const reached = Math.max(camera.orbit.distance * 1.6, camera.ball.radius);
    this.grid.show({ ...plane, origin: [0, 0, ground] }, camera.orbit.target, reached, this.spacing, theme, false);
    this.symbols.show([{ at: ORIGIN, shape: "target", colour: theme.edge, radius: 7 }]);
    const outline = this.chosenBody ? edgesOf(this.chosenBody) : [];
    const look = { colour: theme.selected };
    this.guides.show([...outline.map(([from, to]): Guide => ({ from, to, look })), ...this.line]);
    this.gizmo.show(this.gizmoAt, this.handle, false);
    paintPicture(renderer, this.world, this.above, camera.three);
  }

  dispose(): void {
    const parts = [this.backdrop, this.grid, this.solids, this.wire, this.guides, this.gizmo, this.symbols];
    for (const part of parts) part.dispose();
  }

  /** The bodies with the one that is dragged where it is. */
  private get bodies(): readonly MachineBody[] {
    const { dragged, chosen } = this;
    const { bodies } = this.machine;
    return dragged === null ? bodies : bodies.map((body, at) => (at === chosen ? { ...body, at: dragged } : body));
  }

  private get places(): readonly Vec3[] {
    return [...WIRE, ...this.bodies.flatMap(reach)];
  }

  private build(): void {
    const { wireDiameter, orbitOffset } = this.machine;
    this.solids.show(this.bodies, orbitOffset, 0, wireDiameter, this.theme);
    this.wire.count = 1;
    this.wire.radius = wireDiameter / 2;
    this.wire.set(0, ...WIRE, { colour: this.theme.edge });
    this.mark();
  }

  private mark(): void {
    const marked = [this.chosen, this.hovered].filter((body) => body !== null);
    this.solids.mark([...new Set(marked)]);
    this.changed();
  }
}
