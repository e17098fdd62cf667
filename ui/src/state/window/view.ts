import { create } from "zustand";
import type {
  Axis,
  DrawingPlane,
  Hovered,
  MeasuredThing,
  PlanePoint,
  Preview,
  Selection,
  SnapKind,
  Tool,
  Vec3,
} from "../../scene/interface";
import { type Line, lines } from "../construction/lines";
import { useDesign } from "../design/design";
import { planeThrough } from "../design/geometry";
import { surroundings, verticesOf } from "../design/selecting";
import { select, useSelection } from "../design/selection";
import { store, stored } from "./ui";
import { type DisplayUnit, useUnits } from "./units";

/** CSS pixels from the upper left corner of the view. */
interface Spot {
  readonly x: number;
  readonly y: number;
}

/** What the rest of the window asks of the view. */
interface ViewHandle {
  view(name: Side): void;
  /** The same so that it is seen how the view turns. */
  fly(to: Side | Vec3): void;
  turn(dx: number, dy: number): void;
  toggleParallel(): void;
  frame(selection?: Selection): void;
  /** CSS pixels in the view of a place of the design; null where it is behind the eye. */
  screen(at: Vec3): Spot | null;
  /** As `screen`, the part of a segment that is in front of the eye; and where the middle of the gizmo is, mm. */
  readonly seen: {
    readonly gizmo: Vec3 | null;
    segment(a: Vec3, b: Vec3): { readonly a: Spot; readonly b: Spot } | null;
  };
  startGrab(): boolean;
  lockAxis(axis: Axis | null): void;
  handleKey(event: KeyboardEvent): boolean;
  cancel(): boolean;
}

/** Sides that the view looks from, along an axis. */
export type Side = "front" | "back" | "right" | "left" | "top" | "bottom";

/** Which of the planes of the axes is drawn on. */
export type PlaneName = "xy" | "xz" | "yz";

/** The plane that is seen straight on from a side. */
export const FACING: Readonly<Record<Side, PlaneName>> = {
  front: "xz",
  back: "xz",
  right: "yz",
  left: "yz",
  top: "xy",
  bottom: "xy",
};

/** A plane of a person's own, and what it was put on: vertices, or other points, which have no names. */
interface OwnPlane extends DrawingPlane {
  readonly through: readonly (number | null)[];
}

interface ViewStore {
  /** Null before the view is there. */
  readonly handle: ViewHandle | null;
  readonly tool: Tool;
  /** Whether strands are construction lines instead of edges. */
  readonly constructing: boolean;
  readonly snapKinds: ReadonlySet<SnapKind>;
  /** Of the grid that is snapped to, mm. */
  readonly grid: number;
  /** CSS pixels. */
  readonly reach: number;
  readonly plane: PlaneName;
  /** Drawn on instead of it: put on three points. It stays where it is when they move. */
  readonly ownPlane: OwnPlane | null;
  /** How many points were taken for a plane that is being put. */
  readonly planePoints: number;
  /** How far the plane is from the origin, or from where it was put, mm. */
  readonly planeOffset: number;
  readonly stencilsShown: boolean;
  /** From 0 to 1. */
  readonly stencilOpacity: number;
  /** How far off a stencil a click places vertices, on the side that is seen, mm. */
  readonly stencilOffset: number;
  /** The stencil that is placed: by its fields, and by the gizmo where nothing is selected. */
  readonly chosenStencil: number | null;
  /** Whether construction lines are seen; hidden ones are neither snapped to nor chosen. */
  readonly constructionShown: boolean;
  /** Whether places that the checks name are written on in the view. */
  readonly annotations: boolean;
  /** Whether the lengths of all edges and the angles between them are written in the view. */
  readonly dimensions: boolean;
  /** What the view is called: "Perspective", "Top". */
  readonly viewName: string;
  readonly hovered: Hovered | null;
  /** How many edges the strand has that is being drawn; null without one. */
  readonly strand: number | null;
  /** What is measured between: none, the first, or both. */
  readonly measuring: readonly MeasuredThing[];
  /** What a fix would do, while it is shown. */
  readonly preview: Preview | null;
}

