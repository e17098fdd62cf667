/* Made by `make generate` from crates/api/schema. Do not edit. */

/**
 * What a person says to a question.
 */
export type Answer =
  | "yes"
  | "no"
  | "made"
  | "not-made"
  | "as-counted"
  | {
      part: PartOfStep;
    }
  | {
      head: number;
    };
/**
 * What the springback may depend on.
 */
export type ShapeName = "constant" | "moved" | "curve";
/**
 * What a profile describes.
 */
export type Kind = "machine" | "material" | "noise" | "strut-builder";
/**
 * A change that a person asks for. Lengths in mm, vertices and edges by their ids.
 */
export type EditRequest =
  | {
      edit: "draw";
      /**
       * The vertex that it begins at; none: at the first new one.
       */
      from?: number | null;
      /**
       * New vertices in order, mm.
       */
      through_mm?: [number, number, number][];
      /**
       * The vertex that it ends at; none: at the last new one.
       */
      to?: number | null;
    }
  | {
      /**
       * Its edges by the places of their vertices in the list, from 0.
       */
      edges: [number, number][];
      edit: "paste";
      vertices: PastedVertex[];
    }
  | {
      edges?: number[];
      edit: "delete";
      /**
       * Construction lines that are deleted with them, by their places in the list, from 0.
       */
      lines?: number[];
      vertices?: number[];
    }
  | {
      /**
       * How far, mm.
       *
       * @minItems 3
       * @maxItems 3
       */
      by_mm: [number, number, number];
      edit: "move";
      /**
       * Construction lines that go with them, by their places in the list, from 0.
       */
      lines?: number[];
      vertices: number[];
    }
  | {
      edit: "place";
      /**
       * Vertices and their positions, mm.
       */
      positions: Placed[];
    }
  | {
      edge: number;
      edit: "length";
      /**
       * More than 0.
       */
      length_mm: number;
      rest: RestPlace;
      /**
       * The end that stays where it is.
       */
      stays: number;
    }
  | {
      /**
       * More than 0, up to 180.
       */
      angle_deg: number;
      /**
       * The edge that stays and the one that turns about the vertex; none: the only two, of which the first drawn stays.
       *
       * @minItems 2
       * @maxItems 2
       */
      between?: [number, number] | null;
      edit: "angle";
      /**
       * The normal of the plane to turn in, of any length, where the edges are in line.
       *
       * @minItems 3
       * @maxItems 3
       */
      normal?: [number, number, number] | null;
      rest: RestPlace;
      vertex: number;
    }
  | {
      /**
       * Where: more than 0 (its first vertex), less than 1 (its second).
       */
      at: number;
      edge: number;
      edit: "split";
    }
  | {
      at: MergePlace;
      edit: "merge";
      vertices: number[];
    }
  | {
      edit: "transform";
      /**
       * Construction lines that go with them, by their places in the list, from 0.
       */
      lines?: number[];
      /**
       * On positions in mm.
       *
       * @minItems 4
       * @maxItems 4
       */
      matrix: [
        [number, number, number, number],
        [number, number, number, number],
        [number, number, number, number],
        [number, number, number, number]
      ];
      vertices: number[];
    }
  | {
      /**
       * Right-handed about the axis.
       */
      angle_deg: number;
      axis: AxisName;
      edit: "rotate";
      /**
       * Construction lines that go with them, by their places in the list, from 0.
       */
      lines?: number[];
      /**
       * A point of the axis, mm.
       *
       * @minItems 3
       * @maxItems 3
       */
      through_mm: [number, number, number];
      vertices: number[];
    }
  | {
      /**
       * Whether the image is added; otherwise the vertices themselves are moved.
       */
      copy: boolean;
      edit: "mirror";
      /**
       * Construction lines that go with them, by their places in the list, from 0.
       */
      lines?: number[];
      /**
       * The normal of the plane, of any length.
       *
       * @minItems 3
       * @maxItems 3
       */
      normal: [number, number, number];
      /**
       * A point of the plane, mm.
       *
       * @minItems 3
       * @maxItems 3
       */
      point_mm: [number, number, number];
      vertices: number[];
    }
  | {
      /**
       * How many copies are added.
       */
      count: number;
      edit: "array";
      /**
       * Construction lines that are copied with them, by their places in the list, from 0.
       */
      lines?: number[];
      /**
       * From each copy to the next.
       *
       * @minItems 4
       * @maxItems 4
       */
      step: [
        [number, number, number, number],
        [number, number, number, number],
        [number, number, number, number],
        [number, number, number, number]
      ];
      vertices: number[];
    }
  | {
      edit: "support";
      /**
       * Fixed or free.
       */
      support: boolean;
      vertices: number[];
    }
  | {
      edit: "joint";
      /**
       * What holds the struts together there; null takes it away.
       */
      joint?: Joint | null;
      vertices: number[];
    }
  | {
      /**
       * With or without the mark.
       */
      ceiling: boolean;
      edges: number[];
      edit: "ceiling";
    }
  | {
      edit: "weld";
      /**
       * How close, mm.
       */
      tolerance_mm: number;
    }
  | {
      edges: number[];
      edit: "detach";
    }
  | {
      /**
       * Its middle.
       *
       * @minItems 3
       * @maxItems 3
       */
      centre_mm: [number, number, number];
      /**
       * How many edges.
       */
      edges: number;
      edit: "circle";
      /**
       * Absent for the plane of its name.
       */
      on?: OwnPlane | null;
      plane: PlaneName;
      /**
       * To its vertices.
       */
      radius_mm: number;
    }
  | {
      /**
       * Its middle.
       *
       * @minItems 3
       * @maxItems 3
       */
      centre_mm: [number, number, number];
      edit: "polygon";
      measure: PolygonMeasure;
      /**
       * Absent for the plane of its name.
       */
      on?: OwnPlane | null;
      plane: PlaneName;
      sides: number;
      size_mm: number;
      /**
       * How far it is turned; at 0 a corner is on the first axis of the plane.
       */
      turn_deg?: number;
    }
  | {
      /**
       * The middle of its beginning.
       *
       * @minItems 3
       * @maxItems 3
       */
      centre_mm: [number, number, number];
      /**
       * Edges of a whole turn.
       */
      edges_per_turn: number;
      edit: "helix";
      /**
       * Left-handed.
       */
      left?: boolean;
      /**
       * Absent for the plane of its name.
       */
      on?: OwnPlane | null;
      /**
       * How far a turn rises; less than 0 goes down.
       */
      pitch_mm: number;
      plane: PlaneName;
      /**
       * To its vertices.
       */
      radius_mm: number;
      turns: number;
    }
  | {
      edit: "fillet";
      radius_mm: number;
      /**
       * What the wire is bent at most between two chords, degrees.
       */
      step_deg: number;
      /**
       * Corners: vertices with two edges.
       */
      vertices: number[];
    }
  | {
      /**
       * The chain, in any order.
       */
      edges: number[];
      edit: "straighten";
      /**
       * How far a vertex may be from the line, mm.
       */
      tolerance_mm: number;
    }
  | {
      /**
       * The chain, in any order.
       */
      edges: number[];
      edit: "round";
      /**
       * No edge of an arc is shorter, mm.
       */
      least_edge_mm?: number;
      /**
       * How far an edge goes round an arc at most, degrees: what the wire is bent at each of its vertices.
       */
      step_deg: number;
      /**
       * How far the chain may be from its lines and arcs, mm.
       */
      tolerance_mm: number;
    }
  | {
      edges: number[];
      edit: "doublings";
    }
  | {
      edit: "start";
      vertex?: number | null;
    }
  | {
      edit: "wires";
      wires: number;
    }
  | {
      closed: boolean;
      edit: "closed";
    }
  | {
      edit: "reversed";
      reversed: boolean;
    }
  | {
      edit: "walks";
      walks: ChosenWalk[];
    }
  | {
      clearance_mm: number;
      edit: "collisions";
      sag: boolean;
    }
  | {
      edit: "pause";
      /**
       * What the person has to do there; null takes the pause point away.
       */
      note?: string | null;
      /**
       * Which time the wires come there, from 1, over all wires in their order.
       */
      pass?: number;
      vertex: number;
    }
  | {
      edit: "machine";
      /**
       * Its id.
       */
      machine: string;
      /**
       * The material's id.
       */
      material?: string | null;
    }
  | {
      edit: "notes";
      text: string;
    }
  | {
      edit: "units";
      units: LengthUnit;
    }
  | {
      change: ConstructionChange;
      edit: "construction";
    }
  | {
      edit: "remove-stencil";
      stencil: number;
    }
  | {
      edit: "place-stencil";
      placement: Placement;
      stencil: number;
    }
  | {
      /**
       * Right-handed about the axis.
       */
      angle_deg: number;
      axis: AxisName;
      edit: "turn-stencil";
      stencil: number;
    }
  | {
      edit: "stencil-look";
      look: Look;
      stencil: number;
    }
  | {
      edge: number;
      edit: "part-look";
      look: Look;
    }
  | {
      edit: "several";
      /**
       * The changes; each finds the design as the ones before it have left it.
       */
      edits: EditRequest[];
      /**
       * What a menu calls them together, after "Undo".
       */
      label: string;
    };
