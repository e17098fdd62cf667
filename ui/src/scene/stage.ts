/** What is in the picture, put together: the tools and the viewport change it, and it draws itself. */

import { Group, Scene, type WebGLRenderer } from "three";
import { paintPicture } from "./drawing/painting";
import { paint, shared } from "./drawing/shading";
import { type Sign, Symbols } from "./drawing/symbols";
import { THEMES, type Theme } from "./drawing/theme";
import { GUIDE_STYLE, type Guide, Tubes } from "./drawing/tubes";
import type {
  ChosenStencil,
  DrawingPlane,
  LengthFormat,
  Moved,
  Preview,
  SceneDesign,
  SceneDimensions,
  SceneHeld,
  SceneLabel,
  SceneMarks,
  SceneStencil,
  SceneStruts,
  Selection,
  SnapSettings,
  Tool,
  Vec3,
} from "./interface";
import { Backdrop } from "./layers/backdrop";
import { Chosen, type Held } from "./layers/chosen";
import { Construction } from "./layers/construction";
import { DesignLayer, NO_MARKS } from "./layers/design_layer";
import { type Change, DrawnDesign } from "./layers/drawn_design";
import { FixPreview } from "./layers/fix_preview";
import { Gizmo } from "./layers/gizmo";
import { facing, Grid } from "./layers/grid";
import { gridSpacing, type Spacing } from "./layers/grid_spacing";
import { HeldPlaces } from "./layers/held_places";
import { Texts } from "./layers/labels/texts";
import { OwnedMarks } from "./layers/owned_marks";
import { areSame } from "./layers/same_marks";
import { SelectionLayer } from "./layers/selection_layer";
import { SpreadLayer } from "./layers/spread";
import { Stencils } from "./layers/stencils";
import { StrutLayer } from "./layers/strut_layer";
import type { Pickable } from "./picking/picking";
import { DEFAULT_SNAP, type Line } from "./picking/snap";
import { Playback } from "./playback/playback";
import type { Handle } from "./tools/gizmo_parts";
import { ballAround, middle } from "./vec";
import { Camera } from "./view/camera";
import { axes, framedAspect, framing, pixelAtTarget } from "./view/orbit";
import type { Projection } from "./view/projection";

export class Stage {
  readonly camera = new Camera();
  readonly design = new DrawnDesign();
  theme: Theme = THEMES.dark;
  tool: Tool = "select";
  /** What a click of a strand makes. */
  draws: "edge" | "line" = "edge";
  snap: SnapSettings = DEFAULT_SNAP;
  /** Lines to snap to that are no wire. */
  readonly construction = new Construction();
  /** Null for the ground. */
  plane: DrawingPlane | null = null;
  spacing: Spacing = { mm: 10, fine: 1 };
  private readonly uniforms = shared();
  private readonly world = new Scene();
  private readonly above = new Scene();
  private readonly designed = new Group();
  private readonly backdrop = new Backdrop(this.uniforms);
  private readonly grid = new Grid(this.uniforms);
  readonly stencils = new Stencils(this.uniforms);
  private readonly layer = new DesignLayer(this.uniforms, this.theme);
  readonly selected = new SelectionLayer(this.uniforms);
  private readonly preview = new FixPreview(this.uniforms);
  private readonly guides = new Tubes(this.uniforms, { ...GUIDE_STYLE, dash: 9 });
  private readonly symbols = new Symbols(this.uniforms);
  private readonly gizmo = new Gizmo(this.uniforms);
  readonly playback = new Playback(this.uniforms, this.theme);
  private readonly struts = new StrutLayer(this.uniforms, this.theme);
  readonly spread = new SpreadLayer(this.uniforms);
  private readonly held = new HeldPlaces();
  private readonly texts: Texts;
  private marks: SceneMarks = NO_MARKS;
  private readonly owned = new OwnedMarks();
  private handle: Handle | null = null;
  private seen: Projection | null = null;
  private readonly chosen = new Chosen();

  /** `overlay`: for texts over the picture; `changed`: it has to be drawn again. */
  constructor(
    overlay: HTMLElement,
    public lengths: LengthFormat,
    private readonly changed: () => void,
  ) {
    this.texts = new Texts(overlay, this.theme);
    const { layer, preview, selected, spread, stencils } = this;
    this.designed.add(layer.group, selected.outlines.mesh, preview.mesh, stencils.group, spread.mesh);
    this.world.add(this.backdrop.mesh, this.grid.mesh, this.designed, this.struts.group, this.playback.group);
    this.above.add(this.guides.mesh, this.gizmo.mesh, this.symbols.mesh);
    this.gizmo.mesh.renderOrder = 1;
    this.symbols.mesh.renderOrder = 2;
    this.paint(this.theme);
  }

  setLengths(lengths: LengthFormat): void {
    this.lengths = lengths;
    this.label();
  }

