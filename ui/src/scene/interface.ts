/** What the scene is given and what it reports: the only part of `scene/` that the rest of the editor knows. */

/** mm, right-handed, z up. */
export type Vec3 = readonly [number, number, number];

/** How lengths are written: the editor has one way to write numbers, and the scene is given it. */
export interface LengthFormat {
  /** mm in one of the unit that is shown. */
  readonly mm: number;
  readonly name: string;
  /** mm as a number of the unit, with the digits that a machine can make: "601.4". */
  number(mm: number): string;
  /** The same with no more digits than it needs: "5", "0.25". */
  short(mm: number): string;
  /** Degrees: "151.3°". */
  angle(deg: number): string;
}

/** What holds struts together at a vertex. */
export interface SceneJoint {
  readonly kind: "snap-fit" | "solder" | "zip-tie";
  readonly mass_g: number;
}

export interface SceneVertex {
  readonly id: number;
  readonly at: Vec3;
  readonly support: boolean;
  readonly joint?: SceneJoint;
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
  /** Of edges that are fine, where it is not the usual one. */
  readonly colours: ReadonlyMap<number, Colour>;
  /** Where the wire starts, with the vertex that it goes to first. */
  readonly start: { readonly vertex: number; readonly towards: number } | null;
  /** Whether all of it was checked, to the last bend: otherwise what is not named is grey, as without a machine. */
  readonly checked: boolean;
}

export interface Selection {
  readonly vertices: ReadonlySet<number>;
  readonly edges: ReadonlySet<number>;
  /** Construction lines, by their places in the list. */
  readonly lines: ReadonlySet<number>;
}

/** What of the wire is selected. */
export type WireSelection = Omit<Selection, "lines">;

/** A surface in its own frame. */
export interface SceneSurface {
  /** x, y, z of each corner, mm. */
  readonly positions: Float32Array;
  /** Three corners a triangle. */
  readonly triangles: Uint32Array;
}

type Row = readonly [number, number, number, number];

/** A surface to trace on. */
export interface SceneStencil {
  /** What has another id, or another surface, is another stencil. */
  readonly id: number;
  readonly surface: SceneSurface;
  /** The rows of the matrix that takes a point of the surface to where it lies in the design: the same scale along all axes. */
  readonly matrix: readonly [Row, Row, Row];
  /** Null for that of the theme. */
  readonly colour: Colour | null;
  readonly hidden: boolean;
}

/** The stencil that is chosen: it moves where nothing is selected. mm. */
export interface ChosenStencil {
  readonly id: number;
  readonly middle: Vec3;
  /** The lines of the box around it. */
  readonly box: readonly (readonly [Vec3, Vec3])[];
}

/** What clicks do. */
export type Tool =
  /** Click selects, dragging on nothing is a box, dragging a selected vertex moves the selection. */
  | "select"
  /** Each click places a vertex that snaps, and connects it with the one before. */
  | "trace"
  /** The same on a plane, for flat parts. */
  | "draw"
  /** Two clicks measure between what they take; the design stays as it is. */
  | "measure"
  /** Three clicks put the plane that is drawn on through what they take. */
  | "plane";

/** A point that a plane is put on, and its vertex where it is one. */
export interface PlanePoint {
  readonly at: Vec3;
  readonly vertex: number | null;
}

/** What is measured from or to, mm: a straight piece, or a place, which has both ends where it is. */
export interface MeasuredThing {
  readonly from: Vec3;
  readonly to: Vec3;
}

/** `angle`: an edge that is drawn on a plane goes in steps of 15°. */
export type SnapKind =
  | "vertex"
  | "stencil-vertex"
  | "stencil-edge"
  | "surface"
  | "construction"
  | "edge-middle"
  | "edge"
  | "angle"
  | "grid"
  | "plane";