/**
 * How struts are held together.
 */
export type JointKind = ("solder" | "zip-tie") | "snap-fit";
/**
 * What happens to the rest of the wireframe beyond a vertex that goes elsewhere.
 */
export type RestPlace = "stays" | "follows";
/**
 * Where the vertex goes that others are merged into.
 */
export type MergePlace = "last" | "first" | "centre";
/**
 * An axis of the frame of the design.
 */
export type AxisName = "x" | "y" | "z";
/**
 * A plane of two axes. The first is the first of its name.
 */
export type PlaneName = "xy" | "xz" | "yz";
/**
 * What the size of a regular polygon is.
 */
export type PolygonMeasure = "corners" | "flats" | "side";
/**
 * What the numbers of a file measure.
 */
export type LengthUnit = ("mm" | "cm" | "m") | "inch";
/**
 * What becomes of construction lines. They are named by their places in the list, from 0.
 */
export type ConstructionChange =
  | {
      make: "draw";
      /**
       * Two places or more in order, mm: a line between each and the next.
       */
      through_mm: [number, number, number][];
    }
  | {
      edges: number[];
      make: "lines";
    }
  | {
      lines: number[];
      make: "edges";
    }
  | {
      lines: number[];
      make: "nothing";
    };
/**
 * Red, green and blue as the screen takes them: "#7f93ab".
 */
export type Colour = string;
/**
 * How joints are closed.
 */
export type ClosingName = "aligned" | "coupled";
/**
 * The faces that are to be flat, by the ids of their vertices: `[[0, 1, 2, 3], [4, 5, 6, 7]]`.
 */