  get projection(): Projection {
    this.seen ??= this.camera.update();
    return this.seen;
  }

  get playing(): boolean {
    return this.playback.group.visible;
  }

  /** Where the gizmo is: amid what would move; null where it is not shown. */
  get gizmoAt(): Vec3 | null {
    if (this.tool !== "select" || this.playing || this.struts.shown) return null;
    const places = this.placesOf(this.selected.selection);
    if (places.length > 0) return middle(places);
    return this.stencilInHand && this.chosen.middle;
  }

  /** Where the vertices and the ends of the lines of a selection are. */
  placesOf(selection: Selection): Vec3[] {
    return [...this.design.placesOf(selection).values(), ...this.construction.endsOf(selection)];
  }

  /** About what a selection or a stencil can be turned: its middle; null where it is a single vertex. */
  get turnsAt(): Vec3 | null {
    return this.stencilInHand || this.placesOf(this.selected.selection).length > 1 ? this.gizmoAt : null;
  }

  /** The stencil that would move, and its middle: where nothing is selected. */
  get stencilInHand(): ChosenStencil | null {
    const { vertices, edges, lines } = this.selected.selection;
    return vertices.size + edges.size + lines.size > 0 ? null : this.chosen.stencil;
  }

  /** What there is to be clicked on. */
  get pickable(): Pickable {
    const lines = this.designed.visible ? this.construction.all : [];
    return { design: this.design, projection: this.projection, lines };
  }

  viewMoved(): void {
    this.seen = null;
    this.changed();
  }

  setDesign(design: SceneDesign): void {
    this.redraw(this.design.update(design));
    this.construction.held = null;
    this.bound();
  }

  setMarks(marks: SceneMarks): void {
    // While a person drags, most answers say the same of every place.
    if (areSame(marks, this.marks)) return;
    this.marks = marks;
    this.layer.mark(this.design, marks, this.preview.removed);
    this.reselect();
  }

  /** What the checks say of places, in figures. */
  setLabels(findings: readonly SceneLabel[]): void {
    this.texts.findings = findings;
    this.label();
  }

  /** What is written beside the edge that is being drawn. */
  setBand(band: SceneLabel | null): void {
    if (band === null && this.texts.band === null) return;
    this.texts.band = band;
    this.label();
  }

  setDimensions(dimensions: SceneDimensions): void {
    this.texts.dimensions = dimensions;
    const { between } = dimensions;
    const look = { colour: this.theme.acted };
    this.mark("measured", [], between ? [{ from: between[0], to: between[1], look }] : []);
    this.label();
  }

  setPreview(preview: Preview | null): void {
    this.preview.show(preview, this.theme);
    this.layer.mark(this.design, this.marks, this.preview.removed);
    this.changed();
  }

  /** Struts instead of the edges of the design; null shows those again. */
  setStruts(struts: SceneStruts | null): void {
    this.struts.show(struts);
    this.showParts();
  }

  enlarge(scale: number): void {
    this.struts.enlarge(scale);
    this.changed();
  }

  hold(held: SceneHeld): void {
    this.held.shown = held;
    this.changed();
  }

  /** Shows construction lines; whether they are others than before. */
  setConstruction(lines: readonly Line[]): boolean {
    const changed = this.construction.show(lines);
    this.holdLines(null);
    if (changed) this.bound();
    return changed;
  }

  /** Shows the selected construction lines elsewhere while they are in the hand; null: where they are. */
  holdLines(held: Held | null): void {
    this.construction.held = held;
    this.layConstruction();
  }

  private layConstruction(): void {
    const { construction, designed, selected, theme } = this;
    const lines = designed.visible ? construction.lines(theme, selected) : [];
    this.mark("construction", lines.length > 0 ? construction.signs(theme, selected) : [], lines);
  }

  setStencils(stencils: readonly SceneStencil[]): void {
    this.stencils.show(stencils);
    this.bound();
    this.changed();
  }

  chooseStencil(chosen: ChosenStencil | null): void {
    this.chosen.stencil = chosen;
    this.holdStencil(null);
  }

  /** Shows the chosen stencil elsewhere while it is in the hand; null: where it lies. */
  holdStencil(held: Held | null): void {
    this.chosen.held = held;
    const { stencil } = this.chosen;
    if (stencil) this.stencils.hold(stencil.id, held);
    this.mark("chosen stencil", [], this.designed.visible ? this.chosen.lines(this.theme) : []);
  }

  /** Shows vertices elsewhere while they are dragged. */
  move(moved: readonly Moved[]): void {
    this.redraw(this.design.move(moved));
  }

  select(selection: Selection): void {
    this.selected.selection = selection;
    this.reselect();
  }

  /** Marks what is under the pointer, or pointed at in a list. */
  point(how: "hovered" | "highlight", at: Selection): void {
    this.selected[how] = at;
    this.reselect();
  }