export interface SnapSettings {
  /**
   * Which targets count. Within reach the first of these is taken: vertex, the ends and the middle of a construction line, stencil-vertex, stencil-edge, edge-middle, edge, surface,
   * angle, grid, plane; with `angle` and `grid` the length of an edge is in steps of the grid.
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
  | { readonly kind: "line"; readonly id: number; readonly x: number; readonly y: number }
  | { readonly kind: "snap"; readonly snap: SnapKind; readonly at: Vec3; readonly x: number; readonly y: number };

/** Directions of the picture in the frame of the design, of length 1: to the right, up, and out of it towards the eye. */
export interface ViewAxes {
  readonly right: Vec3;
  readonly up: Vec3;
  readonly back: Vec3;
}

/** What the scene reports. Places on the screen are CSS pixels from the upper left corner of the viewport. */
export interface SceneListener {
  selected(selection: Selection): void;
  hovered(what: Hovered | null): void;
  /** While a selection is dragged: at the first move of a frame, and where the last has brought it. */
  dragging(moved: readonly Moved[]): void;
  /** The drag is over: one edit, of vertices and of lines that went as far, mm. The scene shows the new places until the design that it is given has them. */
  dropped(moved: readonly Moved[], lines: readonly number[], by: Vec3): void;
  /** The same of vertices and lines that were turned by degrees about an axis through a place, right-handed. */
  turned(vertices: readonly number[], lines: readonly number[], axis: Axis, through: Vec3, deg: number): void;
  dragCancelled(): void;
  /** The chosen stencil was dragged so far, mm. It is shown there until this resolves. */
  stencilMoved(stencil: number, by: Vec3): Promise<void>;
  /** The chosen stencil was turned about an axis of the design through its middle. It is shown so until this resolves. */
  stencilTurned(stencil: number, axis: Axis, deg: number): Promise<void>;
  /**
   * Resolves with the id of the vertex that the strand continues from; null ends the strand. A rejection ends it too; reporting why is up
   * to the listener.
   */
  stroke(stroke: Stroke): Promise<number | null>;
  /** The same of a construction line; whether it was made. */
  line(from: Vec3, to: Vec3): Promise<boolean>;
  strandEnded(): void;
  /** None, the first, or the two that are measured between; the second may be what the pointer is on. */
  measuring(things: readonly MeasuredThing[]): void;
  /** The points that were taken for a plane, none in line with two others: three are all. */
  planePoints(points: readonly PlanePoint[]): void;
  /** "Front", "Back", "Right", "Left", "Top", "Bottom", "Parallel", or "Perspective": also once the view was turned, so that a name no longer holds. */
  viewChanged(name: string): void;
  /** At the first frame, and at each in which the view has another direction than in the one before. */
  viewTurned(axes: ViewAxes): void;
  /** A right click that neither turned the view nor gave something up; what it is on is selected. */
  menu(at: { readonly x: number; readonly y: number }): void;
}

/**
 * How a wire lies in its machine while it runs a step; the point that is just leaving lies at the origin. Frame of the machine: mm,
 * right-handed, the origin is the bend point, +x the way the wire leaves, z the bend axis of the head at its reference.
 */
export interface Pose {
  /** From the frame of the design to that of the machine, until it bends: a quaternion of length 1, x, y, z, w. */
  readonly turn: readonly [number, number, number, number];
  /** About this axis through the origin the wire that is out then turns, by `bend` degrees; of length 1, in the frame of the machine. */
  readonly bendAxis: Vec3;
  readonly bend: number;
}

/** Where wire and machine are at one moment of a step. Between two of them everything moves evenly. */
export interface Moment {
  /** The part of the step's time that has passed, from 0 to 1. */
  readonly at: number;
  /** How much of the feed, and of the bend, is done, from 0 to 1. */
  readonly fed: number;
  readonly bent: number;
  /** Degrees: of the head about x, and of the bend axis about the head's z. */
  readonly head: number;
  readonly bendAxis: number;
  /** Of the peg along its own axis: at 0 it is in, so that the wire can pass it, at 1 it is out and bends. */
  readonly pegOut: number;
}

/** One step of a program, as it is played. */
export interface PlayedStep {
  /** From its beginning to its end. */
  readonly moments: readonly Moment[];
  /** For feed, rotate, the bend axis there and back, and for waiting. */
  readonly seconds: readonly [number, number, number, number];
}

/** A wire as it is drawn: where it begins and where it is after each step, mm, in the frame of the design; a pose for each step. */
export interface PlayedPath {
  readonly corners: readonly Vec3[];
  readonly poses: readonly Pose[];
}

/** A body of a machine. Lengths in mm, in the frame of the part that it belongs to; see `MachineBody.part`. */
type MachineShape =
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

/** A wire to be played on a machine. */
export interface Played {
  readonly steps: readonly PlayedStep[];
  readonly designed: PlayedPath;
  /** The same as the simulated machine bends it; null where that is not known. */
  readonly made: PlayedPath | null;
  readonly bodies: readonly MachineBody[];
  readonly wireDiameter: number;
  /** x of the axis that the peg turns about, mm: 0 is the bend point. */
  readonly orbitOffset: number;
  /** How far the peg reaches beyond the middle of the wire while it is out, mm. */
  readonly pegTop: number;
}

/** What touches what: the part of the wire that a step has made, and a body by its place in `bodies`; null: the wire that is still to come. */
export interface Touch {
  readonly leg: number;
  readonly body: number | null;
}

export type Shown = "designed" | "made" | "both";

/** What a fix would do, shown before it is done, mm. */
export interface Preview {
  readonly edges: readonly (readonly [Vec3, Vec3])[];
  /** Edges that would go, by id. */
  readonly removed: ReadonlySet<number>;
}

/** Red, green, blue as the screen takes them, 0 to 1. */
export type Colour = readonly [number, number, number];

/** A line from point to point that is drawn instead of an edge of the design, mm. */
export interface SceneLine {
  readonly at: readonly Vec3[];
  /** How far each point has moved, at true scale; null where none has. */
  readonly by: readonly Vec3[] | null;
  /** One for the whole line, or one for each point. */
  readonly colours: readonly Colour[];
  /** Factor on the usual width. */
  readonly width?: number;
  /** 0 to 1: how much of it goes over into the backdrop. */
  readonly dim?: number;
}

/** The head of a machine that builds struts. */
export interface SceneHead {
  /** Half section from its tip: how far along its axis, and its radius, mm. */
  readonly outline: readonly (readonly [number, number])[];
  readonly tip: Vec3;
  /** From the tip into the head, of length 1. */
  readonly axis: Vec3;
  /** Other directions in which it could stand, of length 1. */
  readonly free: readonly Vec3[];
}

/** Places that hold a frame, mm, and the forces on it: each with where it acts and which way. */
export interface SceneHeld {
  readonly places: readonly Vec3[];
  readonly forces: readonly (readonly [at: Vec3, way: Vec3])[];
}

/** Struts that are drawn instead of the edges of the design. */
export interface SceneStruts {
  readonly lines: readonly SceneLine[];
  /** Whether the edges of the design are seen faintly beside them. */
  readonly ghost: boolean;
  /** Where what is coloured is largest. */
  readonly worst: { readonly at: Vec3; readonly by: Vec3 | null } | null;
  readonly head: SceneHead | null;
}

/** A ball around a place of the design, mm, through which it is seen. */
export interface SceneBall {
  readonly at: Vec3;
  readonly radius: number;
  readonly colour: Colour;
}

/** A ball around a place of a wire that is played. */
export interface PlayedBall extends SceneBall {
  /** mm of wire up to it. */
  readonly along: number;
}

/** A short text at a place of the design, mm. */
export interface SceneLabel {
  readonly at: Vec3;
  readonly text: string;
  readonly verdict: Verdict | null;
  /** A line through `at` that it lies beside, and shorter than which it has to be unless it is `first`. */
  readonly beside?: readonly [Vec3, Vec3];
  /** A place towards which it lies a little away from `at`. */
  readonly towards?: Vec3;
  /** Before all others, where there is not room for all. */
  readonly first?: boolean;
}

/** Which dimensions are written beside the design. */
export interface SceneDimensions {
  /** Those of every edge and every vertex with two edges. */
  readonly all: boolean;
  /** Edges by id. */
  readonly edges: readonly number[];
  /** Angles, by the ids of their vertex and of the vertices on both sides. */
  readonly corners: readonly { readonly vertex: number; readonly ends: readonly [number, number] }[];
  /** A distance that is measured, from place to place, mm. */
  readonly between: readonly [Vec3, Vec3] | null;
  /** A vertex that stays where it is when a length or an angle is typed. */
  readonly stays: number | null;
}