export type FacesChoice =
  | {
      input: Input;
    }
  | {
      vertices: number[][];
    };
/**
 * Where the bytes come from.
 */
export type Input =
  | {
      file: string;
    }
  | {
      bytes: {
        bytes: number[];
        name: string;
      };
    };
/**
 * Where a frame is held; a vertex that is held can neither move nor turn.
 */
export type FrameSupports =
  | "design"
  | "free"
  | {
      vertices: number[];
    };
/**
 * Which way a positive rotation of a table turns the axis of the next bend.
 */
export type Handedness = "right" | "left";
/**
 * What the steps of a program are.
 */
export type ProgramKind = "nominal" | "compensated";
/**
 * How short edges may be that are made of the curves of a drawing.
 */
export type ShortestEdge =
  | "machine"
  | {
      mm: number;
    };
/**
 * An order for a connected machine. STOP is none of these: it is always possible.
 */
export type Order =
  | {
      order: "home";
    }
  | {
      moves: Move[];
      order: "jog";
      /**
       * Whether those that are done are kept for a recording.
       */
      record?: boolean;
    }
  | {
      /**
       * Whether to bend it although the machine's settings are not those of its profile.
       */
      accept_settings?: boolean;
      /**
       * Whether to bend it although a check says that the machine cannot make it.
       */
      despite_errors?: boolean;
      order: "arm";
      repeat?: Repeat;
      /**
       * Index of the one wire to bend, from 0; absent, all of them, one after the other: before each a person is asked.
       */
      wire?: number | null;
    }
  | {
      order: "disarm";
    }
  | {
      order: "start";
    }
  | {
      order: "pause";
    }
  | {
      order: "resume";
    }
  | {
      order: "speed";
      /**
       * Percent of the programmed speed.
       */
      percent: number;
    }
  | {
      /**
       * Whether to bend it although the machine's settings are not those of its profile.
       */
      accept_settings?: boolean;
      /**
       * What became of the first step in doubt; absent, the user is asked.
       */
      decided?: Decided | null;
      job_hash: string;
      order: "resume-run";
      /**
       * Index of the wire, from 0.
       */
      wire: number;
    }
  | {
      job_hash: string;
      order: "abandon";
      /**
       * Index of the wire, from 0.
       */
      wire: number;
    }
  | {
      /**
       * The recording; absent, the moves that are recorded now.
       */
      file?: string | null;
      order: "replay";
      /**
       * Whether to replay those of a file although they were recorded on another machine, or before its profile was changed.
       */
      other_machine?: boolean;
    }
  | {
      /**
       * Whether to do it although the machine's settings are not those of its profile.
       */
      accept_settings?: boolean;
      /**
       * Whether to do it although a check says that the machine cannot make the wire.
       */
      despite_errors?: boolean;
      order: "dry-run";
      /**
       * Index of the wire, from 0.
       */
      wire: number;
    }
  | {
      order: "write-settings";
    }
  | {
      line: string;
      order: "console";
    }
  | {
      order: "disconnect";
    };
/**
 * One axis by an amount, in canonical signs, or homing.
 */
export type Move =
  | {
      move: "home";
    }
  | {
      /**
       * By so much; below 0 back into the machine.
       */
      mm: number;
      move: "feed";
    }
  | {
      /**
       * By so much, right-handed about the direction of travel.
       */
      deg: number;
      move: "rotate";
    }
  | {
      /**
       * By so much.
       */
      deg: number;
      move: "bend";
    };
/**
 * What a person says of a step in doubt.
 */
export type Decision =
  | "made"
  | "not-made"
  | "as-counted"
  | {
      part: PartOfStep;
    };
/**
 * What a sequence is written as.
 */
export type SequenceFormat = "wirebend" | "framefab" | "assembly-instances" | "vtk";
/**
 * What is placed at once.
 */
export type GroupBy = "edge" | "wire";
/**
 * What lengths in messages are written in.
 */
export type ShownUnit = "mm" | "inch";
/**
 * Which motions are off.
 */
export type VaryName = "feed" | "angle" | "both";