export const SNAP_KINDS: readonly SnapKind[] = [
  "vertex",
  "stencil-vertex",
  "stencil-edge",
  "construction",
  "edge-middle",
  "edge",
  "surface",
  "angle",
  "grid",
  "plane",
];

/** mm: a round figure of what lengths are shown in, where a person has set none. */
const USUAL_GRID: Readonly<Record<DisplayUnit, number>> = { mm: 5, inch: 6.35 };

export const useView = create<ViewStore>()(() => ({
  handle: null,
  tool: "select",
  constructing: false,
  snapKinds: new Set(SNAP_KINDS),
  grid: USUAL_GRID[useUnits.getState().unit],
  reach: 12,
  plane: "xy",
  ownPlane: null,
  planePoints: 0,
  planeOffset: 0,
  stencilsShown: true,
  stencilOpacity: 0.45,
  stencilOffset: 0,
  chosenStencil: null,
  constructionShown: true,
  annotations: stored("wirebend.annotations") !== "off",
  dimensions: stored("wirebend.dimensions") === "on",
  viewName: "Perspective",
  hovered: null,
  strand: null,
  measuring: [],
  preview: null,
}));

/** The grid goes with the unit, where the person has set none. */
export function gridFollows(unit: DisplayUnit, before: DisplayUnit): void {
  if (useView.getState().grid === USUAL_GRID[before]) useView.setState({ grid: USUAL_GRID[unit] });
}

/** Chooses a tool; a strand that is open ends. */
export function chooseTool(tool: Tool): void {
  useView.getState().handle?.cancel();
  const draws = tool === "trace" || tool === "draw";
  useView.setState(({ constructing }) => ({ tool, strand: null, constructing: constructing && draws }));
}

/** Draws construction lines, or edges again; with a tool that draws. */
export function setConstructing(constructing: boolean): void {
  const { tool } = useView.getState();
  if (constructing && tool !== "trace" && tool !== "draw") chooseTool("draw");
  useView.setState({ constructing });
}

/** Chooses a stencil to place; the wire is not selected meanwhile. */
export function chooseStencil(chosenStencil: number | null): void {
  if (chosenStencil !== null) select([]);
  useView.setState({ chosenStencil });
}

/** A stencil that is gone is not chosen: its id may be that of another. */
export function keepChosenStencil({ state }: Pick<ReturnType<typeof useDesign.getState>, "state">): void {
  const { chosenStencil } = useView.getState();
  const there = state?.stencils.some(({ id }) => id === chosenStencil);
  if (chosenStencil !== null && !there) useView.setState({ chosenStencil: null });
}

export function toggleSnap(kind: SnapKind): void {
  useView.setState(({ snapKinds }) => ({
    snapKinds: new Set(SNAP_KINDS.filter((other) => (other === kind ? !snapKinds.has(kind) : snapKinds.has(other)))),
  }));
}

export function setAnnotations(annotations: boolean): void {
  useView.setState({ annotations });
  store("wirebend.annotations", annotations ? "on" : "off");
}

export function setDimensions(dimensions: boolean): void {
  useView.setState({ dimensions });
  store("wirebend.dimensions", dimensions ? "on" : "off");
}

export function setConstructionShown(constructionShown: boolean): void {
  useView.setState({ constructionShown });
}

/** The construction lines that are seen. */
export const shownLines = (): readonly Line[] => (useView.getState().constructionShown ? lines() : []);