  /** Signs and lines of one owner, instead of those that it had. */
  mark(owner: string, signs: readonly Sign[], lines: readonly Guide[] = []): void {
    if (this.owned.set(owner, signs, lines)) this.changed();
  }

  activate(handle: Handle | null): void {
    if (JSON.stringify(handle) === JSON.stringify(this.handle)) return;
    this.handle = handle;
    this.changed();
  }

  paint(theme: Theme): void {
    this.theme = theme;
    paint(this.uniforms, theme);
    this.layer.paint(this.design, theme);
    this.stencils.paint(theme);
    this.gizmo.paint(theme);
    this.holdStencil(this.chosen.held);
    this.playback.paint(theme);
    this.struts.paint(theme);
    this.texts.paint(theme);
    this.symbols.halo = theme.halo;
    this.preview.paint(theme);
    this.reselect();
  }

  /** Looks at these, or at everything there is. */
  frame(selection: Selection | null): void {
    const { camera } = this;
    const chosen = selection ? this.placesOf(selection) : [];
    const played = this.playback.places;
    const places = played ?? (chosen.length > 0 ? chosen : this.everything());
    camera.orbit = framing(camera.orbit, places, framedAspect(camera.width, camera.height));
    this.viewMoved();
  }

  /** Whether there is something to look at. */
  get empty(): boolean {
    return this.design.vertices.length === 0 && this.stencils.empty && this.construction.all.length === 0;
  }

  /** After what is played has begun or ended. */
  bound(): void {
    this.showParts();
    const ball = ballAround(this.playback.places ?? this.everything());
    this.camera.ball = ball ?? { centre: [0, 0, 0], radius: 100 };
    this.viewMoved();
  }

  private showParts(): void {
    this.designed.visible = !this.playing && !this.struts.shown;
    this.struts.group.visible = !this.playing && this.struts.shown;
    this.holdStencil(this.chosen.held);
    this.layConstruction();
    this.changed();
  }

  draw(renderer: WebGLRenderer): void {
    const { camera, theme } = this;
    const { projection } = this;
    const { width, height } = camera;
    this.uniforms.ratio.value = renderer.getPixelRatio();
    camera.describe(this.uniforms);
    // A machine is not a thicket: depth has to help less. Colours that mean a figure have to be those of the legend.
    this.uniforms.fade.value.z = theme.fade * (this.playing ? 0.45 : this.struts.shown ? 0.3 : 1);
    this.layGrid(height);
    const signs = this.playing ? [] : this.ownSigns(theme);
    this.symbols.show([...signs, ...this.owned.signs]);
    this.guides.show(this.owned.lines);
    this.gizmo.show(this.gizmoAt, this.handle, this.turnsAt !== null);
    paintPicture(renderer, this.world, this.above, camera.three);
    if (width > 0) this.texts.place(projection, !this.playing);
  }

  dispose(): void {
    for (const part of [
      this.backdrop,
      this.grid,
      this.stencils,
      this.layer,
      this.selected,
      this.preview,
      this.guides,
      this.symbols,
      this.gizmo,
      this.playback,
      this.struts,
      this.spread,
      this.texts,
    ])
      part.dispose();
  }

  private ownSigns(theme: Theme): Sign[] {
    const held = this.held.signs(theme);
    if (this.struts.shown) return [...held, ...this.struts.signs];
    return [...this.selected.signs(this.design, this.marks.start, theme), ...held];
  }

  private redraw(change: Change): void {
    this.layer.sync(this.design, change);
    this.reselect();
    this.label();
  }

  private label(): void {
    this.texts.show(this.design, this.lengths);
    this.changed();
  }

  private reselect(): void {
    this.selected.sync(this.design, this.layer, this.theme);
    this.layConstruction();
    this.changed();
  }

  private everything(): Vec3[] {
    return [...this.design.at, ...this.stencils.places, ...this.construction.all.flat()];
  }

  private layGrid(height: number): void {
    const { lengths } = this;
    const { orbit, ball } = this.camera;
    const drawing = this.tool === "draw" && !this.playing;
    const snapped = drawing ? this.snap.grid : 0;
    const clicks = this.snap.kinds.has("grid") ? snapped : 0;
    this.spacing = { ...gridSpacing(pixelAtTarget(orbit, height), lengths, snapped), clicks };
    const ground = facing(axes(orbit).back, orbit.orthographic);
    // The machine stands on the ground; a design is wherever it was drawn.
    const low = this.playing ? this.playback.ground : 0;
    const plane = drawing && this.plane ? this.plane : { ...ground, origin: [0, 0, low] as Vec3 };
    this.grid.show(plane, orbit.target, Math.max(orbit.distance * 1.6, ball.radius), this.spacing, this.theme, drawing);
  }
}