export interface All {
  requests: Requests;
}
export interface Requests {
  about: AboutRequest;
  answer: AnswerMachine;
  "apply-calibration": ApplyCalibration;
  "avoid-collisions": AvoidCollisions;
  "by-hand": ByHandRequest;
  "calibrate-compare": CalibrateCompareRequest;
  "calibrate-enter": CalibrateEnterRequest;
  "calibrate-fit": CalibrateFitRequest;
  "calibrate-new": CalibrateNewRequest;
  "calibrate-sheet": CalibrationSheetRequest;
  "change-settings": ChangeSettings;
  check: CheckDesign;
  "check-run-file": CheckRunFile;
  "clear-recent": ClearRecent;
  "clear-recording": ClearRecording;
  close: CloseDesign;
  "close-run-file": CloseRunFile;
  collisions: CheckCollisions;
  compare: CompareDesign;
  connect: ConnectMachine;
  "copy-profile": CopyProfile;
  discard: DiscardUnsaved;
  "draw-head": HeadRequest;
  "driver-trust": DriverTrustRequest;
  drivers: DriversRequest;
  edit: EditDesign;
  examples: ExamplesRequest;
  export: ExportDesign;
  "export-profile": ProfileExportRequest;
  exports: ExportsRequest;
  "fix-all": FixAllRequest;
  fixes: FixesRequest;
  frame: FrameDesign;
  "frame-choices": FrameChoicesRequest;
  "import-profile": ImportProfile;
  "load-cases": LoadCasesRequest;
  look: LookRequest;
  "machine-state": MachineStateRequest;
  "machine-view": MachineViewRequest;
  machines: MachinesRequest;
  made: MadeRequest;
  materials: MaterialsRequest;
  new: NewDesign;
  open: OpenDesign;
  "open-example": OpenExample;
  "open-run-file": OpenRunFile;
  order: OrderMachine;
  outcome: OutcomeRequest;
  ports: PortsRequest;
  predict: PredictionRequest;
  "profile-explain": ProfileExplainRequest;
  "profile-view": ProfileViewRequest;
  program: ProgramRequest;
  "put-stencil": PutStencil;
  "put-wireframe": PutWireframe;
  recorded: RecordedRequest;
  redo: Redo;
  restore: RestoreUnsaved;
  "revert-profile": RevertProfile;
  "run-file": RunFileRequest;
  runs: RunsRequest;
  "runs-show": RunsShowRequest;
  save: SaveDesign;
  "save-frame": SaveFrame;
  "save-job": SaveJob;
  "save-recording": SaveRecording;
  "save-wireframe": SaveWireframe;
  sequence: SequenceDesign;
  "set-profile": SetProfile;
  "show-lengths": ShowLengths;
  start: Start;
  "stop-avoiding": StopAvoiding;
  "stop-collisions": StopCollisions;
  "stop-frame": StopFrame;
  "stop-prediction": StopPrediction;
  "stop-sequence": StopSequence;
  tolerance: ToleranceDesign;
  undo: Undo;
}
/**
 * Asks what this program is.
 */
export interface AboutRequest {}
/**
 * Answers what was asked.
 */
export interface AnswerMachine {
  answer: Answer;
  question: number;
}
/**
 * How much of a step is in the wire, in canonical signs; a driver and its journal have the same in the machine's signs. What it bends counts for nothing: a bend starts from its beginning.
 */
export interface PartOfStep {
  /**
   * Fed, mm of wire.
   */
  feed_mm: number;
  /**
   * Turned, degrees.
   */
  rotate_deg: number;
}
/**
 * Writes a version of the machine and of the wire with what a sheet tells, to the person's own profiles.
 */
export interface ApplyCalibration {
  /**
   * Whether profiles of these ids may be replaced.
   */
  force?: boolean;
  /**
   * Id of the new version of the machine.
   */
  machine_id: string;
  /**
   * Id of the new version of the wire.
   */
  material_id: string;
  /**
   * What the springback depends on; what predicts best if absent.
   */
  shape?: ShapeName | null;
  /**
   * The sheet.
   */
  sheet: string;
}
/**
 * Searches for wires of the design that hit nothing. A search that is under way is ended.
 */
export interface AvoidCollisions {
  settings?: SearchSettings;
}
/**
 * How to search; what is left out is as on the command line.
 */
export interface SearchSettings {
  /**
   * How many steps may be checked for each number of wires; absent, 20,000.
   */
  effort?: number | null;
  /**
   * Where chance begins; absent, 1.
   */
  seed?: number | null;
  /**
   * What makes one program better than another; absent: fewest wires, then the least doubled length, then the least time.
   */
  weights?: SearchWeights | null;
  /**
   * How many wires there may be; absent, as many as the design has, and where it has one, up to 32.
   */
  wires?: number | null;
}
/**
 * What each part of a program costs a search, in a unit of the person's own: the program with the least sum is the best.
 */
export interface SearchWeights {
  /**
   * A millimetre that is doubled.
   */
  doubled_mm?: number;
  /**
   * A second of turns of the head and of bends.
   */
  second?: number;
  /**
   * A wire.
   */
  wire?: number;
}
/**
 * Asks for the wire that moves by hand have bent since the machine was homed or connected.
 */
export interface ByHandRequest {}
export interface CalibrateCompareRequest {
  /**
   * The two machines; each with the wire that it names, the one that a sheet is of with the wire of the sheet.
   *
   * @minItems 2
   * @maxItems 2
   */
  machines: [string, string];
  /**
   * A sheet whose readings both are held against.
   */
  sheet?: string | null;
}
export interface CalibrateEnterRequest {
  /**
   * Jobs of coupons that a simulated machine has bent: the readings are those of its wires.
   */
  bent?: string[];
  /**
   * Tables of pin angle and springback angle.
   */
  pin_tables?: string[];
  /**
   * Readings as they are typed, such as `angle-40:1=38.5,39`.
   */
  readings?: string[];
  /**
   * The sheet.
   */
  sheet: string;
}
export interface CalibrateFitRequest {
  /**
   * What the springback depends on; what predicts best if absent.
   */
  shape?: ShapeName | null;
  /**
   * The sheet.
   */
  sheet: string;
}
export interface CalibrateNewRequest {
  /**
   * Angles of the ladder, degrees; a usual set if empty.
   */
  angles_deg?: number[];
  /**
   * Where jobs and sheet go. It is created where it is missing.
   */
  folder: string;
  /**
   * Whether files that are there may be replaced.
   */
  force?: boolean;
  /**
   * The machine, by id.
   */
  machine: string;
  /**
   * The wire, by id; the one that the machine names if absent.
   */
  material?: string | null;
  /**
   * What the sheet is printed on, `a4` or `letter`; A4 if absent.
   */
  paper?: string | null;
  /**
   * How often each coupon is bent.
   */
  repeats: number;
}
export interface CalibrationSheetRequest {
  /**
   * The sheet.
   */
  sheet: string;
}
/**
 * Changes the driver's settings in a profile of the person's own.
 */