/** The plane by its name, at a distance from the origin. u × v points away from the origin for a positive one; xz faces the front. */
export function planeOf(name: PlaneName, offset: number): DrawingPlane {
  switch (name) {
    case "xy":
      return { origin: [0, 0, offset], u: [1, 0, 0], v: [0, 1, 0] };
    case "xz":
      return { origin: [0, offset, 0], u: [1, 0, 0], v: [0, 0, 1] };
    case "yz":
      return { origin: [offset, 0, 0], u: [0, 1, 0], v: [0, 0, 1] };
  }
}

/** The plane that is drawn on. */
export function drawnPlane({
  plane,
  ownPlane,
  planeOffset,
}: Pick<ViewStore, "plane" | "ownPlane" | "planeOffset">): DrawingPlane {
  if (!ownPlane) return planeOf(plane, planeOffset);
  const { origin, u, v } = ownPlane;
  const normal = normalOf(ownPlane);
  const at = (k: 0 | 1 | 2) => origin[k] + normal[k] * planeOffset;
  return { origin: [at(0), at(1), at(2)], u, v };
}

/** Of length 1. */
export function normalOf({ u, v }: DrawingPlane): Vec3 {
  return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
}

/** Draws on a plane of the axes. */
export function choosePlane(plane: PlaneName): void {
  // How far from a plane of its own points it was says nothing of another one.
  useView.setState(({ ownPlane, planeOffset }) => ({ plane, ownPlane: null, planeOffset: ownPlane ? 0 : planeOffset }));
}

/** Puts the plane on the three selected vertices; on points that are clicked where others, or none, are selected. */
export function putPlane(): void {
  const design = useDesign.getState();
  const points = verticesOf(useSelection.getState(), design).flatMap((vertex) => {
    const at = design.vertices.get(vertex)?.at;
    return at ? [{ at, vertex }] : [];
  });
  if (!putPlaneOn(points)) chooseTool("plane");
}

/** The points that were clicked for a plane: three put it, and it is drawn on. */
export function takePlanePoints(points: readonly PlanePoint[]): void {
  const isPut = putPlaneOn(points);
  useView.setState({ planePoints: isPut ? 0 : points.length });
  if (isPut) chooseTool("draw");
}

/** Whether there are three points, not in line. */
function putPlaneOn(points: readonly PlanePoint[]): boolean {
  const [a, b, c] = points.map(({ at }) => at);
  const plane = a && b && c && points.length === 3 ? planeThrough(a, b, c) : null;
  if (plane) useView.setState({ ownPlane: { ...plane, through: points.map(({ vertex }) => vertex) }, planeOffset: 0 });
  return plane !== null;
}

/** Vertices nearer than this lie in one plane, mm: as exact as drawings are written. */
const FLAT = 0.001;

/** The plane of the axes that a flat design lies in; null of one that is not flat, has a stencil, or is a line, which lies in several. */
export function planeOfAll({
  vertices,
  surfaces,
}: Pick<ReturnType<typeof useDesign.getState>, "vertices" | "surfaces">): DrawingPlane | null {
  if (surfaces.size > 0 || vertices.size === 0) return null;
  const extent = [0, 1, 2].map((axis) => {
    const places = [...vertices.values()].map(({ at }) => at[axis] ?? 0);
    const least = places.reduce((a, b) => Math.min(a, b), Infinity);
    return [least, places.reduce((a, b) => Math.max(a, b), -Infinity) - least] as const;
  });
  const flat = extent.flatMap(([, size], axis) => (size <= FLAT ? [axis] : []));
  const [axis] = flat;
  const name = (["yz", "xz", "xy"] as const)[axis ?? -1];
  return flat.length === 1 && name ? planeOf(name, extent[axis ?? 0]?.[0] ?? 0) : null;
}

/** Frames places with what is next to them, so that a person sees where in the design they are. */
export function frame(vertices: Iterable<number>, edges: Iterable<number>): void {
  useView.getState().handle?.frame({
    vertices: surroundings({ vertices: new Set(vertices), edges: new Set(edges) }, useDesign.getState()),
    edges: new Set(),
    lines: new Set(),
  });
}
