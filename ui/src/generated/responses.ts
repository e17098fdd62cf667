/* Made by `make generate` from crates/app/schema. Do not edit. */

/**
 * An order without its particulars, such as for a button.
 */
export type OrderName =
  | "home"
  | "jog"
  | "arm"
  | "disarm"
  | "start"
  | "pause"
  | "resume"
  | "resume-run"
  | "abandon"
  | "replay"
  | "write-settings"
  | "disconnect";
/**
 * What the machine is in.
 */
export type Phase =
  | "connecting"
  | "connected"
  | "homing"
  | "ready"
  | "moving"
  | "armed"
  | "making"
  | "holding"
  | "stopping"
  | "stopped"
  | "failed"
  | "closed";
/**
 * What a question is about.
 */
export type QuestionKind = "move" | "arm" | "go-on" | "doubt" | "said" | "head" | "settings";
/**
 * Who says that a step is made.
 */
export type DoneBy = "machine" | "clock";
/**
 * What a body moves with.
 */
export type Part = "frame" | "head" | "peg";
/**
 * A solid about its own centre.
 */
export type Solid =
  | {
      box: {
        /**
         * Its edges along x, y and z, millimetres.
         *
         * @minItems 3
         * @maxItems 3
         */
        size_mm: [number, number, number];
      };
    }
  | {
      cylinder: {
        /**
         * Its length, millimetres.
         */
        length_mm: number;
        /**
         * Its radius, millimetres.
         */
        radius_mm: number;
      };
    };
/**
 * How bad it is.
 */
export type SeverityName = "error" | "warning" | "info";
/**
 * What the numbers of a file measure.
 */
export type LengthUnit = "mm" | "cm" | "m" | "inch";
/**
 * One axis by an amount, in canonical signs, or the search for the reference.
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
 * What a profile describes.
 */
export type Kind = "machine" | "material" | "noise";
/**
 * Something that a driver can do.
 */
export type Capability = "export" | "live" | "jog" | "home" | "pause" | "resume" | "stop" | "ports" | "settings";
/**
 * What a format holds.
 */
export type Content = "design" | "machine";
/**
 * How many files come of several wires.
 */
export type Files = "each-wire" | "one";
/**
 * Whether a driver can be used.
 */
export type DriverState = "shipped" | "accepted" | "unknown" | "changed" | "refused";
/**
 * Where a sample lies among the pairs of its table.
 */
export type SamplePlace = "pair" | "between" | "beyond";
/**
 * A change that a person asks for. Lengths in mm, vertices and edges by their ids.
 */