export interface ChangeSettings {
  machine: string;
  /**
   * All settings that the profile is to set; what is left out is its parent's, or the driver's default.
   */
  settings: {
    [k: string]: unknown;
  };
}
/**
 * Checks the design on its machine, with some vertices elsewhere than they are.
 */
export interface CheckDesign {
  /**
   * Vertices that are being dragged.
   */
  moved?: Moved[];
}
/**
 * A vertex that is being dragged, and where it is.
 */
export interface Moved {
  /**
   * @minItems 3
   * @maxItems 3
   */
  at_mm: [number, number, number];
  vertex: number;
}
/**
 * Checks what is open with the profiles as they are now, as it was read: another file in its place is not looked at.
 */
export interface CheckRunFile {}
/**
 * Empties the list of what was open before.
 */
export interface ClearRecent {}
/**
 * Forgets the moves that were recorded.
 */
export interface ClearRecording {}
/**
 * Closes the design; what is not saved is gone. An empty one takes its place.
 */
export interface CloseDesign {}
/**
 * Closes it: the design is shown and run again.
 */
export interface CloseRunFile {}
/**
 * Checks the design for collisions, with some vertices elsewhere than they are. One that is under way is stopped.
 */
export interface CheckCollisions {
  /**
   * Vertices that are being dragged.
   */
  moved?: Moved[];
}
/**
 * Plans the open design for other machines and says what changes.
 */
export interface CompareDesign {
  /**
   * The other machines.
   */
  against: string[];
}
/**
 * Connects the machine of the open design, or of what is open to be run. One that was connected before is let go.
 */
export interface ConnectMachine {
  /**
   * Where it is; absent, the machine that its driver simulates is taken, if it has one.
   */
  port?: string | null;
  simulated_as?: SimulatedAs & {
    [k: string]: unknown;
  };
}
/**
 * The bender and the wire of a simulated machine where they are others than those that the wire was planned for, so
 * that they differ from what the profiles say as those of a real machine do.
 */
export interface SimulatedAs {
  /**
   * Id of the machine whose bend head it has; absent, that of the job.
   */
  machine?: string | null;
  /**
   * Id of the material of the wire that it bends; absent, that of the job.
   */
  material?: string | null;
}
/**
 * Writes a profile of the person's own that inherits from another.
 */
export interface CopyProfile {
  /**
   * The one to inherit from.
   */
  from: string;
  /**
   * The id of the new one.
   */
  id: string;
  kind: Kind;
  name: string;
}
/**
 * Throws away a design that was open when the program or the computer stopped.
 */
export interface DiscardUnsaved {
  journal: string;
}
/**
 * Asks how the bend head of a machine of the person's own would be with values that are typed and not written yet.
 */
export interface HeadRequest {
  id: string;
  /**
   * As in [`ProfileViewRequest`].
   */
  material?: string | null;
  values: NewValue[];
}
/**
 * A value to set.
 */
export interface NewValue {
  /**
   * Dotted key.
   */
  key: string;
  /**
   * The plain value; of a figure without its source.
   */
  value: {
    [k: string]: unknown;
  };
}
/**
 * Which library to accept. A user who accepts it has to name its hash, which this command shows when it is
 * not named: then nothing is accepted and nothing is run.
 */
export interface DriverTrustRequest {
  library: string;
  /**
   * Its SHA-256.
   */
  sha256?: string | null;
}
/**
 * Asks for the drivers.
 */
export interface DriversRequest {}
/**
 * Makes a change.
 */
export interface EditDesign {
  request: EditRequest;
}
/**
 * A vertex of a piece.
 */
export interface PastedVertex {
  /**
   * @minItems 3
   * @maxItems 3
   */
  at_mm: [number, number, number];
  /**
   * What holds the struts together there.
   */
  joint?: Joint | null;
  /**
   * Whether the design holds it fixed.
   */
  support?: boolean;
}
/**
 * What holds struts together at a vertex.
 */
export interface Joint {
  kind: JointKind;
  /**
   * What it weighs, in g.
   */
  mass_g: number;
}
/**
 * A vertex and where it goes.
 */
export interface Placed {
  /**
   * @minItems 3
   * @maxItems 3
   */
  at_mm: [number, number, number];
  vertex: number;
}
/**
 * A plane that is none of the axes. What lies on it is given along its first axis, along its second, and off it, from where it was put.
 */
export interface OwnPlane {
  /**
   * Where it was put.
   *
   * @minItems 3
   * @maxItems 3
   */
  origin_mm: [number, number, number];
  /**
   * Its first axis, of any length.
   *
   * @minItems 3
   * @maxItems 3
   */
  u: [number, number, number];
  /**
   * Its second: of what it has across the first, the direction counts.
   *
   * @minItems 3
   * @maxItems 3
   */
  v: [number, number, number];
}
/**
 * The way of one wire along the edges.
 */
export interface ChosenWalk {
  /**
   * The edges in the order in which it runs along them.
   */
  edges: number[];
  /**
   * The vertex where it starts.
   */
  start: number;
}
/**
 * How a stencil lies in the design. It is scaled and turned about the middle of its box, and that is moved.
 */
