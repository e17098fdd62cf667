/** What the scene is given and what it tells: the only part of `scene/` that the rest of the editor knows. */

/** mm, right-handed, z up. */
export type Vec3 = readonly [number, number, number];

export interface SceneVertex {
  readonly id: number;
  readonly at: Vec3;
  readonly support: boolean;
}

export interface SceneEdge {
  readonly id: number;
  readonly a: number;
  readonly b: number;
}

/** The wireframe as it is drawn, by id. */
export interface SceneDesign {
  readonly vertices: ReadonlyMap<number, SceneVertex>;
  readonly edges: ReadonlyMap<number, SceneEdge>;
}

/** What the checks say of a place. Never colour alone: size and thickness go with it. */
export type Verdict = "error" | "warning" | "fine";

export interface SceneMarks {
  /** What the checks say of vertices; a vertex that is not named is fine where `checked`. */
  readonly vertices: ReadonlyMap<number, Verdict>;
  readonly edges: ReadonlyMap<number, Verdict>;
  /** Vertices with an odd number of edges, where that is an error: drawn larger. */
  readonly odd: ReadonlySet<number>;
  /** Edges that are laid twice: drawn as two lines. */
  readonly doubled: ReadonlySet<number>;
  /** Where the wire starts, with the vertex that it goes to first. */
  readonly start: { readonly vertex: number; readonly towards: number } | null;
  /** Whether all of it was checked, to the last bend: otherwise what is not named is grey, as without a machine. */
  readonly checked: boolean;
}

export interface Selection {
  readonly vertices: ReadonlySet<number>;
  readonly edges: ReadonlySet<number>;
}

/** A surface to trace on, in mm. */
export interface SceneStencil {
  /** x, y, z of each corner. */
  readonly positions: Float32Array;
  /** Three corners a triangle. */
  readonly triangles: Uint32Array;
}

/** What clicks do. */
export type Tool =
  /** Click selects, dragging on nothing is a box, dragging a selected vertex moves the selection. */
  | "select"
  /** Each click places a vertex that snaps, and connects it with the one before. */
  | "trace"
  /** The same on a plane, for flat parts. */
  | "draw";

export type SnapKind = "vertex" | "stencil-vertex" | "stencil-edge" | "surface" | "edge" | "grid" | "plane";

export interface SnapSettings {
  /**
   * Which targets count. Within reach the first of these is taken: vertex, stencil-vertex, stencil-edge, edge, surface, grid, plane.
   * With `plane` a point of the grid has to be within reach; without it the nearest one is always taken.
   */
  readonly kinds: ReadonlySet<SnapKind>;
  /** Of the grid, mm. */
  readonly grid: number;
  /** How near the pointer has to be, in CSS pixels. */
  readonly reach: number;
}

/** The plane that is drawn on: through `origin`, with the axes `u` and `v` of length 1 at right angles. */
export interface DrawingPlane {
  readonly origin: Vec3;
  readonly u: Vec3;
  readonly v: Vec3;
}

export type Axis = "x" | "y" | "z";

/** What a click with `trace` or `draw` asks for: one edge, or a first vertex alone is kept by the scene until the next. */
export interface Stroke {
  /** The vertex that is there already. */
  readonly from: number | null;
  /** New vertices in order. */
  readonly through: readonly Vec3[];
  /** The vertex that is there already, at which the stroke ends; the strand is over then. */
  readonly to: number | null;
  /**
   * An edge that is to be split first, since the stroke begins or ends on it, and where: 0 at `a`, 1 at `b`. Where it ends on one,
   * the strand is over too. A stroke from an edge to an edge comes as two: one that only splits the first edge, and resolves with
   * the new vertex, then one from there.
   */
  readonly split: { readonly edge: number; readonly at: number; readonly end: "from" | "to" } | null;
}

export interface Moved {
  readonly vertex: number;
  readonly at: Vec3;
}

/** What is under the pointer. */
export type Hovered =
  | { readonly kind: "vertex"; readonly id: number; readonly x: number; readonly y: number }
  | { readonly kind: "edge"; readonly id: number; readonly x: number; readonly y: number }
  | { readonly kind: "snap"; readonly snap: SnapKind; readonly at: Vec3; readonly x: number; readonly y: number };

/** What the scene tells. Places on the screen are CSS pixels from the upper left corner of the viewport. */
export interface SceneListener {
  selected(selection: Selection): void;
  hovered(what: Hovered | null): void;
  /** While a selection is dragged: at the first move of a frame, and where the last has brought it. */
  dragging(moved: readonly Moved[]): void;
  /** The drag is over: one edit. The scene shows the new places until the design that it is given has them. */
  dropped(moved: readonly Moved[]): void;
  dragCancelled(): void;
  /**
   * Resolves with the id of the vertex that the strand goes on from; null ends the strand. A rejection ends it too; telling why is up
   * to the listener.
   */
  stroke(stroke: Stroke): Promise<number | null>;
  strandEnded(): void;
  /** "Front", "Back", "Right", "Left", "Top", "Bottom", "Parallel", or "Perspective": also once the view was turned, so that a name no longer holds. */
  viewChanged(name: string): void;
}

/** One step of a program, as it is played. */
export interface PlayedStep {
  /** mm. */
  readonly feed: number;
  /** Degrees, right-handed about the direction of travel. */
  readonly rotate: number;
  /** Degrees, right-handed about the bend axis. */
  readonly bend: number;
  /** Seconds that each of the three takes, and that the peg takes to come out and go in; 0 where it stays out. */
  readonly seconds: readonly [number, number, number, number];
  /** Degrees that the bend axis goes to, which is more than the bend: springback and setback. */
  readonly bendAxis: number;
}

/** A body of a machine. Lengths in mm, in the frame of the part that it belongs to; see `MachineBody.part`. */
export type MachineShape =
  | { readonly kind: "box"; readonly size: Vec3 }
  | { readonly kind: "cylinder"; readonly radius: number; readonly length: number };

export interface MachineBody {
  readonly name: string;
  /** `frame` stands still; `head` turns about the wire; `peg` goes with the bend axis, and in and out along it. */
  readonly part: "frame" | "head" | "peg";
  readonly shape: MachineShape;
  /** Centre of the shape. x: along the wire, the way it leaves; z: the bend axis; origin: the bend point. */
  readonly at: Vec3;
  /** Where the cylinder's axis, or the box' own z, points. */
  readonly axis: Vec3;
}

/** A wire to be played on a machine: one step for each straight part of the path, as the schedule has them. */
export interface Played {
  readonly steps: readonly PlayedStep[];
  /** Corners and ends of the wire as designed, in the order of the walk, in mm, in the frame of the design. */
  readonly path: readonly Vec3[];
  /** The same as the simulated machine makes it; null where that is not known. */
  readonly made: readonly Vec3[] | null;
  readonly bodies: readonly MachineBody[];
  readonly wireDiameter: number;
  /** x of the axis that the peg turns about, mm; 0, the bend point, where it is not given. */
  readonly orbitOffset?: number;
}

export type Shown = "designed" | "made" | "both";

/** What a fix would do, shown before it is done. */
export interface Preview {
  /** mm. */
  readonly edges: readonly (readonly [Vec3, Vec3])[];
  /** Edges that would go, by id. */
  readonly removed: ReadonlySet<number>;
}

/** A short text at a place of the design, mm. */
export interface SceneLabel {
  readonly at: Vec3;
  readonly text: string;
  readonly verdict: Verdict | null;
}

/** What features may draw into, by name: `collisions` is in the frame of the machine that is played, `tolerances` in the design's. */
export type Layer = "collisions" | "tolerances";