export type EditRequest =
  | {
      edit: "draw";
      /**
       * The vertex that it begins at; none: at the first new one.
       */
      from: number | null;
      /**
       * New vertices in order, mm.
       */
      through_mm: [number, number, number][];
      /**
       * The vertex that it ends at; none: at the last new one.
       */
      to: number | null;
    }
  | {
      /**
       * Its edges by the places of their vertices in the list, from 0.
       */
      edges: [number, number][];
      edit: "paste";
      /**
       * Its vertices.
       */
      vertices: PastedVertex[];
    }
  | {
      /**
       * Edges.
       */
      edges: number[];
      edit: "delete";
      /**
       * Vertices.
       */
      vertices: number[];
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
       * Which.
       */
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
      /**
       * Where: more than 0 (its first vertex), less than 1 (its second).
       */
      at: number;
      /**
       * Which.
       */
      edge: number;
      edit: "split";
    }
  | {
      at: MergePlace;
      edit: "merge";
      /**
       * Which.
       */
      vertices: number[];
    }
  | {
      edit: "transform";
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
      /**
       * Which.
       */
      vertices: number[];
    }
  | {
      /**
       * Whether the image is added; otherwise the vertices themselves are moved.
       */
      copy: boolean;
      edit: "mirror";
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
      /**
       * Which.
       */
      vertices: number[];
    }
  | {
      /**
       * How many copies are added.
       */
      count: number;
      edit: "array";
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
      /**
       * Which.
       */
      vertices: number[];
    }
  | {
      edit: "support";
      /**
       * Fixed or free.
       */
      support: boolean;
      /**
       * Which.
       */
      vertices: number[];
    }
  | {
      edit: "weld";
      /**
       * How close, mm.
       */
      tolerance_mm: number;
    }
  | {
      /**
       * Which.
       */
      edges: number[];
      edit: "detach";
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
      least_edge_mm: number;
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
      /**
       * Which.
       */
      edges: number[];
      edit: "doublings";
    }
  | {
      edit: "start";
      /**
       * Where.
       */
      vertex: number | null;
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
      material: string | null;
    }
  | {
      edit: "notes";
      /**
       * The text.
       */
      text: string;
    }
  | {
      edit: "units";
      units: LengthUnit;
    }
  | {
      edit: "remove-stencil";
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
 * Where the vertex goes that others are merged into.
 */
export type MergePlace = "first" | "last" | "centre";
/**
 * What a file is.
 */
export type Seen = "document" | "wireframe" | "stencil" | "both" | "job";
/**
 * What became of a wire.
 */
export type Outcome = "finished" | "sent" | "abandoned" | "unfinished";
/**
 * Who has said how much of a step is made.
 */
export type ToldBy = "machine" | "person";

export interface Responses {
  about: AboutResponse;
  answer: MachineNow;
  "change-settings": SettingsChanged;
  check: LiveCheck;
  "clear-recent": Started;
  "clear-recording": Recorded;
  close: DesignOpened;
  compare: CompareResponse;
  connect: MachineNow;
  "copy-machine": ProfileNewResponse;
  discard: Started;
  drivers: DriversResponse;
  edit: EditMade;
  examples: ExamplesResponse;
  "explain-profile": ProfileExplainResponse;
  export: ExportPreview;
  exports: ExportsResponse;
  fixes: FixesResponse;
  look: LookResponse;
  "machine-state": MachineNow;
  "machine-view": MachineViewResponse;
  machines: MachinesResponse;
  made: MadeResponse;
  materials: MaterialsResponse;
  new: DesignOpened;
  open: DesignOpened;
  "open-example": DesignOpened;
  order: MachineNow;
  ports: PortsResponse;
  program: ProgramResponse;
  "put-stencil": EditMade;
  recorded: Recorded;
  redo: EditMade;
  restore: DesignOpened;
  runs: RunsResponse;
  "runs-show": RunsShowResponse;
  save: DesignOpened;
  "save-job": SavedJob;
  "save-recording": SavedRecording;
  "save-wireframe": SavedWireframe;
  start: Started;
  "trust-driver": DriverTrustResponse;
  undo: EditMade;
}
/**
 * What this program is.
 */
export interface AboutResponse {
  /**
   * What it is for, in a sentence.
   */
  description: string;
  /**
   * The version of the interface to drivers.
   */
  driver_interface: string;
  /**
   * Its licence, as an SPDX expression.
   */
  licence: string;
  /**
   * Where profiles and drivers of a person's own are looked for.
   */
  own_folder: string | null;
  /**
   * The packages of others that it is made of: name, version, licence.
   */
  packages: [string, string, string][];
  /**
   * Its version.
   */
  version: string;
}
/**
 * How the machine stands.
 */
export interface MachineNow {
  /**
   * Its state; null where none was connected.
   */
  state: MachineState | null;
}
/**
 * How a machine and its operator stand.
 */
export interface MachineState {
  /**
   * An order is being carried out, or a person is asked because of it: what is told of the phase is not its end.
   */
  busy: boolean;
  /**
   * The orders that make sense now.
   */
  can: OrderName[];
  /**
   * What is being done within that, in a word or two.
   */
  doing: string | null;
  /**
   * Its driver.
   */
  driver: string | null;
  /**
   * What it says that it is.
   */
  identity: string | null;
  /**
   * The machine.
   */
  machine: string;
  phase: Phase;
  /**
   * Where it is; null where no port was named and none is known yet.
   */
  port: string | null;
  /**
   * Where its axes are, in canonical signs.
   */
  position: StepReport | null;
  /**
   * What failed last; null once something else was ordered.
   */
  problem: RunProblem | null;
  /**
   * What a person is being asked.
   */
  question: Question | null;
  /**
   * How many moves are recorded.
   */
  recorded: number;
  /**
   * Settings of the machine that are not those of its profile.
   */
  settings: SettingCheck[];
  /**
   * No machine is there: its driver computes one.
   */
  simulated: boolean;
  /**
   * The last wire on it, where that was interrupted and can be gone on with.
   */
  unfinished: Unfinished | null;
  /**
   * The wire that is armed or being made, or that was the last.
   */
  wire: WireState | null;
}
/**
 * Feed, then rotate, then bend.
 */
export interface StepReport {
  /**
   * Bend, in degrees.
   */
  bend_deg: number;
  /**
   * Feed, in mm.
   */
  feed_mm: number;
  /**
   * Turn about the wire, in degrees, right-handed about the direction of travel.
   */
  rotate_deg: number;
}
/**
 * What failed.
 */
export interface RunProblem {
  /**
   * A name that stays.
   */
  code: string;
  /**
   * What happened and what to do.
   */
  message: string;
}
/**
 * What a person is asked.
 */
export interface Question {
  /**
   * The step that it is about, where nobody knows whether that was made.
   */
  doubt: Doubt | null;
  /**
   * What can be said of where the head stands, where it is about that.
   */
  head: HeadAsked | null;
  /**
   * Its number, for the answer.
   */
  id: number;
  kind: QuestionKind;
  /**
   * What they have to know: lines to read.
   */
  lines: string[];
  /**
   * The question.
   */
  question: string;
}
/**
 * A step of which nobody knows whether it was made.
 */
export interface Doubt {
  before: PartOfStep;
  /**
   * How much of it is in the wire as the machine has counted; null where it cannot tell.
   */
  counted: PartOfStep | null;
  designed: StepReport;
  /**
   * The last step that was sent: when this one was made, the next ones up to it are in doubt, too.
   */
  last: number;
  /**
   * How many there are.
   */
  of: number;
  /**
   * The step, from 1.
   */
  step: number;
  told: StepReport;
  /**
   * Index of the wire, from 0.
   */
  wire: number;
}
/**
 * How much of a step is in the wire, in canonical signs. What it bends counts for nothing: a bend is made from its beginning.
 */
export interface PartOfStep {
  /**
   * Fed, mm.
   */
  feed_mm: number;
  /**
   * Turned, degrees.
   */
  rotate_deg: number;
}
/**
 * What can be said of where the head stands, degrees from where its cable is unwound.
 */
export interface HeadAsked {
  /**
   * Where it was left; null where nobody knows.
   */
  left_at_deg: number | null;
  /**
   * The least and the most.
   *
   * @minItems 2
   * @maxItems 2
   */
  range_deg: [number, number];
}
/**
 * A setting of the machine against what the driver's settings say.
 */
export interface SettingCheck {
  /**
   * What was expected.
   */
  expected: string;
  /**
   * What the machine says.
   */
  machine: string;
  /**
   * Whether a program would come out wrong.
   */
  matters: boolean;
  /**
   * What it is called, on the machine and for people.
   */
  name: string;
}
/**
 * A wire that was interrupted and can be gone on with.
 */
export interface Unfinished {
  /**
   * The id of its record.
   */
  id: string;
  /**
   * Steps of which nobody knows whether they were made: the first and the last.
   *
   * @minItems 2
   * @maxItems 2
   */
  in_doubt: [number, number] | null;
  /**
   * Hash of its job.
   */
  job_hash: string;
  /**
   * The last step that is known to be made.
   */
  made: number;
  /**
   * Name of the design.
   */
  name: string;
  /**
   * How many there are.
   */
  of: number;
  /**
   * Where it was begun.
   */
  port: string;
  /**
   * Whether it can be gone on with: its record may be damaged. Then it can be given up, and nothing is known of when and
   * where it was begun.
   */
  resumable: boolean;
  /**
   * When.
   */
  started: string;
  /**
   * Index of the wire, from 0.
   */
  wire: number;
}
/**
 * How far a wire is.
 */
export interface WireState {
  done_by: DoneBy;
  /**
   * Since it was started or taken up, s.
   */
  elapsed_s: number;
  /**
   * Hash of its job: the open design may make another one by now.
   */
  job_hash: string;
  /**
   * The last step that was made, or whose time is over where the machine does not say what it makes.
   */
  made: number;
  /**
   * Name of the design.
   */
  name: string;
  /**
   * How many there are.
   */
  of: number;
  /**
   * What is estimated to be left, s.
   */
  remaining_s: number;
  /**
   * The last that the machine has taken.
   */
  sent: number;
  /**
   * Index of the wire in its job, from 0.
   */
  wire: number;
}
/**
 * The machine with other settings.
 */
export interface SettingsChanged {
  /**
   * The profile that was written.
   */
  file: string;
  machine: MachineViewResponse;
}
/**
 * A machine.
 */
export interface MachineViewResponse {
  /**
   * Largest bends to both sides, degrees.
   *
   * @minItems 2
   * @maxItems 2
   */
  bend_deg: [number, number];
  /**
   * What it is.
   */
  description: string;
  /**
   * Thinnest and thickest wire, mm.
   *
   * @minItems 2
   * @maxItems 2
   */
  diameter_mm: [number, number];
  /**
   * Its driver.
   */
  driver: string;
  /**
   * Why its driver cannot be used; null where it can.
   */
  driver_problem: RunProblem | null;
  /**
   * Its profile.
   */
  file: string;
  /**
   * Its id.
   */
  id: string;
  /**
   * The profile that it inherits from.
   */
  inherits: string | null;
  /**
   * Longest stock, mm; null: no limit.
   */
  max_stock_mm: number | null;
  /**
   * Shortest designed edge, mm.
   */
  min_edge_mm: number;
  /**
   * Shortest feed, mm.
   */
  min_feed_mm: number;
  /**
   * Its name.
   */
  name: string;
  /**
   * A point of the axis about which the peg goes, mm, in the same frame.
   *
   * @minItems 3
   * @maxItems 3
   */
  pivot_mm: [number, number, number];
  /**
   * Speeds: feed in mm/s, rotate and bend in degrees/s.
   *
   * @minItems 3
   * @maxItems 3
   */
  rates: [number, number, number];
  /**
   * How far the head turns to both sides, degrees.
   *
   * @minItems 2
   * @maxItems 2
   */
  rotation_deg: [number, number];
  /**
   * Its driver's settings, those at their default included.
   */
  settings: SettingValue[];
  /**
   * The JSON Schema of its driver's settings; null where the driver cannot be asked.
   */
  settings_schema: {
    [k: string]: unknown;
  };
  /**
   * Its bodies. Frame: the origin is where a bend begins, x the way the wire leaves, z the bend axis.
   */
  shapes: Shape[];
  /**
   * Whether it comes with the program: then it cannot be changed, but copied.
   */
  shipped: boolean;
}
/**
 * A setting of the machine's driver.
 */
export interface SettingValue {
  /**
   * The file of that profile.
   */
  file: string | null;
  /**
   * Its key.
   */
  key: string;
  /**
   * The line in it, from 1.
   */
  line: number | null;
  /**
   * The profile that sets it; null where it is the driver's default.
   */
  set_by: string | null;
  /**
   * Its value.
   */
  value: {
    [k: string]: unknown;
  };
}
/**
 * A body of a machine. Frame: the origin is where a bend begins, x the way the wire leaves, z the bend axis, right-handed;
 * the head at its reference, the bend axis at 0.
 */
export interface Shape {
  /**
   * Its centre, millimetres.
   *
   * @minItems 3
   * @maxItems 3
   */
  at_mm: [number, number, number];
  /**
   * Where a cylinder's axis, or the z of a box, points; of any length. Absent: along z.
   *
   * @minItems 3
   * @maxItems 3
   */
  axis: [number, number, number];
  /**
   * True when somebody measured them on the real machine.
   */
  measured: boolean;
  /**
   * What it is called.
   */
  name: string;
  part: Part;
  solid: Solid;
  /**
   * Where the dimensions come from: a drawing, a measurement, or why they are estimates.
   */
  source: string;
}
/**
 * What the checks say.
 */
export interface LiveCheck {
  /**
   * Errors first.
   */
  diagnostics: DiagnosticReport[];
  /**
   * Whether the machine can make it.
   */
  feasible: boolean;
  /**
   * Why limits of the machine are not known, where they are not.
   */
  limits_unknown: string | null;
  /**
   * One for each part that is not joined to others.
   */
  wires: WireFigures[];
}
/**
 * One thing to know.
 */
export interface DiagnosticReport {
  /**
   * What it is about: a name that stays the same.
   */
  code: string;
  /**
   * The edge that it is about foremost.
   */
  edge?: number | null;
  /**
   * All its edges, where there are several.
   */
  edges?: number[];
  /**
   * What to do.
   */
  help: string;
  /**
   * The limit, in `unit`.
   */
  limit?: number | null;
  /**
   * Where the limit comes from.
   */
  limit_source?: string | null;
  /**
   * What it is.
   */
  message: string;
  severity: SeverityName;
  /**
   * The step of the program, counted from 0.
   */
  step?: number | null;
  /**
   * The unit of value and limit: `mm`, `deg`, or none for a count.
   */
  unit?: string | null;
  /**
   * What was measured, in `unit`.
   */
  value?: number | null;
  /**
   * The vertex that it is about foremost.
   */
  vertex?: number | null;
  /**
   * All its vertices, where there are several.
   */
  vertices?: number[];
}
/**
 * What the status bar shows of a wire.
 */
export interface WireFigures {
  /**
   * How many steps bend the wire.
   */
  bends: number | null;
  /**
   * Price of the wire that is fed.
   */
  cost: number | null;
  /**
   * Of the cost.
   */
  currency: string | null;
  /**
   * Designed length, mm; null where there is no route.
   */
  length_mm: number | null;
  /**
   * Mass of the wire that is fed, g.
   */
  mass_g: number | null;
  /**
   * The vertices in the order of the walk.
   */
  route: number[];
  /**
   * Price of the stock, which has the tail that cannot be fed.
   */
  stock_cost: number | null;
  /**
   * Stock to load, mm.
   */
  stock_mm: number | null;
  /**
   * Time on the machine, s.
   */
  time_s: number | null;
}
/**
 * What there is when a window opens.
 */
export interface Started {
  design: DesignView;
  /**
   * What was open before.
   */
  recent: RecentEntry[];
  /**
   * Designs that were open when the program or the computer stopped, last changed first.
   */
  unsaved: Unsaved[];
  /**
   * The version of the program.
   */
  version: string;
  /**
   * What a person should know at once, such as profiles of theirs that cannot be used.
   */
  warnings: string[];
}
/**
 * The whole design.
 */
export interface DesignView {
  /**
   * By id.
   */
  edges: EdgeView[];
  state: DesignState;
  /**
   * Corners and faces of the stencil.
   *
   * @minItems 2
   * @maxItems 2
   */
  stencil: [number, number] | null;
  /**
   * By id.
   */
  vertices: VertexView[];
}
/**
 * An edge.
 */
export interface EdgeView {
  /**
   * The vertex where it starts.
   */
  a: number;
  /**
   * The vertex where it ends.
   */
  b: number;
  /**
   * Its id.
   */
  id: number;
}
/**
 * All but vertices, edges and the stencil.
 */
export interface DesignState {
  /**
   * Whether there is something that the file has not.
   */
  changed: boolean;
  /**
   * Edges that may be laid twice.
   */
  doublings: number[];
  /**
   * Its file; null where it was never saved.
   */
  file: string | null;
  /**
   * The machine's id.
   */
  machine: string | null;
  /**
   * The material's id.
   */
  material: string | null;
  /**
   * What it is called.
   */
  name: string;
  /**
   * The ids that the next vertex and the next edge will get.
   *
   * @minItems 2
   * @maxItems 2
   */
  next: [number, number];
  /**
   * Remarks on the whole.
   */
  notes: string;
  /**
   * What would be done again.
   */
  redo: string | null;
  /**
   * The vertex where the wire starts.
   */
  start: number | null;
  /**
   * What the stencil is called, after its file; null without a stencil, and where nobody knows.
   */
  stencil: string | null;
  /**
   * What would be undone.
   */
  undo: string | null;
  units: LengthUnit;
  /**
   * Why changes are not kept safe: a person should save. Null where they are.
   */
  unkept: string | null;
}
/**
 * A vertex.
 */
export interface VertexView {
  /**
   * Where it is, mm, right-handed.
   *
   * @minItems 3
   * @maxItems 3
   */
  at_mm: [number, number, number];
  /**
   * Its id.
   */
  id: number;
  /**
   * Whether the design holds it fixed.
   */
  support: boolean;
}
/**
 * A file that was open.
 */
export interface RecentEntry {
  /**
   * Its name.
   */
  name: string;
  /**
   * The file.
   */
  path: string;
  /**
   * Whether it is still there.
   */
  there: boolean;
}
/**
 * A design that was open when the program or the computer stopped.
 */
export interface Unsaved {
  /**
   * When the last was made, in seconds since 1970.
   */
  changed_s: number;
  /**
   * Changes that no file has.
   */
  changes: number;
  /**
   * The file that it is of; null for a new design.
   */
  file: string | null;
  /**
   * The journal, to open it by.
   */
  journal: string;
  /**
   * What it is called.
   */
  name: string;
}
/**
 * The moves that were recorded.
 */
export interface Recorded {
  /**
   * In the order in which they were made.
   */
  moves: Move[];
}
/**
 * What was opened.
 */
export interface DesignOpened {
  design: DesignView;
  /**
   * What was merged, ignored or assumed while reading.
   */
  notes: NoteReport[];
  /**
   * What was open before.
   */
  recent: RecentEntry[];
}
/**
 * Something that a reader merged, ignored or assumed.
 */
export interface NoteReport {
  /**
   * What it is about.
   */
  code: string;
  /**
   * How many there were.
   */
  count: number;
  /**
   * A sentence.
   */
  message: string;
}
/**
 * The design on several machines.
 */
export interface CompareResponse {
  from: MachineSide;
  /**
   * What was merged, ignored or assumed while reading, and what to know of the wires; each once.
   */
  notes: NoteReport[];
  /**
   * On the others, in the order asked for.
   */
  to: OtherSide[];
}
/**
 * A design on one machine. Sums are over all wires, and null where some wire did not get that far.
 */
export interface MachineSide {
  /**
   * How many steps bend the wire.
   */
  bends: number | null;
  /**
   * Price of the wire that is fed, in `currency`; null also where the price is not known.
   */
  cost: number | null;
  /**
   * Of the cost.
   */
  currency: string | null;
  /**
   * How many errors the checks found.
   */
  errors: number;
  /**
   * Whether the machine can make it.
   */
  feasible: boolean;
  /**
   * How many edges are travelled, each time counted.
   */
  feeds: number | null;
  /**
   * The machine.
   */
  machine: string;
  /**
   * Mass of the wire that is fed, in g.
   */
  mass_g: number | null;
  /**
   * The wire in it: the one that was asked for, else the document's, else the machine's own.
   */
  material: string;
  /**
   * Its name.
   */
  name: string;
  /**
   * Stock to load, in mm.
   */
  stock_mm: number | null;
  /**
   * Time on the machine, in s.
   */
  time_s: number | null;
  /**
   * How many warnings.
   */
  warnings: number;
}
/**
 * The design on another machine, and what is different there.
 */
export interface OtherSide {
  /**
   * How many steps bend the wire.
   */
  bends: number | null;
  change: Change;
  /**
   * Price of the wire that is fed, in `currency`; null also where the price is not known.
   */
  cost: number | null;
  /**
   * Of the cost.
   */
  currency: string | null;
  /**
   * How many errors the checks found.
   */
  errors: number;
  /**
   * Whether the machine can make it.
   */
  feasible: boolean;
  /**
   * How many edges are travelled, each time counted.
   */
  feeds: number | null;
  /**
   * The machine.
   */
  machine: string;
  /**
   * Mass of the wire that is fed, in g.
   */
  mass_g: number | null;
  /**
   * The wire in it: the one that was asked for, else the document's, else the machine's own.
   */
  material: string;
  /**
   * Its name.
   */
  name: string;
  newly_feasible: Objections;
  newly_infeasible: Objections;
  /**
   * The same with the machine's own wire, where that of the design does not fit it; null where it fits, where the machine
   * has no other wire, and in the comparison with its own wire.
   */
  own_wire: OtherSide | null;
  /**
   * Stock to load, in mm.
   */
  stock_mm: number | null;
  /**
   * Time on the machine, in s.
   */
  time_s: number | null;
  /**
   * How many warnings.
   */
  warnings: number;
}
/**
 * Differences of sums; null where one of the two is not known.
 */
export interface Change {
  /**
   * Of the number of bends.
   */
  bends: number | null;
  /**
   * Of the cost; null also where the currencies differ.
   */
  cost: number | null;
  /**
   * Of the mass, in g.
   */
  mass_g: number | null;
  /**
   * Of the stock, in mm.
   */
  stock_mm: number | null;
  /**
   * Of the time, in s.
   */
  time_s: number | null;
}
/**
 * Errors and where they are; ids ascend, each once.
 */
export interface Objections {
  /**
   * The errors.
   */
  diagnostics: WireDiagnostic[];
  /**
   * The edges.
   */
  edges: number[];
  /**
   * The steps.
   */
  steps: WireStep[];
  /**
   * The vertices.
   */
  vertices: number[];
}
/**
 * One thing to know of a wire, or of the design.
 */
export interface WireDiagnostic {
  /**
   * What it is about: a name that stays the same.
   */
  code: string;
  /**
   * The edge that it is about foremost.
   */
  edge?: number | null;
  /**
   * All its edges, where there are several.
   */
  edges?: number[];
  /**
   * What to do.
   */
  help: string;
  /**
   * The limit, in `unit`.
   */
  limit?: number | null;
  /**
   * Where the limit comes from.
   */
  limit_source?: string | null;
  /**
   * What it is.
   */
  message: string;
  severity: SeverityName;
  /**
   * The step of the program, counted from 0.
   */
  step?: number | null;
  /**
   * The unit of value and limit: `mm`, `deg`, or none for a count.
   */
  unit?: string | null;
  /**
   * What was measured, in `unit`.
   */
  value?: number | null;
  /**
   * The vertex that it is about foremost.
   */
  vertex?: number | null;
  /**
   * All its vertices, where there are several.
   */
  vertices?: number[];
  /**
   * Index of the wire, from 0; null for the design as a whole.
   */
  wire: number | null;
}
/**
 * A step of one of the wires.
 */
export interface WireStep {
  /**
   * Index of its step, from 0.
   */
  step: number;
  /**
   * Index of the wire, from 0.
   */
  wire: number;
}
/**
 * A profile that was made.
 */
export interface ProfileNewResponse {
  /**
   * Its file; null where it is returned.
   */
  file: string | null;
  /**
   * Its id.
   */
  id: string;
  /**
   * The id of its parent.
   */
  inherits: string;
  kind: Kind;
}
/**
 * The drivers.
 */
export interface DriversResponse {
  /**
   * In the order in which they are asked.
   */
  drivers: DriverEntry[];
  /**
   * What was named and is not there.
   */
  missing: string[];
}
/**
 * A driver.
 */
export interface DriverEntry {
  /**
   * What it can do.
   */
  capabilities: Capability[];
  /**
   * What it is.
   */
  description: string | null;
  /**
   * The library.
   */
  file: string;
  /**
   * What it writes.
   */
  formats: FormatDescription[];
  /**
   * Its id; known of drivers that can be used, as is what follows.
   */
  id: string | null;
  /**
   * Machines whose profiles name it.
   */
  machines: string[];
  /**
   * Its name.
   */
  name: string | null;
  /**
   * Why it cannot be used.
   */
  problem: string | null;
  /**
   * The JSON Schema of its settings.
   */
  settings_schema: {
    [k: string]: unknown;
  };
  /**
   * Its SHA-256, where it did not come with the program.
   */
  sha256: string | null;
  state: DriverState;
  /**
   * Its version.
   */
  version: string | null;
}
/**
 * A format that a driver writes.
 */
export interface FormatDescription {
  content: Content;
  /**
   * File name extensions without their dot, the usual one first.
   */
  extensions: string[];
  files: Files & string;
  /**
   * Slug: what `--format` and machine profiles name.
   */
  id: string;
  /**
   * Name for people.
   */
  name: string;
  /**
   * Whether a machine runs it. Then it is not written of what cannot be made, unless a person says so.
   */
  program: boolean;
}
/**
 * What a change made of the design.
 */
export interface EditMade {
  /**
   * What is to be drawn anew; null where there was nothing to undo or to redo.
   */
  change: ViewChange | null;
  /**
   * What was merged, ignored or assumed while reading.
   */
  notes: NoteReport[];
}
/**
 * What a change makes of the design.
 */
export interface ViewChange {
  /**
   * Edges that were added or changed.
   */
  edges: EdgeView[];
  /**
   * Edges that are gone.
   */
  gone_edges: number[];
  /**
   * Vertices that are gone.
   */
  gone_vertices: number[];
  state: DesignState;
  /**
   * Whether the stencil is another, or gone.
   */
  stencil: boolean;
  /**
   * Vertices that were added or changed.
   */
  vertices: VertexView[];
}
/**
 * The examples.
 */
export interface ExamplesResponse {
  /**
   * Simple ones first.
   */
  examples: ExampleEntry[];
}
/**
 * An example.
 */
export interface ExampleEntry {
  /**
   * What there is to see.
   */
  description: string;
  /**
   * What [`OpenExample`] takes.
   */
  id: string;
  /**
   * Its lines for a small picture, mm.
   */
  lines_mm: [[number, number, number], [number, number, number]][];
  /**
   * Its name.
   */
  name: string;
}
/**
 * A profile, value by value.
 */
export interface ProfileExplainResponse {
  /**
   * Whether it only serves to be inherited from.
   */
  abstract: boolean;
  /**
   * The profile itself, its parent, and so on.
   */
  chain: AncestorReport[];
  /**
   * Its id.
   */
  id: string;
  kind: Kind;
  /**
   * Its name.
   */
  name: string;
  /**
   * The curve of a material's springback table; absent where there is no table.
   */
  springback?: SpringbackReport | null;
  /**
   * Its values, in the order in which the shipped files have them.
   */
  values: ValueReport[];
}
/**
 * A profile of a chain.
 */
export interface AncestorReport {
  /**
   * Its file.
   */
  file: string;
  /**
   * Its id.
   */
  id: string;
  /**
   * Whether it comes with the program.
   */
  shipped: boolean;
}
/**
 * What a wire loses of bends, by its table.
 */
export interface SpringbackReport {
  /**
   * To the negative side; bends without their sign.
   */
  negative: SpringbackSample[];
  /**
   * To the positive side, bends ascending.
   */
  positive: SpringbackSample[];
  /**
   * What lies between and beyond the pairs.
   */
  rule: string;
}
/**
 * The curve at one place.
 */
export interface SpringbackSample {
  /**
   * The bend that is left, degrees.
   */
  bend_deg: number;
  /**
   * What the wire loses of it, degrees: it is bent that much farther.
   */
  loss_deg: number;
  place: SamplePlace;
}
/**
 * One value.
 */
export interface ValueReport {
  /**
   * The file of that profile.
   */
  file: string;
  /**
   * The parent's value that it replaces.
   */
  instead_of: OverriddenReport | null;
  /**
   * Dotted key; its last word ends with the unit of a figure.
   */
  key: string;
  /**
   * The line in it, from 1.
   */
  line: number | null;
  /**
   * Whether a figure was measured; null for what is no figure.
   */
  measured: boolean | null;
  /**
   * The profile that set it.
   */
  set_by: string;
  /**
   * Where a figure comes from; null for what is no figure.
   */
  source: string | null;
  /**
   * The value; null where a parent's value is taken away.
   */
  value: {
    [k: string]: unknown;
  };
}
/**
 * A value of a parent.
 */
export interface OverriddenReport {
  /**
   * The profile that set it.
   */
  set_by: string;
  /**
   * The value.
   */
  value: {
    [k: string]: unknown;
  };
}
/**
 * A file, or the beginning of what it would be.
 */
export interface ExportPreview {
  /**
   * Of each file that would be written its first lines; null of one that is no text.
   */
  beginnings: (string | null)[];
  /**
   * Of each file its size.
   */
  bytes: number[];
  /**
   * Whether the machine can make it.
   */
  feasible: boolean;
  /**
   * The files that were written.
   */
  files: string[];
  /**
   * The format.
   */
  format: string;
  /**
   * What was assumed or left out.
   */
  notes: NoteReport[];
}
/**
 * What can be written.
 */
export interface ExportsResponse {
  /**
   * The machine's own first, then what its profile lists, then the rest.
   */
  formats: FormatEntry[];
  /**
   * Drivers that could not be asked, and why.
   */
  problems: RunProblem[];
}
/**
 * A format to choose.
 */
export interface FormatEntry {
  /**
   * The driver that writes it; null for what the program writes itself.
   */
  driver: string | null;
  /**
   * How the names of its files end, without the dot.
   */
  extension: string;
  /**
   * What `--format` takes.
   */
  id: string;
  /**
   * Its name.
   */
  name: string;
  /**
   * Whether it is the machine's own or one that its profile lists.
   */
  of_machine: boolean;
  /**
   * Whether a machine runs it: then it is not written of what cannot be made.
   */
  program: boolean;
  /**
   * The settings that the machine's profile has.
   */
  settings: {
    [k: string]: unknown;
  };
  /**
   * The JSON Schema of its settings; null where it has none.
   */
  settings_schema: {
    [k: string]: unknown;
  };
}
/**
 * What would mend what the checks say.
 */
export interface FixesResponse {
  /**
   * In the order of the diagnostics, the best of each first.
   */
  fixes: Fix[];
}
/**
 * Something that mends what a check says. Lengths in mm.
 */
export interface Fix {
  change: FixChange;
  edit: EditRequest;
  /**
   * How many errors there are afterwards.
   */
  errors_after: number;
  /**
   * Whether the machine can make the design afterwards.
   */
  feasible_after: boolean;
  mends: DiagnosticReport;
  preview: FixPreview;
  /**
   * For a button: "Double 13 edges (+102.0 mm)", "Move vertex 41 by 3.2 mm".
   */
  title: string;
}
/**
 * Sums over all wires of the design afterwards, less those of before. Null where one of them is not known, as
 * without a route.
 */
export interface FixChange {
  /**
   * Price of the designed length.
   */
  cost: number | null;
  /**
   * Of the cost.
   */
  currency: string | null;
  /**
   * Errors. A wire that had no route was not checked for bends: its errors show once it has one.
   */
  errors: number;
  /**
   * Designed length, mm.
   */
  length_mm: number | null;
  /**
   * Stock to load, mm.
   */
  stock_mm: number | null;
  /**
   * Time on the machine, s.
   */
  time_s: number | null;
  /**
   * Warnings.
   */
  warnings: number;
}
/**
 * A vertex of a piece.
 */
export interface PastedVertex {
  /**
   * Where it is, mm.
   *
   * @minItems 3
   * @maxItems 3
   */
  at_mm: [number, number, number];
  /**
   * Whether the design holds it fixed.
   */
  support: boolean;
}
/**
 * A vertex and where it goes.
 */
export interface Placed {
  /**
   * Where, mm.
   *
   * @minItems 3
   * @maxItems 3
   */
  at_mm: [number, number, number];
  /**
   * Which.
   */
  vertex: number;
}
/**
 * What a fix would change in the drawing. Positions in mm.
 */
export interface FixPreview {
  /**
   * Edges that would be detached from the others: the wires that are split off.
   */
  detached: number[][];
  /**
   * Edges that would be laid twice.
   */
  doubled: number[];
  /**
   * Edges that would go.
   */
  gone_edges: number[];
  /**
   * Vertices at their new places.
   */
  moved: Moved[];
  /**
   * Lines that would be new.
   */
  new_edges: [[number, number, number], [number, number, number]][];
}
/**
 * A vertex that is being dragged, and where it is.
 */
export interface Moved {
  /**
   * Where, mm.
   *
   * @minItems 3
   * @maxItems 3
   */
  at_mm: [number, number, number];
  /**
   * Which.
   */
  vertex: number;
}
/**
 * What is in a file.
 */
export interface LookResponse {
  /**
   * Whether units and scale are open: the format does not say them.
   */
  asks_units: boolean;
  /**
   * Its lines.
   */
  edges: number;
  /**
   * Faces of its surface.
   */
  faces: number;
  /**
   * Its format.
   */
  format: string;
  /**
   * The layers of a drawing, hidden ones included.
   */
  layers: string[];
  /**
   * Its name.
   */
  name: string;
  /**
   * What would be merged, ignored or assumed.
   */
  notes: NoteReport[];
  seen: Seen;
  /**
   * Its size in x, y and z as it would be read, mm; null where there is nothing.
   *
   * @minItems 3
   * @maxItems 3
   */
  size_mm: [number, number, number] | null;
  /**
   * Vertices of its lines.
   */
  vertices: number;
}
/**
 * The machines.
 */
export interface MachinesResponse {
  /**
   * By id.
   */
  machines: MachineEntry[];
}
/**
 * A machine to choose.
 */
export interface MachineEntry {
  /**
   * Largest bends to both sides, in degrees.
   *
   * @minItems 2
   * @maxItems 2
   */
  bend_deg: [number, number];
  /**
   * The material that is in it unless another is named.
   */
  default_material: string;
  /**
   * Thinnest and thickest wire, in mm.
   *
   * @minItems 2
   * @maxItems 2
   */
  diameter_mm: [number, number];
  /**
   * The driver that runs it.
   */
  driver: string;
  /**
   * Its profile.
   */
  file: string;
  /**
   * The formats that can be written for it, its default first.
   */
  formats: string[];
  /**
   * Its id.
   */
  id: string;
  /**
   * Shortest designed edge, in mm.
   */
  min_edge_mm: number;
  /**
   * Its name.
   */
  name: string;
  /**
   * Its own format, where only its driver writes it.
   */
  native: string | null;
  /**
   * Whether it comes with the program.
   */
  shipped: boolean;
}
/**
 * How the machine makes the open design.
 */
export interface MadeResponse {
  /**
   * Whether the driver's simulated machine made it; otherwise the formulas of the compensation did, backwards.
   */
  by_machine: boolean;
  /**
   * What the machine told, and what was left out.
   */
  notes: NoteReport[];
  /**
   * The wires, in the order of the program.
   */
  wires: MadeWire[];
}
/**
 * A wire as it is made.
 */
export interface MadeWire {
  /**
   * Its ends and corners, one more than there are steps, mm, laid beside the design with the first edge in place.
   */
  corners_mm: [number, number, number][];
  /**
   * How far each vertex of the route is from the design, mm.
   */
  deviations_mm: number[];
  /**
   * Points along its middle, mm; empty where only formulas made it.
   */
  wire_mm: [number, number, number][];
  /**
   * The largest of them.
   */
  worst_mm: number;
}
/**
 * The materials.
 */
export interface MaterialsResponse {
  /**
   * By id.
   */
  materials: MaterialEntry[];
}
/**
 * A material to choose.
 */
export interface MaterialEntry {
  /**
   * Of the price.
   */
  currency: string | null;
  /**
   * Density, in kg/m³.
   */
  density_kg_per_m3: number;
  /**
   * Diameter, in mm.
   */
  diameter_mm: number;
  /**
   * Its profile.
   */
  file: string;
  /**
   * Its id.
   */
  id: string;
  /**
   * Depth of the neutral fibre, as a fraction of the diameter.
   */
  k_factor: number;
  /**
   * Its name.
   */
  name: string;
  /**
   * Price of a millimetre, in `currency`; null where nobody knows.
   */
  price_per_mm: number | null;
  /**
   * Whether it comes with the program.
   */
  shipped: boolean;
  /**
   * Least and most that a bend loses when it is let go, degrees.
   *
   * @minItems 2
   * @maxItems 2
   */
  springback_deg: [number, number];
  /**
   * Whether its springback was measured.
   */
  springback_measured: boolean;
  /**
   * Yield strength, `MPa`.
   */
  yield_strength_mpa: number;
}
/**
 * The ports.
 */
export interface PortsResponse {
  /**
   * Those that a machine is likely at first.
   */
  ports: PortEntry[];
  /**
   * Drivers that could not be asked, and why.
   */
  problems: string[];
}
/**
 * A port.
 */
export interface PortEntry {
  /**
   * What is plugged in there, as far as it is known.
   */
  description: string;
  /**
   * Drivers that list it.
   */
  drivers: string[];
  /**
   * Those that guess that one of their machines is there. Several kinds of machines have the same chip.
   */
  likely_for: string[];
  /**
   * What `--port` takes.
   */
  name: string;
  /**
   * No machine is at it: a driver computes one. The first is taken where no port is named.
   */
  simulated: boolean;
  /**
   * What the plug says of itself; null where it is no USB port.
   */
  usb: Usb | null;
}
/**
 * What a USB device says of itself.
 */
export interface Usb {
  /**
   * Name of the vendor.
   */
  manufacturer: string | null;
  /**
   * The vendor's number of the product.
   */
  pid: number;
  /**
   * Name of the product.
   */
  product: string | null;
  /**
   * Serial number: tells two machines of the same kind apart.
   */
  serial: string | null;
  /**
   * Number of its vendor.
   */
  vid: number;
}
/**
 * The program of the open design.
 */
export interface ProgramResponse {
  /**
   * Diameter of the wire, mm.
   */
  diameter_mm: number;
  /**
   * Whether the machine can make it.
   */
  feasible: boolean;
  /**
   * Hash of the job that arming the design as it is would make; null where none can be made. A wire of the
   * connected machine whose job has this hash is one of this very program.
   */
  job_hash: string | null;
  /**
   * The machine.
   */
  machine: string;
  /**
   * The material.
   */
  material: string;
  /**
   * The wires that have a program.
   */
  wires: PlayedWire[];
  /**
   * Wires that have none: the checks say why.
   */
  without: number;
}
/**
 * A wire as it is played.
 */
export interface PlayedWire {
  /**
   * The bend axis at the beginning, a vector of length 1 in the design's frame.
   *
   * @minItems 3
   * @maxItems 3
   */
  bend_axis: [number, number, number];
  /**
   * Where the wire begins, and where it is after each step: one more than there are steps. mm, in the design's frame.
   */
  corners_mm: [number, number, number][];
  /**
   * The steps.
   */
  steps: PlayedStep[];
  /**
   * Stock to load, mm.
   */
  stock_mm: number | null;
  /**
   * Time on the machine, s.
   */
  time_s: number | null;
}
/**
 * A step as it is played.
 */
export interface PlayedStep {
  designed: StepReport;
  /**
   * The edges along which it feeds.
   */
  edges: number[];
  /**
   * Seconds for feed, rotate, the bend axis there and back, and for waiting.
   *
   * @minItems 4
   * @maxItems 4
   */
  seconds: [number, number, number, number];
  /**
   * What the machine is told, in canonical signs; null where the wire is not compensated.
   */
  told: StepReport | null;
  /**
   * The vertex at which it bends, or at which the wire ends.
   */
  vertex: number | null;
}
/**
 * The records.
 */
export interface RunsResponse {
  /**
   * Where they are; null where there is no such place.
   */
  folder: string | null;
  /**
   * In the order in which they were begun.
   */
  runs: RunEntry[];
}
/**
 * A wire that was begun.
 */
export interface RunEntry {
  /**
   * When it was over.
   */
  ended: string | null;
  /**
   * Its id.
   */
  id: string;
  /**
   * How often it was stopped or failed.
   */
  interruptions: number | null;
  /**
   * Hash of the job.
   */
  job_hash: string | null;
  /**
   * The machine.
   */
  machine: string | null;
  /**
   * The last step that was made.
   */
  made: number | null;
  /**
   * The material.
   */
  material: string | null;
  /**
   * Name of the design.
   */
  name: string | null;
  /**
   * What became of it.
   */
  outcome: Outcome | null;
  /**
   * Why nothing is known of it, where its journal cannot be read; then the rest is absent.
   */
  problem: string | null;
  /**
   * When it was begun.
   */
  started: string | null;
  /**
   * How many steps it has.
   */
  steps: number | null;
  /**
   * Index of the wire in the job, from 0.
   */
  wire: number | null;
  /**
   * How far the worst corner is from the design, in mm, where somebody has measured.
   */
  worst_deviation_mm: number | null;
}
/**
 * One record.
 */
export interface RunsShowResponse {
  /**
   * Its id.
   */
  id: string;
  /**
   * Its journal.
   */
  journal: string;
  record: Record;
}
/**
 * What was made of a wire.
 */
export interface Record {
  /**
   * Corners of the wire, where a simulated machine made it, mm.
   */
  corners_mm: [number, number, number][];
  /**
   * What was said of steps that were in doubt, in order.
   */
  decisions: Decision[];
  /**
   * How far each corner is from the design, mm; absent where nobody has measured.
   */
  deviations_mm: number[] | null;
  /**
   * When it was over; absent while it is not.
   */
  ended: string | null;
  /**
   * Stops and failures, in order.
   */
  interruptions: Interruption[];
  job: Heading;
  /**
   * The last step that was made, or, where the machine does not say so, that has had its time.
   */
  made: number;
  outcome: Outcome;
  /**
   * When it was begun.
   */
  started: string;
}
/**
 * What was said of a step in doubt: by a person, or by the machine where it could tell how far it was.
 */
export interface Decision {
  /**
   * When.
   */
  at: string;
  /**
   * Whether it was made.
   */
  made: boolean;
  /**
   * How much of it was in the wire, where it was made in part; its rest was made then.
   */
  part: PartInWire | null;
  /**
   * The step.
   */
  step: number;
}
/**
 * How much of a step was in the wire, in the machine's signs.
 */
export interface PartInWire {
  by: ToldBy;
  /**
   * Fed, mm.
   */
  feed_mm: number;
  /**
   * Turned, degrees.
   */
  rotate_deg: number;
}
/**
 * A stop or a failure.
 */
export interface Interruption {
  /**
   * The last step that was known to be made.
   */
  after: number;
  /**
   * When.
   */
  at: string;
  /**
   * What happened, for a person.
   */
  what: string;
}
/**
 * What is to be made, of what, on which machine.
 */
export interface Heading {
  /**
   * Hash of the design that it was planned from.
   */
  design_hash: string;
  done_by: DoneBy & string;
  /**
   * Id of the driver.
   */
  driver: string;
  /**
   * Version of the driver.
   */
  driver_version: string;
  /**
   * How long each step is reckoned to take, s; empty where nobody has reckoned it.
   */
  estimates_s: number[];
  /**
   * Hash of the job.
   */
  job_hash: string;
  /**
   * Id of the machine's profile.
   */
  machine: string;
  /**
   * Id of the material.
   */
  material: string;
  /**
   * Name of the design.
   */
  name: string;
  /**
   * The port that the machine is at.
   */
  port: string;
  /**
   * How many steps it has.
   */
  steps: number;
  /**
   * Wire that has to be put in, mm.
   */
  stock_mm: number | null;
  /**
   * Version of the format.
   */
  version: number;
  /**
   * Index of the wire, from 0.
   */
  wire: number;
}
/**
 * A job that was written.
 */
export interface SavedJob {
  /**
   * The file.
   */
  file: string;
  /**
   * Its hash.
   */
  job_hash: string;
}
/**
 * The recording that was written.
 */
export interface SavedRecording {
  /**
   * Its file.
   */
  file: string;
}
/**
 * A wireframe that was written.
 */
export interface SavedWireframe {
  /**
   * The file.
   */
  file: string;
}
/**
 * A library and whether it is accepted.
 */
export interface DriverTrustResponse {
  /**
   * Whether it is accepted now.
   */
  accepted: boolean;
  /**
   * What it says that it is, once it is accepted.
   */
  id: string | null;
  /**
   * The library, by its absolute path.
   */
  library: string;
  /**
   * Its name.
   */
  name: string | null;
  /**
   * Its SHA-256.
   */
  sha256: string;
  /**
   * Its version.
   */
  version: string | null;
}