export interface Placement {
  /**
   * How much larger than in its file it is.
   */
  scale?: number;
  /**
   * How far it is moved along x, y and z, mm.
   *
   * @minItems 3
   * @maxItems 3
   */
  shift_mm?: [number, number, number];
  /**
   * How far it is turned about the x axis, then about the y axis, then about the z axis of the design, degrees.
   *
   * @minItems 3
   * @maxItems 3
   */
  turn_deg?: [number, number, number];
}
/**
 * What it is called, its colour, and whether it is hidden. None of it changes what is bent.
 */
export interface Look {
  /**
   * Absent for the usual one.
   */
  colour?: Colour | null;
  /**
   * Whether it is left out of the view.
   */
  hidden?: boolean;
  /**
   * Empty where nobody has named it.
   */
  name?: string;
}
/**
 * Asks for the examples.
 */
export interface ExamplesRequest {}
/**
 * Writes the open design, or shows what would be written.
 */
export interface ExportDesign {
  /**
   * Whether all of what would be written is returned too, to be looked at as it will be.
   */
  contents?: boolean;
  /**
   * Whether to write a program although a check says that it cannot be made.
   */
  despite_errors?: boolean;
  format: string;
  /**
   * Where it goes; absent, its beginning is returned.
   */
  output?: Output | null;
  /**
   * Its settings, over those of the machine's profile.
   */
  settings?: {
    [k: string]: unknown;
  };
}
/**
 * A file to write a result to.
 */
export interface Output {
  /**
   * Whether a file that is there may be replaced.
   */
  force?: boolean;
  path: string;
}
/**
 * Which profile another person shall have.
 */
export interface ProfileExportRequest {
  /**
   * Without the other profiles of the person's own that it names.
   */
  alone?: boolean;
  id: string;
  /**
   * The kind of profile, where several kinds have one of the id.
   */
  kind?: Kind | null;
  /**
   * Its file; absent, the profile goes back to the front end.
   */
  output?: Output | null;
}
/**
 * Asks what can be written for the machine of the open design.
 */
export interface ExportsRequest {}
/**
 * Asks what would fix all that the checks say of a kind, as one change. A search for the same kind that is under way is
 * stopped.
 */
export interface FixAllRequest {
  /**
   * The kind, by its code.
   */
  code: string;
}
/**
 * Asks what would fix what the checks say.
 */
export interface FixesRequest {
  /**
   * Of collisions, instead of all else: each fix is tried with a check for collisions, which takes longer.
   */
  collisions?: boolean;
}
/**
 * Computes the open design as a frame.
 */
export interface FrameDesign {
  /**
   * Struts that bow while it vibrates, beside straight ones.
   */
  bow?: BowChoice | null;
  /**
   * How its joints are closed, where that is asked for.
   */
  close?: ClosingChoice | null;
  /**
   * Whether wires may run along edges twice where there is no route otherwise.
   */
  double?: boolean;
  /**
   * Forces at vertices, besides.
   */
  forces?: VertexForce[];
  /**
   * Gravity along x, y and z, as multiples of standard gravity; absent: that of the loads, and without loads 1 against z.
   *
   * @minItems 3
   * @maxItems 3
   */
  gravity?: [number, number, number] | null;
  /**
   * What acts on it besides, from a file.
   */
  loads?: LoadsChoice | null;
  /**
   * Absent: that of the design.
   */
  material?: string | null;
  /**
   * How many modes to look for, the rigid ones aside.
   */
  modes?: number;
  supports?: FrameSupports;
}
/**
 * Struts that are not straight, as wire is that comes from a coil: each is an arc, in a direction of its own.
 */
export interface BowChoice {
  /**
   * Where the random directions start: the same seed draws the same struts.
   */
  seed?: number;
  /**
   * From the chord of each strut to the middle of its arc, as a share of its length.
   */
  share: number;
}
/**
 * How joints are closed, and what is off.
 */
export interface ClosingChoice {
  closing?: ClosingName & string;
  /**
   * The errors: the id of a noise profile.
   */
  errors: string;
  /**
   * The faces that are to be flat. Absent, all vertices count, after the motion of the whole that fits them best.
   */
  faces?: FacesChoice | null;
  /**
   * How many wires are drawn; 0: none, the exact expectation over all of them, which there is for straight struts alone.
   */
  runs: number;
  /**
   * Where the random numbers start.
   */
  seed: number;
  /**
   * Where the first drawn wire goes once its joints are closed, as a VTK file.
   */
  vtk?: Output | null;
}
/**
 * A force at a vertex.
 */
export interface VertexForce {
  /**
   * Along x, y and z.
   *
   * @minItems 3
   * @maxItems 3
   */
  force_n: [number, number, number];
  vertex: number;
}
/**
 * Loads from a file.
 */
export interface LoadsChoice {
  /**
   * Which of them; absent, the only one.
   */
  case?: string | null;
  file: Input;
}
/**
 * Asks what there is to choose from for frames.
 */
export interface FrameChoicesRequest {}
/**
 * Takes in a profile from a file.
 */
export interface ImportProfile {
  file: string;
  /**
   * Another id than that of the file.
   */
  id?: string | null;
}
/**
 * Asks which load cases a file has for the open design.
 */
export interface LoadCasesRequest {
  file: Input;
}
/**
 * What to look into.
 */
export interface LookRequest {
  design: DesignInput;
}
/**
 * A design and how to read it. A `.wirebend` document is taken as it is.
 */
export interface DesignInput {
  /**
   * Centreline radius of the bends of a table that does not say, in mm.
   */
  clr_mm?: number | null;
  /**
   * Whether the edges of faces are the wireframe.
   */
  face_edges?: boolean;
  /**
   * Its format, where name and contents do not show it.
   */
  format?: string | null;
  /**
   * Which way the rotations of a table of bends turn, where the table does not say.
   */
  handedness?: Handedness | null;
  input: Input;
  /**
   * The layers of a drawing to read; empty: all that are not hidden.
   */
  layers?: string[];
  /**
   * What the steps of a program are, where the program does not say.
   */
  program?: ProgramKind | null;
  /**
   * Factor on all coordinates, after units.
   */
  scale?: number;
  /**
   * How short edges of the curves of a drawing may be, although they may be farther off for that; absent: as short as
   * the tolerance asks for.
   */
  shortest_edge?: ShortestEdge | null;
  /**
   * How far straight edges may be from the curves of a drawing, in mm.
   */
  tolerance_mm?: number;
  /**
   * The unit of the coordinates, where the file does not say.
   */
  units?: LengthUnit | null;
  /**
   * Vertices closer than this become one, in mm.
   */
  weld_mm?: number;
}
/**
 * Asks how the machine stands.
 */
export interface MachineStateRequest {}
/**
 * Asks for one machine.
 */
export interface MachineViewRequest {
  /**
   * Its id.
   */
  machine: string;
}
/**
 * Asks for the machines.
 */
export interface MachinesRequest {}
/**
 * Asks how the machine bends the open design, or what is open to be run.
 */
export interface MadeRequest {}
/**
 * Asks for the materials.
 */
export interface MaterialsRequest {}
/**
 * Begins an empty design.
 */
export interface NewDesign {
  /**
   * Its machine; absent, that of the design before.
   */
  machine?: string | null;
}
/**
 * Opens a file as the design: a wireframe, a drawing, a program, or a stencil to trace on.
 */
export interface OpenDesign {
  design: DesignInput;
}
export interface OpenExample {
  id: string;
}
/**
 * Opens a job, a program in the format of the design's machine, or a recording, to be shown and run.
 */
export interface OpenRunFile {
  file: Input;
}
/**
 * Says what the connected machine is to do.
 */
export interface OrderMachine {
  request: Order;
}
/**
 * How many pieces are bent in a row, and from how much wire.
 */
export interface Repeat {
  /**
   * Whether the machine cuts each piece off. As long as the wire that is loaded suffices, the next one is bent without a question.
   */
  cut?: boolean;
  pieces: number;
  /**
   * Length of the wire that is loaded, mm: as long as it suffices, no new wire is asked for. Absent, it is not known.
   */
  stock_mm?: number | null;
}
/**
 * What a person says of one step. It counts for that step alone, however often it is said.
 */
export interface Decided {
  /**
   * The step, from 1.
   */
  step: number;
  what: Decision;
}
/**
 * Asks what a fillet or a shape would make, without making it.
 */
export interface OutcomeRequest {
  request: EditRequest;
}
/**
 * Asks for the ports.
 */
export interface PortsRequest {
  /**
   * For the machines of this driver; absent, of every driver.
   */
  driver?: string | null;
  /**
   * For this machine; absent, for every machine.
   */
  machine?: string | null;
}
/**
 * Asks how far off the wires of a job will be.
 */
export interface PredictionRequest {
  /**
   * The noise profile: how far off single motions are.
   */
  noise: string;
  /**
   * How often each wire is bent.
   */
  runs: number;
  /**
   * Where the random numbers start: the same seed, the same wires.
   */
  seed: number;
  /**
   * How close each vertex, taken by itself, has to be to its place in 95 % of the wires, mm; then the answer says how exact a machine must be.
   */
  within_mm?: number | null;
}
export interface ProfileExplainRequest {
  id: string;
  /**
   * Its kind, where several kinds have a profile with this id.
   */
  kind?: Kind | null;
}
/**
 * Asks for a profile with what its editor needs.
 */
export interface ProfileViewRequest {
  id: string;
  kind: Kind;
  /**
   * The wire that the head of a machine is drawn with; absent: its own.
   */
  material?: string | null;
}
/**
 * Asks for the program of the open design, or of what is open to be run.
 */
export interface ProgramRequest {}
/**
 * Puts the surface of a file into the design, to trace on.
 */
export interface PutStencil {
  design: DesignInput;
}
/**
 * Adds the wireframe of a file to the design, where it lies in the file.
 */
export interface PutWireframe {
  design: DesignInput;
}
/**
 * Asks for the moves that were recorded.
 */
export interface RecordedRequest {}
/**
 * Does again what was undone last.
 */
export interface Redo {}
/**
 * Restores a design that was open when the program or the computer stopped.
 */
export interface RestoreUnsaved {
  journal: string;
}
/**
 * Takes back values of a profile of the person's own.
 */
export interface RevertProfile {
  id: string;
  /**
   * Dotted keys; none: the last change as a whole.
   */
  keys: string[];
  kind: Kind;
  /**
   * As in [`ProfileViewRequest`].
   */
  material?: string | null;
}
/**
 * Asks which is open.
 */
export interface RunFileRequest {}
/**
 * Asks for the records of what was bent.
 */
export interface RunsRequest {}
/**
 * Asks for one record.
 */
export interface RunsShowRequest {
  /**
   * Its id, or enough of its beginning.
   */
  id: string;
}
/**
 * Saves the design as a `.wirebend` document.
 */
export interface SaveDesign {
  /**
   * Where; absent, where it was opened or saved before.
   */
  path?: string | null;
}
/**
 * Writes what a frame carries for other programs.
 */
export interface SaveFrame {
  files: FrameFiles;
  frame: FrameDesign;
}
/**
 * What is written of a loaded frame for other programs.
 */
export interface FrameFiles {
  /**
   * The frame as it is computed, for conmech, and what acts on it: `NAME.json` and `NAME-loads.json`.
   */
  conmech?: Output | null;
  /**
   * The same as tables: `NAME-nodes.csv` and `NAME-members.csv` for `NAME.csv`.
   */
  csv?: Output | null;
  /**
   * How far displacements are enlarged in the model; 1 is true scale.
   */
  displacement_scale?: number;
  /**
   * The deformed shape as a model, binary glTF.
   */
  glb?: Output | null;
  /**
   * Displacements and forces for a program that shows them, as a VTK file.
   */
  vtk?: Output | null;
}
/**
 * Plans the open design and writes the job.
 */
export interface SaveJob {
  /**
   * Whether to write a job although a check says that it cannot be made.
   */
  despite_errors?: boolean;
  output: Output;
}
/**
 * Writes the moves that were recorded.
 */
export interface SaveRecording {
  output: Output;
}
/**
 * Writes the wireframe of the open design as an OBJ, which other programs edit.
 */
export interface SaveWireframe {
  output: Output;
}
/**
 * Looks for an order in which a machine builds the struts of the open design, or checks one. A search that is under way is stopped.
 */
export interface SequenceDesign {
  /**
   * How far a joint may be from where it is drawn, mm; absent, what the head still meets.
   */
  epsilon_mm?: number | null;
  /**
   * A file with the order to check.
   */
  file?: string | null;
  format?: SequenceFormat;
  group_by?: GroupBy;
  /**
   * How long is searched, s; absent, 120.
   */
  limit_s?: number | null;
  /**
   * The machine that builds the struts.
   */
  machine: string;
  /**
   * Absent: that of the design.
   */
  material?: string | null;
  /**
   * The order to check; absent, that of `file`, or one is looked for.
   */
  order?: OrderedStep[] | null;
  /**
   * Where an order goes that can be built.
   */
  output?: Output | null;
}
/**
 * A step where a person wants it.
 */
export interface OrderedStep {
  /**
   * The direction of the head's axis that is tried first; where it is not free, and where it is absent, all of the machine are.
   *
   * @minItems 3
   * @maxItems 3
   */
  direction?: [number, number, number] | null;
  edge: number;
  /**
   * All edges of a wire or rod, which is fastened wherever it meets what is built by then; not there for a strut that is drawn.
   */
  edges?: number[];
  /**
   * The vertex from which the head draws it, where that is built by then; otherwise it is its other end.
   */
  from_vertex?: number | null;
}
/**
 * Sets values of a profile of the person's own.
 */
export interface SetProfile {
  id: string;
  kind: Kind;
  /**
   * As in [`ProfileViewRequest`].
   */
  material?: string | null;
  /**
   * Whether they were measured on the machine or the wire.
   */
  measured: boolean;
  /**
   * Where the values come from.
   */
  source: string;
  values: NewValue[];
}
/**
 * Chooses the unit of the lengths in messages. Figures that are numbers stay in millimetres.
 */
export interface ShowLengths {
  unit: ShownUnit;
}
/**
 * What a window needs when it opens.
 */
export interface Start {}
/**
 * Ends the search for wires that hit nothing: it answers with the best that it has.
 */
export interface StopAvoiding {}
/**
 * Stops the check for collisions that is under way, and the search for what would fix them.
 */
export interface StopCollisions {}
/**
 * Stops computing the frame that is under way.
 */
export interface StopFrame {}
/**
 * Stops the prediction that is under way.
 */
export interface StopPrediction {}
/**
 * Stops the search for a sequence that is under way.
 */
export interface StopSequence {}
/**
 * Asks how good a machine must be for the open design.
 */
export interface ToleranceDesign {
  closing?: ClosingName & string;
  /**
   * In place of the design a truss of many rings, by closed formulas.
   */
  continuum?: ContinuumChoice | null;
  /**
   * Whether wires may run along edges twice where there is no route otherwise.
   */
  double?: boolean;
  /**
   * The faces that are to be flat. Absent, all vertices count.
   */
  faces?: FacesChoice | null;
  /**
   * Absent: that of the design.
   */
  material?: string | null;
  required: RequirementsChoice;
  vary?: VaryName;
}
/**
 * A tetrahedral truss of many rings, by closed formulas.
 */
export interface ContinuumChoice {
  /**
   * How far its struts bow, as a share of their length: that changes its frequency alone.
   */
  bow?: number;
  depth_mm: number;
  diameter_mm: number;
  /**
   * Rings around the middle triangle.
   */
  rings: number;
}
/**
 * What is required of a closed frame.
 */
export interface RequirementsChoice {
  /**
   * Force along a strut, RMS.
   */
  force_n?: number | null;
  /**
   * Von Mises stress, RMS.
   */
  stress_mpa?: number | null;
  /**
   * How far the faces may be off, RMS.
   */
  surface_mm?: number | null;
}
/**
 * Undoes the last change.
 */
export interface Undo {}
