/* Made by `make generate` from crates/api/schema. Do not edit. */

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
  | "speed"
  | "resume-run"
  | "abandon"
  | "replay"
  | "dry-run"
  | "write-settings"
  | "console"
  | "disconnect";
/**
 * Why an order is not possible now.
 */
export type Because =
  | ("homing" | "no-wire-armed")
  | "connecting"
  | "not-homed"
  | "moving"
  | "wire-armed"
  | "no-wire-under-way"
  | "wire-under-way"
  | "holding"
  | "stopping"
  | "failed"
  | "not-connected"
  | "unable"
  | "busy"
  | "question-open";
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
 * What a person can do about an error, with what it takes to offer it. Several remedies of an error are done in their order, or are
 * a choice; each front end words them.
 */
export type ErrorRemedy =
  | {
      remedy: "check-readable";
    }
  | {
      remedy: "check-right-file";
    }
  | {
      remedy: "check-disk";
    }
  | {
      remedy: "correct-file";
    }
  | {
      remedy: "export-again";
    }
  | {
      /**
       * What is not read, as a noun.
       */
      part: string;
      remedy: "export-without";
    }
  | {
      /**
       * The form, such as a format.
       */
      form: string;
      remedy: "export-as";
    }
  | {
      remedy: "export-resolved";
    }
  | {
      remedy: "open-model";
    }
  | {
      remedy: "put-files-beside";
    }
  | {
      remedy: "open-from-folder";
    }
  | {
      remedy: "simplify-model";
    }
  | {
      remedy: "repair-mesh";
    }
  | {
      /**
       * The names.
       */
      columns: string;
      remedy: "name-columns";
    }
  | {
      remedy: "split-bend";
    }
  | {
      remedy: "choose-file-format";
    }
  | {
      remedy: "choose-unit";
    }
  | {
      remedy: "check-scale";
    }
  | {
      remedy: "leave-out-layers";
    }
  | {
      remedy: "read-again";
    }
  | {
      remedy: "import-again";
    }
  | {
      remedy: "use-last-copy";
    }
  | {
      remedy: "open-as-it-is";
    }
  | {
      remedy: "update-program";
    }
  | {
      remedy: "choose-other-file";
    }
  | {
      /**
       * The file.
       */
      path: string;
      remedy: "overwrite";
    }
  | {
      input: InputName;
      remedy: "correct-input";
    }
  | {
      /**
       * What.
       */
      inputs: InputName[];
      remedy: "leave-out";
    }
  | {
      /**
       * All.
       */
      known: string[];
      /**
       * Those with similar names.
       */
      near: string[];
      remedy: "choose-known";
    }
  | {
      /**
       * All.
       */
      known: string[];
      remedy: "choose-load-case";
    }
  | {
      remedy: "enter-length";
    }
  | {
      remedy: "enter-angle";
    }
  | {
      remedy: "select-two-edges";
    }
  | {
      remedy: "move-ends-apart";
    }
  | {
      remedy: "move-out-of-line";
    }
  | {
      remedy: "move-end-alone";
    }
  | {
      remedy: "free-vertex";
    }
  | {
      /**
       * The nearest that can be made, with its unit.
       */
      radius: string;
      remedy: "use-radius";
    }
  | {
      remedy: "lengthen-edges";
    }
  | {
      remedy: "correct-profile";
    }
  | {
      remedy: "add-key";
      /**
       * What to write.
       */
      text: string;
    }
  | {
      remedy: "see-schema";
    }
  | {
      /**
       * The folder.
       */
      folder: string;
      remedy: "move-file";
    }
  | {
      /**
       * Its new name.
       */
      name: string;
      remedy: "rename-file";
    }
  | {
      remedy: "choose-other-id";
    }
  | {
      /**
       * Those that it can be.
       */
      ids: string[];
      remedy: "inherit-from";
    }
  | {
      remedy: "use-child";
    }
  | {
      remedy: "remove-parent";
    }
  | {
      /**
       * The kinds.
       */
      kinds: string[];
      remedy: "choose-kind";
    }
  | {
      remedy: "copy-profile";
    }
  | {
      remedy: "set-home";
    }
  | {
      /**
       * The machines.
       */
      known: string[];
      remedy: "choose-machine";
    }
  | {
      remedy: "choose-machine-and-material";
    }
  | {
      remedy: "take-as-nominal";
    }
  | {
      remedy: "turn-back";
    }
  | {
      remedy: "take-face-edges";
    }
  | {
      remedy: "import-face-edges";
    }
  | {
      remedy: "trace-surface";
    }
  | {
      remedy: "open-as-wireframe";
    }
  | {
      remedy: "plan-again";
    }
  | {
      /**
       * The machine; null for any that can do it.
       */
      machine: string | null;
      remedy: "plan-for-machine";
    }
  | {
      remedy: "plan-within-limit";
    }
  | {
      remedy: "make-job";
    }
  | {
      remedy: "use-job";
    }
  | {
      remedy: "use-design";
    }
  | {
      remedy: "use-program-file";
    }
  | {
      remedy: "import-original";
    }
  | {
      remedy: "fix-findings";
    }
  | {
      remedy: "ignore-findings";
    }
  | {
      /**
       * Its id.
       */
      format: string;
      remedy: "export-format";
    }
  | {
      remedy: "watch-first-wire";
    }
  | {
      remedy: "install-font";
    }
  | {
      remedy: "bend-test-piece";
    }
  | {
      remedy: "save-design";
    }
  | {
      remedy: "open-design";
    }
  | {
      /**
       * It was accepted before and has been changed.
       */
      again: boolean;
      /**
       * Its library.
       */
      file: string;
      remedy: "trust-driver";
    }
  | {
      /**
       * The file or folder.
       */
      path: string;
      remedy: "restrict-access";
    }
  | {
      remedy: "list-drivers";
    }
  | {
      remedy: "name-driver-folder";
    }
  | {
      remedy: "report-to-author";
    }
  | {
      /**
       * In its words.
       */
      advice: string;
      remedy: "follow-driver";
    }
  | {
      remedy: "update-driver";
    }
  | {
      remedy: "change-driver-setting";
    }
  | {
      remedy: "reset-trust";
    }
  | {
      /**
       * Those that its driver lists.
       */
      known: string[];
      remedy: "choose-port";
    }
  | {
      remedy: "export-file";
    }
  | {
      remedy: "confirm-motion";
    }
  | {
      remedy: "answer-each-piece";
    }
  | {
      remedy: "confirm-zero";
    }
  | {
      remedy: "state-head";
    }
  | {
      remedy: "turn-head-back";
    }
  | {
      remedy: "turn-head-less";
    }
  | {
      remedy: "turn-axes-back";
    }
  | {
      remedy: "home";
    }
  | {
      remedy: "arm-again";
    }
  | {
      remedy: "arm-or-jog";
    }
  | {
      remedy: "start-or-disarm";
    }
  | {
      remedy: "continue-or-stop";
    }
  | {
      remedy: "pause-or-stop";
    }
  | {
      remedy: "wait";
    }
  | {
      remedy: "stop";
    }
  | {
      remedy: "cut-power";
    }
  | {
      remedy: "check-power-and-port";
    }
  | {
      remedy: "connect";
    }
  | {
      remedy: "connect-again";
    }
  | {
      /**
       * The port.
       */
      port: string;
      remedy: "connect-at";
    }
  | {
      remedy: "ask-again";
    }
  | {
      remedy: "answer";
    }
  | {
      remedy: "use-other-machine";
    }
  | {
      remedy: "look-at-wire";
    }
  | {
      /**
       * The machine.
       */
      machine: string;
      /**
       * Where it is.
       */
      port: string;
      remedy: "write-settings";
    }
  | {
      remedy: "set-machine";
    }
  | {
      remedy: "accept-settings";
    }
  | {
      remedy: "close-other-programs";
    }
  | {
      remedy: "choose-wire";
    }
  | {
      remedy: "choose-job";
    }
  | {
      remedy: "resume-run";
      run: RunTarget;
    }
  | {
      remedy: "abandon-run";
      run: RunTarget;
    }
  | {
      /**
       * The machine has counted how much of it is done.
       */
      counted: boolean;
      remedy: "answer-doubt";
      run: RunTarget;
      /**
       * The step, from 1.
       */
      step: number;
    }
  | {
      remedy: "resume-without-answer";
      run: RunTarget;
    }
  | {
      remedy: "stop-and-answer";
      run: RunTarget;
    }
  | {
      remedy: "measure-step";
    }
  | {
      remedy: "cut-by-hand";
    }
  | {
      remedy: "begin-anew";
    }
  | {
      remedy: "name-runs-folder";
    }
  | {
      remedy: "list-runs";
    }
  | {
      remedy: "record-again";
    }
  | {
      /**
       * The machine.
       */
      machine: string;
      remedy: "replay-here";
    }
  | {
      remedy: "record-first";
    };
/**
 * Something that a person gives.
 */
export type InputName =
  | "format"
  | "scale"
  | "units"
  | "weld"
  | "face-edges"
  | "centreline-radius"
  | "tolerance"
  | "shortest-edge"
  | "layers"
  | "handedness"
  | "program"
  | "machine"
  | "material"
  | "double"
  | "detours"
  | "wires"
  | "closed"
  | "start"
  | "reverse"
  | "keep-order"
  | "collisions"
  | "avoid-collisions"
  | "clearance"
  | "sag"
  | "runs"
  | "within"
  | "supports"
  | "gravity"
  | "loads"
  | "modes"
  | "pieces"
  | "bow"
  | "faces"
  | "requirements"
  | "vary"
  | "feed-share"
  | "continuum"
  | "expected"
  | "epsilon"
  | "time-limit"
  | "group-by"
  | "profile-id"
  | "profile-name"
  | "format-settings"
  | "moves"
  | "resume"
  | "abandon"
  | "simulated-as"
  | "readings"
  | "profile-values"
  | "profile-keys"
  | "date";
/**
 * What a question is about.
 */
export type QuestionKind =
  "head" | "move" | "arm" | "piece" | "go-on" | "pause" | "doubt" | "said" | "settings" | "console";
/**
 * What reports that a step is done.
 */
export type DoneBy = "machine" | "clock";
/**
 * What is calibrated apart from the others.
 */
export type KindName = "bends" | "feeds" | "turns";
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
      vertices: PastedVertex[];
    }
  | {
      edges: number[];
      edit: "delete";
      /**
       * Construction lines that are deleted with them, by their places in the list, from 0.
       */
      lines?: number[];
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
      between: [number, number] | null;
      edit: "angle";
      /**
       * The normal of the plane to turn in, of any length, where the edges are in line.
       *
       * @minItems 3
       * @maxItems 3
       */
      normal: [number, number, number] | null;
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
      joint: Joint | null;
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
      turn_deg: number;
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
      left: boolean;
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
      edges: number[];
      edit: "doublings";
    }
  | {
      edit: "start";
      vertex: number | null;
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
      note: string | null;
      /**
       * Which time the wires come there, from 1, over all wires in their order.
       */
      pass: number;
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
      material: string | null;
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
 * The kind of a finding: a name that stays the same.
 */
export type DiagnosticCode =
  | "zero_length_edge"
  | "parallel_edges"
  | "coincident_vertices"
  | "edges_meet"
  | "isolated_vertex"
  | "several_wires"
  | "no_edges"
  | "no_euler_path"
  | "route_refused"
  | "edge_too_short"
  | "edge_near_limit"
  | "bend_too_sharp"
  | "bend_near_limit"
  | "bend_out_of_reach"
  | "bend_too_small"
  | "lead_too_short"
  | "corner_too_near"
  | "corner_within_reach"
  | "head_not_measured"
  | "bend_in_scatter"
  | "corner_not_made"
  | "fold_back"
  | "doubled_edge"
  | "feed_too_short"
  | "feed_near_limit"
  | "arcs_overlap"
  | "feed_too_long"
  | "rotation_out_of_range"
  | "stock_too_long"
  | "wire_does_not_fit"
  | "bend_torque_low"
  | "bend_radius_small"
  | "part_sags"
  | "meets_machine"
  | "meets_stock"
  | "no_clear_program"
  | "frame_unsupported"
  | "frame_mechanism"
  | "strut_overstressed"
  | "strut_near_buckling"
  | "frame_too_soft"
  | "strut_floating"
  | "no_head_direction"
  | "out_of_workspace"
  | "sequence_not_found"
  | "sequence_wrong";
/**
 * What can be done about a finding, where the finding is.
 */
export type RemedyReport =
  | {
      remedy: "leave";
    }
  | {
      remedy: "leave_touching";
    }
  | {
      remedy: "leave_room";
    }
  | {
      remedy: "hold_up";
    }
  | {
      remedy: "tie_wires";
    }
  | {
      remedy: "fasten_there";
    }
  | {
      remedy: "join_edges";
    }
  | {
      remedy: "draw_edges";
    }
  | {
      remedy: "take_face_edges";
    }
  | {
      remedy: "delete_edge";
    }
  | {
      remedy: "delete_parallel_edge";
    }
  | {
      remedy: "merge_vertices";
    }
  | {
      remedy: "connect_vertex";
    }
  | {
      remedy: "delete_vertex";
    }
  | {
      remedy: "connect_parts";
    }
  | {
      remedy: "bend_each_part";
    }
  | {
      /**
       * The length that they add, in mm.
       */
      added_mm: number;
      /**
       * The length of the wire's edges without them, in mm.
       */
      design_mm: number;
      edges: number[];
      remedy: "double_edges";
    }
  | {
      /**
       * The length that they add, in mm.
       */
      added_mm: number;
      /**
       * By id; one may be there more than once.
       */
      edges: number[];
      remedy: "detour";
    }
  | {
      remedy: "find_doubling";
    }
  | {
      remedy: "reduce_odd_vertices";
    }
  | {
      /**
       * The change in doubled length, in mm, where no bend there is beyond the limit then; negative where it gets shorter.
       */
      added_mm?: number | null;
      remedy: "start_at_vertex";
    }
  | {
      remedy: "end_at_vertex";
    }
  | {
      remedy: "choose_start";
    }
  | {
      remedy: "leave_start_open";
    }
  | {
      remedy: "split_design";
    }
  | {
      remedy: "split_edge";
    }
  | {
      /**
       * By at least so much, in mm, where that is known.
       */
      by_mm?: number | null;
      remedy: "lengthen_edge";
    }
  | {
      remedy: "shorten_straight";
    }
  | {
      remedy: "add_bend";
    }
  | {
      remedy: "scale_up";
    }
  | {
      remedy: "scale_down";
    }
  | {
      remedy: "open_angle";
    }
  | {
      remedy: "open_angle_of_two";
    }
  | {
      /**
       * The largest bend that can be reached, in degrees.
       */
      max_deg: number;
      remedy: "keep_bend_below";
    }
  | {
      remedy: "enlarge_bend";
    }
  | {
      remedy: "straighten";
    }
  | {
      remedy: "ease_bends";
    }
  | {
      remedy: "turn_bend_plane";
    }
  | {
      remedy: "move_apart";
    }
  | {
      remedy: "avoid_collisions";
    }
  | {
      remedy: "search_longer";
    }
  | {
      remedy: "allow_wires";
    }
  | {
      remedy: "calibrate";
    }
  | {
      remedy: "measure_body";
    }
  | {
      remedy: "support_vertices";
    }
  | {
      remedy: "brace_frame";
    }
  | {
      remedy: "build_later";
    }
  | {
      remedy: "turn_head";
    }
  | {
      remedy: "move_frame";
    }
  | {
      remedy: "allow_more_sag";
    }
  | {
      remedy: "choose_material";
    }
  | {
      remedy: "choose_machine";
    }
  | {
      remedy: "choose_machine_with_rotation";
    };
/**
 * A change with which a search finds a program that hits nothing: it was tried.
 */
export type HelpReport =
  | {
      help: "more-wires";
      /**
       * One a wire.
       */
      walks: WalkReport[];
    }
  | {
      /**
       * What they add to the wire, in mm.
       */
      added_mm: number;
      /**
       * Which.
       */
      edges: number[];
      help: "double-edges";
      /**
       * One a wire.
       */
      walks: WalkReport[];
    }
  | {
      /**
       * How far that is, in mm.
       */
      by_mm: number;
      help: "move-vertex";
      /**
       * Where it goes, in mm.
       *
       * @minItems 3
       * @maxItems 3
       */
      to_mm: [number, number, number];
      /**
       * Which.
       */
      vertex: number;
      /**
       * One a wire.
       */
      walks: WalkReport[];
    };
/**
 * What is in the way of a search.
 */
export type ObstacleName = "body" | "stock" | "head-limit";
/**
 * A kind of change that may help a search.
 */
export type ChangeName = "more-wires" | "double-edges" | "move-vertex";
/**
 * How bad a finding is.
 */
export type SeverityName = "error" | "warning" | "info";
/**
 * What a profile describes.
 */
export type Kind = "machine" | "material" | "noise" | "strut-builder";
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
 * What a file to be run is.
 */
export type RunFileKind = "job" | "program" | "moves";
/**
 * How far a wire has to stay from what it could hit while it is bent: zero or more.
 */
export type Clearance = number;
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
 * Something that a driver can do.
 */
export type Capability =
  | "export"
  | "live"
  | "jog"
  | "home"
  | "pause"
  | "resume"
  | "stop"
  | "ports"
  | "settings"
  | "dry-run"
  | "speed"
  | "before-zero"
  | "console"
  | "cut";
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
 * What a mode is.
 */
export type ModeKindName = "rigid" | "global" | "local";
/**
 * How joints are closed.
 */
export type ClosingName = "aligned" | "coupled";
export type Seen = "document" | "wireframe" | "stencil" | "both" | "job" | "moves";
/**
 * What an edit would make, and what the machine of the design needs of it; 0 where everything can be made. Lengths in mm.
 */
export type EditOutcome =
  | {
      /**
       * How many chords, of each corner in the order in which they are listed.
       */
      chords: number[];
      /**
       * The nearest radius of which no check warns: the one that was asked for where that is so; null where there is none.
       */
      clear_mm: number | null;
      /**
       * What it has to be at least.
       */
      needed_mm: number;
      outcome: "fillet";
      /**
       * The shortest chord.
       */
      shortest_mm: number;
    }
  | {
      /**
       * How long that would be.
       */
      length_mm: number;
      /**
       * The nearest radius that can be made at all corners, and where there is one such, of which no check warns; null where there
       * is none.
       */
      nearest_mm: number | null;
      /**
       * What it has to be at least.
       */
      needed_mm: number;
      outcome: "no-fillet";
      part: FilletPart;
      /**
       * The first corner at which it cannot.
       */
      vertex: number;
    }
  | {
      /**
       * How many edges, all alike.
       */
      edges: number;
      /**
       * Whether they can be made.
       */
      fits: boolean;
      /**
       * The most edges of a turn, up to as many as are asked for, that can be made; null where no number of them can.
       */
      fitting: number | null;
      /**
       * How long each is.
       */
      length_mm: number;
      /**
       * What it has to be at least.
       */
      needed_mm: number;
      outcome: "shape";
    };
/**
 * What of a fillet is too short.
 */
export type FilletPart = "chords" | "edges";
/**
 * What can be off.
 */
export type ErrorSourceName = "feed" | "rotation" | "bend" | "curvature";
/**
 * Where a sample lies among the pairs of its table.
 */
export type SamplePlace = "pair" | "between" | "beyond";
/**
 * What became of a wire.
 */
export type Outcome = "finished" | "sent" | "abandoned" | "unfinished";
/**
 * Whether the machine or a person has said how much of a step is done.
 */
export type ToldBy = "person" | "machine";
/**
 * A rule of building.
 */
export type ObstacleRuleName = "whole-frame" | "sag" | "head-direction" | "floating" | "workspace";
/**
 * What a step adds.
 */
export type StepTypeName = "ground" | "create" | "connect";
/**
 * How an order was found.
 */
export type StrategyName = "from-ground" | "stiffness-plan" | "restart" | "backtracking" | "paper-cost";
/**
 * What lengths in messages are written in.
 */
export type ShownUnit = "mm" | "inch";
/**
 * What can be required.
 */
export type RequirementName = "surface" | "force" | "stress";
/**
 * Something that an operator reports.
 */
export type OperatorEvent =
  | (MachineState & {
      event: "state";
    })
  | ((
      | {
          lines: string[];
          news: "about";
        }
      | {
          news: "homing";
        }
      | {
          /**
           * How long the machine was at work on the wire, in all of its parts, without pauses, s.
           */
          elapsed_s: number;
          /**
           * How far the machine is in the step after the last that is done, in part of the step's time, from where it reports
           * its axes; 0 where it reports none.
           */
          in_step: number;
          /**
           * The last step that is done.
           */
          made: number;
          news: "wire";
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
           * Index of the wire, from 0.
           */
          wire: number;
        }
      | {
          /**
           * What a machine is told of a bend whose axis stops at zero or before it: where the axis stands when the peg comes out. The bend
           * is to the other side, whatever the sign of `bend_deg`.
           */
          approach_deg?: number | null;
          /**
           * How far it is bent.
           */
          bend_deg: number;
          /**
           * How far the wire is fed.
           */
          feed_mm: number;
          news: "position";
          /**
           * How far it is turned about itself.
           */
          rotate_deg: number;
        }
      | {
          news: "console";
          /**
           * The line.
           */
          text: string;
          /**
           * Whether it went to the machine.
           */
          to_machine: boolean;
        }
      | (ProblemReport & {
          news: "warning";
        })
      | {
          by: PausedBy;
          news: "paused";
        }
      | {
          news: "resumed";
        }
    ) & {
      event: "news";
    })
  | (Question & {
      event: "question";
    })
  | {
      answer: Answer;
      event: "answered";
      id: number;
    }
  | {
      event: "jogged";
      made: Move;
    }
  | (RunResponse & {
      event: "run-ended";
    })
  | {
      by: StoppedBy;
      /**
       * Whether the driver was ended for it, or had ended before: then the machine has to be connected anew.
       */
      driver_ended: boolean;
      event: "stopped";
      /**
       * From the call to its end, ms.
       */
      took_ms: number;
    }
  | (ProblemReport & {
      event: "problem";
    });
/**
 * Why a machine holds.
 */
export type PausedBy = "program" | "silence" | "machine";
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
 * Why wires, or moves by hand, were not begun.
 */
export type LeftBecause = "declined" | "nothing-to-resume" | "nobody-asked";
/**
 * What became of a wire.
 */
export type RunOutcome = ("made" | "stopped") | "made-before" | "sent" | "failed" | "abandoned";
/**
 * Whether a machine that was stopped, or whose driver was lost or has reported a fault, stands.
 */
export type Standstill = "awaited" | "confirmed" | "not-confirmed";
/**
 * What sent the stop.
 */
export type StoppedBy = "driver" | "nothing-more" | "end-of-driver" | "end-of-simulation" | "host";
/**
 * The kind of an error: a name that stays the same.
 */
export type ErrorCode =
  | "ask"
  | "at-work"
  | "begun-elsewhere"
  | "bend-too-far"
  | "beyond-limit"
  | "busy"
  | "calibration"
  | "closed-wires"
  | "closing-joints"
  | "compensated"
  | "confirmation-of-another"
  | "confirmation-used"
  | "connected-before"
  | "contradiction"
  | "damaged-job"
  | "declined"
  | "document"
  | "document-changed"
  | "document-closed-wires"
  | "document-dangling"
  | "document-empty"
  | "document-inconsistent"
  | "document-json"
  | "document-newer"
  | "document-no-such-version"
  | "document-not-finite"
  | "document-save"
  | "document-stencil"
  | "document-stencil-damaged"
  | "document-stencils"
  | "document-wireframe"
  | "document-write"
  | "document-wrong-format"
  | "driver-broken"
  | "driver-changed"
  | "driver-died"
  | "driver-ended"
  | "driver-garbage"
  | "driver-hung"
  | "driver-library"
  | "driver-limits-unknown"
  | "driver-load"
  | "driver-not-trusted"
  | "driver-refused"
  | "driver-settings"
  | "driver-start"
  | "driver-too-large"
  | "driver-too-old"
  | "driver-trust"
  | "driver-unsafe"
  | "edit"
  | "exists"
  | "faces"
  | "failure"
  | "file-changed"
  | "files-only"
  | "format-of-another"
  | "head-beyond"
  | "head-not-kept"
  | "head-too-far"
  | "head-turned"
  | "head-unknown"
  | "held"
  | "id-taken"
  | "in-doubt"
  | "is-a-job"
  | "job-not-kept"
  | "journal-damaged"
  | "journal-empty"
  | "journal-exists"
  | "journal-impossible"
  | "journal-in-use"
  | "journal-io"
  | "journal-newer"
  | "json"
  | "left-in-wire"
  | "load-case"
  | "machine-at-work"
  | "machine-fault"
  | "machine-geometry"
  | "moves"
  | "moves-of-another"
  | "no-answer"
  | "no-bender"
  | "no-driver"
  | "no-edge"
  | "no-example"
  | "no-file"
  | "no-frame"
  | "no-job"
  | "no-limit"
  | "no-machine"
  | "no-material"
  | "no-modes"
  | "no-order"
  | "no-own-folder"
  | "no-port"
  | "no-question"
  | "no-run"
  | "no-settings"
  | "no-shear-modulus"
  | "no-stencil"
  | "no-surface"
  | "no-thread"
  | "no-vertex"
  | "no-walks"
  | "no-wire"
  | "noise-profile"
  | "not-a-job"
  | "not-begun"
  | "not-confirmed"
  | "not-connected"
  | "not-counted"
  | "not-feasible"
  | "not-kept"
  | "not-now"
  | "not-of-step"
  | "not-permitted"
  | "not-simulated"
  | "no-cutter"
  | "end-too-short"
  | "nothing"
  | "nothing-begun"
  | "nothing-recorded"
  | "nothing-to-revert"
  | "nothing-unfinished"
  | "nowhere-to-record"
  | "nowhere-to-trust"
  | "off-zero"
  | "only-lengths"
  | "only-stencil"
  | "open-parent"
  | "other-compensation"
  | "other-kind"
  | "other-library"
  | "other-machine"
  | "other-step"
  | "other-wire"
  | "out-of-order"
  | "own-program"
  | "picture"
  | "profile-abstract"
  | "profile-bad-id"
  | "profile-changed"
  | "profile-cycle"
  | "profile-duplicate-id"
  | "profile-id-not-file-name"
  | "profile-missing"
  | "profile-newer-version"
  | "profile-not-text"
  | "profile-rule"
  | "profile-shadows-shipped"
  | "profile-shape"
  | "profile-syntax"
  | "profile-too-large"
  | "profile-unknown"
  | "profile-unknown-id"
  | "profile-unknown-kind"
  | "profile-unknown-parent"
  | "profile-unknown-reference"
  | "profile-unreadable"
  | "profile-wrong-folder"
  | "question-open"
  | "read-elsewhere"
  | "read-empty"
  | "read-index"
  | "read-io"
  | "read-library"
  | "read-loop"
  | "read-no-corner"
  | "read-no-layers"
  | "read-no-such-layer"
  | "read-number"
  | "read-other-design"
  | "read-scale"
  | "read-stencil"
  | "read-syntax"
  | "read-tolerance"
  | "read-too-deep"
  | "read-too-large"
  | "read-too-many"
  | "read-truncated"
  | "read-unknown-format"
  | "read-unsupported"
  | "read-wireframe"
  | "runs-folder"
  | "sequence-file"
  | "session-purpose"
  | "session-stale"
  | "session-state"
  | "settings-differ"
  | "settled"
  | "several-kinds"
  | "several-runs"
  | "several-unfinished"
  | "shipped-profile"
  | "springback-table"
  | "stage-not-reached"
  | "stale"
  | "start-without-edge"
  | "stencil-missing"
  | "steps"
  | "still-moving"
  | "stop-not-confirmed"
  | "stop-not-confirmed-yet"
  | "stopped"
  | "stopped-before"
  | "stopped-since"
  | "strut-without-length"
  | "unfinished"
  | "unknown-format"
  | "unsupported"
  | "unwritable"
  | "unwritten"
  | "usage"
  | "value"
  | "which-wire"
  | "without-effect"
  | "wrong-answer"
  | "zero-not-confirmed";
/**
 * The kind of an error, which gives the exit status.
 */
export type ErrorKind = "usage" | "bad-input" | "not-feasible" | "failure" | "stopped" | "may-move";

export interface All {
  responses: Responses;
  events: Events;
}
export interface Responses {
  about: AboutResponse;
  answer: MachineNow;
  "apply-calibration": CalibrateApplyResponse;
  "avoid-collisions": AvoidedCollisions;
  "by-hand": ByHandResponse;
  "calibrate-compare": CalibrateCompareResponse;
  "calibrate-enter": CalibrateEnterResponse;
  "calibrate-fit": CalibrationReport;
  "calibrate-new": CalibrateNewResponse;
  "calibrate-sheet": CalibrationSheet;
  "change-settings": SettingsChanged;
  check: LiveCheck;
  "check-run-file": RunFileNow;
  "clear-recent": Started;
  "clear-recording": Recorded;
  close: DesignOpened;
  "close-run-file": RunFileNow;
  collisions: Collisions;
  compare: CompareResponse;
  connect: MachineNow;
  "copy-profile": ProfileNewResponse;
  discard: Started;
  "draw-head": HeadReport;
  "driver-trust": DriverTrustResponse;
  drivers: DriversResponse;
  edit: EditMade;
  examples: ExamplesResponse;
  export: ExportPreview;
  "export-profile": ProfileExportResponse;
  exports: ExportsResponse;
  "fix-all": FixAllResponse;
  fixes: FixesResponse;
  frame: FrameShown;
  "frame-choices": FrameChoices;
  "import-profile": ProfileImportResponse;
  "load-cases": LoadCases;
  look: LookResponse;
  "machine-state": MachineNow;
  "machine-view": MachineViewResponse;
  machines: MachinesResponse;
  made: MadeResponse;
  materials: MaterialsResponse;
  new: DesignOpened;
  open: DesignOpened;
  "open-example": DesignOpened;
  "open-run-file": RunFileNow;
  order: MachineNow;
  outcome: OutcomeResponse;
  ports: PortsResponse;
  predict: PredictedDesign;
  "profile-explain": ProfileExplainResponse;
  "profile-view": ProfileView;
  program: ProgramResponse;
  "put-stencil": EditMade;
  "put-wireframe": EditMade;
  recorded: Recorded;
  redo: EditMade;
  restore: DesignOpened;
  "revert-profile": ProfileView;
  "run-file": RunFileNow;
  runs: RunsResponse;
  "runs-show": RunsShowResponse;
  save: DesignOpened;
  "save-frame": SavedFrame;
  "save-job": SavedJob;
  "save-recording": SavedRecording;
  "save-wireframe": SavedWireframe;
  sequence: DrawnSequence;
  "set-profile": ProfileView;
  "show-lengths": LengthsShown;
  start: Started;
  "stop-avoiding": AvoidingStopped;
  "stop-collisions": CollisionsStopped;
  "stop-frame": FrameStopped;
  "stop-prediction": PredictionStopped;
  "stop-sequence": SequenceStopped;
  tolerance: ToleranceResponse;
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
  version: string;
}
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
   * An order is being carried out, or a person is asked because of it: what is reported of the phase is not its end.
   */
  busy: boolean;
  /**
   * The orders that are possible now.
   */
  can: OrderName[];
  /**
   * The others, and why they are not possible now.
   */
  cannot: RefusedOrder[];
  /**
   * Where its cutter is, mm, if it has one: how far beyond the place where a wire begins, or inside of it below zero.
   */
  cutter_mm: number | null;
  /**
   * What is being done within that, in a word or two.
   */
  doing: string | null;
  driver: string | null;
  /**
   * What it says that it is.
   */
  identity: string | null;
  machine: string;
  /**
   * Something moves, or may move without being asked again.
   */
  may_move: boolean;
  phase: Phase;
  /**
   * Where it is; null where no port was named and none is known yet.
   */
  port: string | null;
  /**
   * Where its axes are, in canonical signs.
   */
  position: JobStep | null;
  /**
   * What failed last; null once something else was ordered.
   */
  problem: ProblemReport | null;
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
  simulated_as: SimulatedAs;
  /**
   * How fast it is, percent of the programmed speed; null where that cannot be changed.
   */
  speed_percent: number | null;
  /**
   * The last wire on it, where that was interrupted and can be resumed.
   */
  unfinished: Unfinished | null;
  /**
   * The wire that is armed or being bent, or that was the last.
   */
  wire: WireState | null;
}
/**
 * An order that is not possible now.
 */
export interface RefusedOrder {
  because: Because;
  order: OrderName;
}
/**
 * Feed, then rotate, then bend, in canonical signs.
 */
export interface JobStep {
  /**
   * What a machine is told of a bend whose axis stops at zero or before it: where the axis stands when the peg comes out. The bend
   * is to the other side, whatever the sign of `bend_deg`.
   */
  approach_deg?: number | null;
  /**
   * How far it is bent.
   */
  bend_deg: number;
  /**
   * How far the wire is fed.
   */
  feed_mm: number;
  /**
   * How far it is turned about itself.
   */
  rotate_deg: number;
}
/**
 * What failed, or is worth a warning.
 */
export interface ProblemReport {
  /**
   * A name that stays the same while the wording changes. Drivers have names of their own.
   */
  code: string;
  /**
   * What is wrong, and where.
   */
  message: string;
  /**
   * What can be done about it.
   */
  remedies?: ErrorRemedy[];
}
/**
 * A wire of a job that was begun.
 */
export interface RunTarget {
  /**
   * The job's file; null where it is in no file.
   */
  job: string | null;
  /**
   * The machine that was named for a program.
   */
  machine: string | null;
  /**
   * The wire that was named for a program.
   */
  material: string | null;
  /**
   * The port that was named.
   */
  port: string | null;
  /**
   * Index of the wire, from 0; null where the job has no other.
   */
  wire: number | null;
}
/**
 * What a person is asked.
 */
export interface Question {
  /**
   * The step that it is about, where it is not known whether that was done.
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
  question: string;
}
/**
 * A step in doubt: it is not known whether it was done.
 */
export interface Doubt {
  before: PartOfStep;
  /**
   * How much of it is in the wire as the machine has counted; null where it cannot tell.
   */
  counted: PartOfStep | null;
  designed: JobStep;
  /**
   * How far that is in part of the step's time; 0 where it cannot tell.
   */
  in_step: number;
  /**
   * The last step that was sent: when this one was done, the next ones up to it are in doubt, too.
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
  told: JobStep;
  /**
   * Index of the wire, from 0.
   */
  wire: number;
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
 * What can be said of where the head stands, degrees from where its cable is unwound.
 */
export interface HeadAsked {
  /**
   * Where it was left; null where that is not known.
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
 * A wire that was interrupted and can be resumed.
 */
export interface Unfinished {
  /**
   * The id of its record.
   */
  id: string;
  /**
   * Steps in doubt, of which it is not known whether they were done: the first and the last.
   *
   * @minItems 2
   * @maxItems 2
   */
  in_doubt: [number, number] | null;
  job_hash: string;
  /**
   * The last step that is known to be done.
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
   * Which piece it is, where several were to be bent in a row.
   */
  piece: Piece | null;
  /**
   * Where it was begun.
   */
  port: string;
  /**
   * Whether it can be resumed: its record may be damaged. Then it can be given up, and nothing is known of when and
   * where it was begun.
   */
  resumable: boolean;
  started: string;
  /**
   * Index of the wire, from 0.
   */
  wire: number;
}
/**
 * One of several pieces of the same, which are bent in a row.
 */
export interface Piece {
  /**
   * Counted from 1.
   */
  number: number;
  /**
   * How many there were to be.
   */
  of: number;
}
/**
 * How far a wire is.
 */
export interface WireState {
  done_by: DoneBy;
  /**
   * How long the machine was at work on it, in all of its parts, without pauses, s.
   */
  elapsed_s: number;
  /**
   * How far the machine is in the step after `made`, in part of the step's time, from where it reports its axes; 0 where
   * it reports none.
   */
  in_step: number;
  /**
   * Hash of its job: the open design may give another one by now.
   */
  job_hash: string;
  /**
   * The last step that is done, or whose time is over where the machine does not report that.
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
   * Which piece it is, where several are bent in a row.
   */
  piece: Piece | null;
  /**
   * What is estimated to be left, s.
   */
  remaining_s: number;
  /**
   * The last that the machine has taken.
   */
  sent: number;
  /**
   * Wire that is left before it, mm; null where that is not known.
   */
  stock_left_mm: number | null;
  /**
   * Index of the wire in its job, from 0.
   */
  wire: number;
}
export interface CalibrateApplyResponse {
  /**
   * The files of both.
   */
  files: string[];
  /**
   * The new machine.
   */
  machine: string;
  /**
   * The new wire.
   */
  material: string;
  report: CalibrationReport;
}
/**
 * What measurements tell of a machine and a wire.
 */
export interface CalibrationReport {
  /**
   * What was found and cannot be, so that readings are wrong.
   */
  doubts: string[];
  /**
   * What the measurements do not tell, and what is done for want of it.
   */
  gaps: string[];
  kinds: KindReport[];
  left_out: LeftOutReport[];
  machine: string;
  material: string;
  /**
   * The error by leave-one-out of the other shape, degrees, where it can be fitted.
   */
  other_shape: MisfitReport | null;
  /**
   * What the springback depends on there.
   */
  other_shape_name: string | null;
  /**
   * What the springback depends on: `constant`, `curve`, or `moved`, the curve of the profile moved by one angle; absent where no bend was measured.
   */
  shape: string | null;
}
/**
 * How readings of a kind were fitted.
 */
export interface KindReport {
  after: MisfitReport;
  before: MisfitReport;
  kind: KindName;
  leave_one_out: MisfitReport;
  parameters: ParameterReport[];
  /**
   * How many independent combinations of the parameters the readings tell.
   */
  rank: number;
  readings: number;
  /**
   * Standard deviation of a reading.
   */
  scatter: number;
  /**
   * Unit of the readings: `deg` or `mm`.
   */
  unit: string;
  values: ReadingReport[];
}
/**
 * How far readings are from a model, in mm or degrees.
 */
export interface MisfitReport {
  mean_abs: number;
  rms: number;
}
/**
 * A parameter as it was found.
 */
export interface ParameterReport {
  before: number;
  /**
   * How much of what is known of it comes from the readings, 0 to 1.
   */
  determined: number;
  /**
   * Whether the readings determine it better than it was known before.
   */
  identified: boolean;
  /**
   * Whether it was left as it was, since they do not.
   */
  left: boolean;
  /**
   * What it is, for people.
   */
  name: string;
  /**
   * `mm`, `deg` or empty for a ratio.
   */
  unit: string;
  value: number;
  /**
   * With 95 % it is within this of the value.
   */
  within_95: number;
}
/**
 * A reading beside what the fitted model makes of its command.
 */
export interface ReadingReport {
  commanded: number;
  fitted: number;
  /**
   * Line of the sheet, from 1.
   */
  line: number;
  read: number;
  /**
   * Which reading of the line, from 1.
   */
  reading: number;
}
/**
 * A reading that was left out.
 */
export interface LeftOutReport {
  coupon: string;
  expected: number;
  kind: KindName;
  /**
   * Line of the sheet, from 1.
   */
  line: number;
  /**
   * Why, for people.
   */
  message: string;
  read: number;
  /**
   * Which reading of the line, from 1.
   */
  reading: number;
}
/**
 * What came of a search for wires that hit nothing.
 */
export interface AvoidedCollisions {
  /**
   * The best wires, where they hit less than the design's, or as much and come near less often; tried with a check for collisions.
   */
  best: Fix | null;
  /**
   * Whether a person has ended the search, or the trials after it, before it was done.
   */
  ended: boolean;
  /**
   * Whether wires were found that hit nothing.
   */
  found: boolean;
  /**
   * What was tried and helps.
   */
  helps: HelpFix[];
  /**
   * How many steps were checked.
   */
  steps_checked: number;
  /**
   * For each part of the design without a program what was in the way.
   */
  unfound: DiagnosticReport[];
}
/**
 * Something that fixes what a check says. Lengths in mm.
 */
export interface Fix {
  after: FixTotals;
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
   * For a button: "Run the wire along 13 edges twice (+102.0 mm)", "Move vertex 41 by 3.2 mm".
   */
  title: string;
}
/**
 * Sums over all wires of the design afterwards. Null where one of them is not known.
 */
export interface FixTotals {
  /**
   * How many things they hit while they are bent; null where that was not looked for.
   */
  collisions: number | null;
  /**
   * Price of that stock: each wire wastes a tail besides.
   */
  cost: number | null;
  /**
   * Designed length, mm.
   */
  length_mm: number | null;
  /**
   * How many things they do not hit, but come nearer to than the clearance; null where that was not looked for.
   */
  near: number | null;
  /**
   * Stock to load, mm.
   */
  stock_mm: number | null;
  /**
   * Time on the machine, s.
   */
  time_s: number | null;
  /**
   * How many wires there are.
   */
  wires: number;
}
/**
 * Sums over all wires of the design afterwards, less those of before. Null where one of them is not known, as
 * without a route.
 */
export interface FixChange {
  /**
   * Price of the stock to load.
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
  warnings: number;
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
  support: boolean;
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
  scale: number;
  /**
   * How far it is moved along x, y and z, mm.
   *
   * @minItems 3
   * @maxItems 3
   */
  shift_mm: [number, number, number];
  /**
   * How far it is turned about the x axis, then about the y axis, then about the z axis of the design, degrees.
   *
   * @minItems 3
   * @maxItems 3
   */
  turn_deg: [number, number, number];
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
 * A finding: what is wrong or worth knowing.
 */
export interface DiagnosticReport {
  /**
   * The body of the machine that the wire hits, as its profile calls it.
   */
  body?: string | null;
  code: DiagnosticCode;
  /**
   * The edge that it is about foremost.
   */
  edge?: number | null;
  /**
   * All its edges, where there are several.
   */
  edges?: number[];
  /**
   * What to do: the remedies in words.
   */
  help: string;
  /**
   * The limit, in `unit`.
   */
  limit?: number | null;
  /**
   * Why the limit is what it is, where its profile or driver says so: `limit_source` without what it stands in.
   */
  limit_reason?: string | null;
  /**
   * Where the limit comes from.
   */
  limit_source?: string | null;
  /**
   * What it says, with its figures: a sentence without a full stop.
   */
  message: string;
  /**
   * What can be done about it, the most promising first.
   */
  remedies?: RemedyReport[];
  /**
   * Of a search that has found no program without a collision: what was in its way, and what helps.
   */
  search?: UnfoundReport | null;
  severity: SeverityName;
  /**
   * The step of the program, counted from 0.
   */
  step?: number | null;
  /**
   * The unit of value and limit: `mm`, `deg`, `mpa`, or none for a count and for a share.
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
 * Why a search has found nothing, and what was tried after it.
 */
export interface UnfoundReport {
  /**
   * How far the wire had to stay from it, mm.
   */
  clearance_mm: number;
  /**
   * Whether a person has ended the search or these trials: there may be changes that were not tried.
   */
  ended: boolean;
  /**
   * Whether every walk of one wire was tried.
   */
  exhausted: boolean;
  /**
   * The changes that were tried and help, one of a kind at most.
   */
  helps: HelpReport[];
  /**
   * What was in the way there; null where it did not begin.
   */
  obstacle: ObstacleName | null;
  /**
   * How many there are.
   */
  of: number | null;
  /**
   * How many edges were passed where it came farthest, counted as often as they are to be passed; null where it did not begin.
   */
  passed: number | null;
  /**
   * How many steps it has checked; 0 where it did not begin.
   */
  steps_checked: number;
  /**
   * The kinds of changes that were tried until one helped, or to the end.
   */
  tried: ChangeName[];
}
/**
 * The way of a wire along the edges: it is cut at its first and its last vertex.
 */
export interface WalkReport {
  /**
   * In their order.
   */
  edges: number[];
  /**
   * The vertex where it begins.
   */
  from: number;
  /**
   * The vertex where it ends.
   */
  to: number;
}
/**
 * What a fix would change in the drawing. Positions in mm.
 */
export interface FixPreview {
  /**
   * Edges that would be detached from the others, or bent from further wires.
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
   * @minItems 3
   * @maxItems 3
   */
  at_mm: [number, number, number];
  vertex: number;
}
/**
 * A change that helps, as an edit.
 */
export interface HelpFix {
  fix: Fix;
  help: HelpReport;
}
/**
 * The wire that moves by hand have bent.
 */
export interface ByHandResponse {
  /**
   * How many moves are done.
   */
  moves: number;
  wire: PlayedWire;
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
  designed: JobStep;
  /**
   * The edges along which it feeds.
   */
  edges: number[];
  /**
   * Where wire and machine are, from the step's beginning to its end.
   */
  moments: MomentReport[];
  /**
   * What a person has to do after it before the machine goes on; null where it does not wait.
   */
  pause: string | null;
  /**
   * Where a pause point after it is put; null after the last step, and where the wire is of no open design.
   */
  place: PausePlace | null;
  pose: PoseReport;
  /**
   * Seconds for feed, rotate, the bend axis there and back, and for waiting.
   *
   * @minItems 4
   * @maxItems 4
   */
  seconds: [number, number, number, number];
  /**
   * What is sent to the machine, in canonical signs; null where the wire is not compensated.
   */
  told: JobStep | null;
  /**
   * The vertex at which it bends, or at which the wire ends.
   */
  vertex: number | null;
}
/**
 * Where wire and machine are at one moment of a step. Between two moments everything moves evenly.
 */
export interface MomentReport {
  /**
   * The part of the step's time that has passed, from 0 to 1. Two moments at the same time: it jumps.
   */
  at: number;
  /**
   * How far the bend axis has turned, right-handed about z of the head, degrees: it goes there and comes back.
   */
  bend_axis_deg: number;
  /**
   * How much of the bend is in the wire, from 0 to 1: it stays.
   */
  bent: number;
  /**
   * How much of the feed is through the bend point, from 0 to 1.
   */
  fed: number;
  /**
   * How far the head has turned, right-handed about x of the machine's frame, degrees.
   */
  head_deg: number;
  /**
   * Where the peg is along its own axis: at 0 it is in, so that the wire can pass it, at 1 it is out and bends.
   */
  peg_out: number;
}
/**
 * A vertex, and which time the wires come to it: where a pause point can be put.
 */
export interface PausePlace {
  /**
   * From 1, over all wires in their order.
   */
  pass: number;
  vertex: number;
}
/**
 * How the wire lies in the machine while it runs a step. Frame of the machine: mm, right-handed, the origin is the bend
 * point, x the way the wire leaves, z the bend axis of the head at its reference. The point of the wire that is just
 * leaving lies at the origin.
 */
export interface PoseReport {
  /**
   * The axis through the origin about which the wire that is out then turns, a vector of length 1 in the machine's frame.
   *
   * @minItems 3
   * @maxItems 3
   */
  bend_axis: [number, number, number];
  /**
   * How far it turns, right-handed, degrees.
   */
  bend_deg: number;
  /**
   * From the frame of the design to that of the machine, while the wire is fed and the head rotates: a quaternion of
   * length 1, x, y, z, w.
   *
   * @minItems 4
   * @maxItems 4
   */
  turn: [number, number, number, number];
}
export interface CalibrateCompareResponse {
  /**
   * @minItems 2
   * @maxItems 2
   */
  machines: [string, string];
  /**
   * @minItems 2
   * @maxItems 2
   */
  materials: [string, string];
  /**
   * Where a sheet was given: how well each fits its readings.
   */
  misfits: VersionMisfit[];
  /**
   * What differs of machine and wire.
   */
  values: ComparedValue[];
}
/**
 * How far readings are from what a version predicts.
 */
export interface VersionMisfit {
  kind: KindName;
  /**
   * Of both.
   *
   * @minItems 2
   * @maxItems 2
   */
  misfits: [MisfitReport, MisfitReport];
  /**
   * `deg` or `mm`.
   */
  unit: string;
}
/**
 * A value that differs.
 */
export interface ComparedValue {
  /**
   * Dotted key.
   */
  key: string;
  kind: Kind;
  /**
   * Where both come from.
   *
   * @minItems 2
   * @maxItems 2
   */
  sources: [string | null, string | null];
  /**
   * The values of both; null where one has none.
   *
   * @minItems 2
   * @maxItems 2
   */
  values: [unknown, unknown];
}
export interface CalibrateEnterResponse {
  /**
   * How many readings were entered.
   */
  entered: number;
  /**
   * How many cells are empty.
   */
  missing: number;
  /**
   * How many readings it has now.
   */
  readings: number;
  /**
   * How many were there before in their rows, and gave way to them.
   */
  replaced: number;
  /**
   * The sheet.
   */
  sheet: string;
}
export interface CalibrateNewResponse {
  /**
   * How many coupons there are, without their repeats.
   */
  coupons: number;
  /**
   * The jobs; each of their wires is a coupon.
   */
  jobs: string[];
  machine: string;
  material: string;
  /**
   * The sheet to print: a protractor in true size, and boxes for what is read.
   */
  printed: string;
  repeats: number;
  /**
   * How long the machine bends, estimated, s.
   */
  seconds: number;
  /**
   * The table for what is measured.
   */
  sheet: string;
  /**
   * Wire that is fed for all of them, mm.
   */
  wire_mm: number;
}
/**
 * A sheet with what has been read so far.
 */
export interface CalibrationSheet {
  /**
   * The jobs of coupons that lie beside it.
   */
  jobs: string[];
  /**
   * The machine that the coupons were planned for.
   */
  machine: string;
  /**
   * Their wire.
   */
  material: string;
  rows: CalibrationRow[];
  sheet: string;
}
/**
 * One thing to be read of equal coupons.
 */
export interface CalibrationRow {
  commanded: number;
  coupon: string;
  /**
   * Line of the sheet, from 1.
   */
  line: number;
  /**
   * What was read; null where nothing was.
   */
  readings: (number | null)[];
  /**
   * Which row of the coupon, from 1.
   */
  row: number;
  /**
   * `deg` or `mm`.
   */
  unit: string;
  /**
   * What was wanted; of a side from corner to corner.
   */
  wanted: number;
  /**
   * `bend`, `side`, `turn` or `turn-back`.
   */
  what: string;
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
export interface MachineViewResponse {
  /**
   * Largest bends to both sides, degrees.
   *
   * @minItems 2
   * @maxItems 2
   */
  bend_deg: [number, number];
  description: string;
  /**
   * Thinnest and thickest wire, mm.
   *
   * @minItems 2
   * @maxItems 2
   */
  diameter_mm: [number, number];
  driver: string;
  /**
   * Why its driver cannot be used; null where it can.
   */
  driver_problem: ProblemReport | null;
  /**
   * Its profile.
   */
  file: string;
  /**
   * Whether its bend head was measured on the machine itself, by a person or by calibrating; null where it has no peg.
   */
  head_measured: boolean | null;
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
   * Shortest edge beside a bend of 90°, mm, with the machine's own wire, wherever it is in the wire: a bend takes a part of it, and
   * the feed has a limit too. Null where that is not known.
   */
  min_edge_between_mm: number | null;
  /**
   * Shortest designed edge, mm.
   */
  min_edge_mm: number;
  /**
   * Shortest feed, mm.
   */
  min_feed_mm: number;
  name: string;
  /**
   * How far the peg reaches beyond the middle of the wire along the bend axis while it is out, mm.
   */
  peg_top_mm: number;
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
  key: string;
  /**
   * The line in it, from 1.
   */
  line: number | null;
  /**
   * The profile that sets it; null where it is the driver's default.
   */
  set_by: string | null;
  value: unknown;
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
   * So far from the bend point, along the wire that is being bent, that wire may touch the body, millimetres: for what
   * guides or bends the wire. Absent: nowhere.
   */
  contact_zone_mm?: number;
  /**
   * True when they were measured on the real machine.
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
  /**
   * So far from a vertex other struts that meet there may touch the body, millimetres: they give way. Only with
   * `contact_zone_mm`. Absent: nowhere.
   */
  vertex_zone_mm?: number;
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
   * One for each wire: the wires of a part that is not joined to others follow one another.
   */
  wires: WireFigures[];
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
   * How far the part already bent sags while it is bent; null where the design does not ask for it, or nothing is bent.
   */
  sag: SagReport | null;
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
 * How far the part already bent sags at most under its own weight while it is bent.
 */
export interface SagReport {
  /**
   * How far its free end is from where it would be without weight, mm.
   */
  deflection_mm: number;
  /**
   * Where the wire misses itself the most; null where it never comes back to a vertex.
   */
  joint: JointSagReport | null;
  /**
   * How far the part reaches from the bend point then, mm. A sag of more than a tenth of it is only indicated.
   */
  reach_mm: number;
  /**
   * The step of the program in which that is, counted from 0: at the end of its feed, or while it bends.
   */
  step: number;
}
/**
 * Where the wire comes back to a vertex that it has passed before, and how far the part has sagged there.
 */
export interface JointSagReport {
  /**
   * How far apart the two places of the wire are, that should be one, mm.
   */
  off_mm: number;
  /**
   * The step of the program whose feed brings it there, counted from 0.
   */
  step: number;
  /**
   * The vertex.
   */
  vertex: number;
}
export interface RunFileNow {
  /**
   * Null where none is open: the design is run.
   */
  file: RunFileReport | null;
}
/**
 * What is open to be run.
 */
export interface RunFileReport {
  /**
   * Whether the machine can make it, as its profile was when a job was planned; a program that collides cannot be made.
   */
  feasible: boolean;
  /**
   * What the checks say of its wires, errors first.
   */
  findings: DiagnosticReport[];
  /**
   * Hash of the job that it is run as; another one where the same name holds other contents.
   */
  job_hash: string;
  kind: RunFileKind;
  /**
   * Machine and wire that it is for.
   */
  machine: string;
  material: string;
  /**
   * How many moves a recording has.
   */
  moves: number;
  /**
   * Name of the file, without its folder.
   */
  name: string;
  /**
   * Errors despite which a job was planned; of a program, that the search for collisions did not end.
   */
  notes: NoteReport[];
  /**
   * Where it is; null for bytes.
   */
  path: string | null;
  wires: RunFileWire[];
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
  /**
   * What can be done about it.
   */
  remedies?: ErrorRemedy[];
}
/**
 * A wire of it.
 */
export interface RunFileWire {
  /**
   * Wire that is fed, mm.
   */
  length_mm: number;
  steps: number;
  /**
   * Stock to load, mm.
   */
  stock_mm: number;
  time_s: number;
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
  warnings: ProblemReport[];
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
   * By id.
   */
  vertices: VertexView[];
}
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
   * Whether it is part of the ceiling; absent where it is not.
   */
  ceiling?: boolean;
  id: number;
}
/**
 * All but vertices, edges and surfaces.
 */
export interface DesignState {
  /**
   * Whether there is something that the file has not.
   */
  changed: boolean;
  /**
   * Whether the wire ends where it starts.
   */
  closed: boolean;
  collisions: CollisionSettings;
  /**
   * Lines that are no wire, each by its two ends, mm.
   */
  construction_mm: [[number, number, number], [number, number, number]][];
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
   * The parts that were named, coloured or hidden.
   */
  parts: PartView[];
  /**
   * Where the machine waits for a person, by vertex.
   */
  pauses: PauseView[];
  /**
   * What would be done again.
   */
  redo: string | null;
  /**
   * Whether the wire runs the other way.
   */
  reversed: boolean;
  /**
   * The vertex where the wire starts.
   */
  start: number | null;
  /**
   * The surfaces to trace on. What has another id is another surface.
   */
  stencils: StencilView[];
  /**
   * What would be undone.
   */
  undo: string | null;
  units: LengthUnit;
  /**
   * Why changes are not kept safe: a person should save. Null where they are.
   */
  unkept: ProblemReport | null;
  /**
   * The walks that were chosen, one for each wire; empty where they are found anew.
   */
  walks: ChosenWalk[];
  /**
   * How many wires there may be.
   */
  wires: number;
}
/**
 * How collisions are looked for.
 */
export interface CollisionSettings {
  clearance_mm: Clearance;
  /**
   * Whether the part already bent is looked at as it hangs under its own weight.
   */
  sag: boolean;
}
/**
 * How the part looks that an edge belongs to: all struts that hang together with it.
 */
export interface PartView {
  /**
   * One edge of it.
   */
  edge: number;
  look: Look;
}
/**
 * Where the machine waits for a person.
 */
export interface PauseView {
  /**
   * What the person has to do.
   */
  note: string;
  /**
   * Which time the wires come there, from 1, over all wires in their order.
   */
  pass: number;
  vertex: number;
}
/**
 * A surface to trace on.
 */
export interface StencilView {
  id: number;
  look: Look;
  /**
   * Its name, or that of its file.
   */
  name: string;
  placement: Placement;
  /**
   * Its surface; null where that is in a file that was not found.
   */
  surface: SurfaceView | null;
}
/**
 * A surface, in its own frame.
 */
export interface SurfaceView {
  faces: number;
  /**
   * The rows of the matrix that takes a point of it, mm, to where it lies in the design.
   *
   * @minItems 3
   * @maxItems 3
   */
  matrix: [[number, number, number, number], [number, number, number, number], [number, number, number, number]];
  /**
   * The middle of the box around it, mm.
   *
   * @minItems 3
   * @maxItems 3
   */
  middle_mm: [number, number, number];
  /**
   * How far the box reaches along x, y and z, mm.
   *
   * @minItems 3
   * @maxItems 3
   */
  size_mm: [number, number, number];
}
export interface VertexView {
  /**
   * Where it is, mm, right-handed.
   *
   * @minItems 3
   * @maxItems 3
   */
  at_mm: [number, number, number];
  id: number;
  /**
   * What holds the struts together there; absent where nothing does.
   */
  joint?: Joint | null;
  /**
   * Whether the design holds it fixed.
   */
  support: boolean;
}
/**
 * A file that was open.
 */
export interface RecentEntry {
  name: string;
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
   * In the order in which they ran.
   */
  moves: Move[];
}
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
 * Where the wires of a design meet the machine or themselves while they are bent.
 */
export interface Collisions {
  /**
   * How many bodies the machine's profile has.
   */
  bodies: number;
  /**
   * Whether every wire was looked at to its end: not where it was stopped, and not without a route.
   */
  checked: boolean;
  /**
   * Of each wire in the order of its steps.
   */
  contacts: ContactReport[];
  /**
   * How many of them have dimensions that were not measured.
   */
  estimates: number;
  /**
   * Whether somebody has stopped it, or asked for a later one.
   */
  stopped: boolean;
}
/**
 * A first contact of a wire with one thing that it meets, as it is played.
 */
export interface ContactReport {
  /**
   * The part of the step's time that has passed by then, from 0 to 1.
   */
  at: number;
  /**
   * The body of the machine that it meets, by its place in the profile from 0; null: the wire that is still to be bent.
   */
  body: number | null;
  /**
   * How deep they are in each other at the worst of that step, mm; below zero: they only come so near.
   */
  depth_mm: number;
  /**
   * Whether where it is depends on dimensions that were not measured.
   */
  estimated: boolean;
  finding: DiagnosticReport;
  /**
   * In how many later steps they meet again in this way.
   */
  later: number;
  /**
   * The step, from 0, that has made the part of the wire that is met.
   */
  leg: number;
  /**
   * The step in which it happens, from 0.
   */
  step: number;
  /**
   * The wire, from 0, of those that have a program.
   */
  wire: number;
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
   * Where the wires hit the machine or themselves; null where nobody asked, or not every wire has a program.
   */
  collisions: CollisionCount | null;
  /**
   * Price of the wire that is fed, in `currency`; null also where the price is not known.
   */
  cost: number | null;
  /**
   * Of the costs.
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
  machine: string;
  /**
   * Mass of the wire that is fed, in g.
   */
  mass_g: number | null;
  /**
   * The wire in it: the one that was asked for, else the document's, else the machine's own.
   */
  material: string;
  name: string;
  /**
   * Price of the stock to load, in `currency`; null also where the price is not known.
   */
  stock_cost: number | null;
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
 * How many things wires hit while they are bent.
 */
export interface CollisionCount {
  /**
   * How many of them are bodies whose dimensions are estimates.
   */
  estimated: number;
  /**
   * How many: each body of the machine, and the wire itself, once for each wire.
   */
  hits: number;
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
   * Where the wires hit the machine or themselves; null where nobody asked, or not every wire has a program.
   */
  collisions: CollisionCount | null;
  /**
   * Price of the wire that is fed, in `currency`; null also where the price is not known.
   */
  cost: number | null;
  /**
   * Of the costs.
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
   * Whether the wire fits the machine.
   */
  fits: boolean;
  machine: string;
  /**
   * Mass of the wire that is fed, in g.
   */
  mass_g: number | null;
  /**
   * The wire in it: the one that was asked for, else the document's, else the machine's own.
   */
  material: string;
  name: string;
  newly_feasible: Findings;
  newly_infeasible: Findings;
  newly_warned: Findings;
  /**
   * The same with the machine's own wire, where that of the design does not fit it, and where its own is based on that of the design, as
   * a calibrated one is; null where the machine has no other wire, and in the comparison with its own wire.
   */
  own_wire: OtherSide | null;
  /**
   * Price of the stock to load, in `currency`; null also where the price is not known.
   */
  stock_cost: number | null;
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
  bends: number | null;
  /**
   * Of the cost; null also where the currencies differ.
   */
  cost: number | null;
  mass_g: number | null;
  /**
   * Of the cost of the stock, likewise.
   */
  stock_cost: number | null;
  stock_mm: number | null;
  time_s: number | null;
}
/**
 * What is found and where it is; ids ascend, each once.
 */
export interface Findings {
  /**
   * What it is.
   */
  diagnostics: WireDiagnostic[];
  edges: number[];
  steps: WireStep[];
  vertices: number[];
}
/**
 * One thing to know of a wire, or of the design.
 */
export interface WireDiagnostic {
  /**
   * The body of the machine that the wire hits, as its profile calls it.
   */
  body?: string | null;
  code: DiagnosticCode;
  /**
   * The edge that it is about foremost.
   */
  edge?: number | null;
  /**
   * All its edges, where there are several.
   */
  edges?: number[];
  /**
   * What to do: the remedies in words.
   */
  help: string;
  /**
   * The limit, in `unit`.
   */
  limit?: number | null;
  /**
   * Why the limit is what it is, where its profile or driver says so: `limit_source` without what it stands in.
   */
  limit_reason?: string | null;
  /**
   * Where the limit comes from.
   */
  limit_source?: string | null;
  /**
   * What it says, with its figures: a sentence without a full stop.
   */
  message: string;
  /**
   * What can be done about it, the most promising first.
   */
  remedies?: RemedyReport[];
  /**
   * Of a search that has found no program without a collision: what was in its way, and what helps.
   */
  search?: UnfoundReport | null;
  severity: SeverityName;
  /**
   * The step of the program, counted from 0.
   */
  step?: number | null;
  /**
   * The unit of value and limit: `mm`, `deg`, `mpa`, or none for a count and for a share.
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
export interface ProfileNewResponse {
  /**
   * Its file; null where it is returned.
   */
  file: string | null;
  id: string;
  /**
   * The id of its parent.
   */
  inherits: string;
  kind: Kind;
}
/**
 * A bend head from above. Frame: the origin is where a bend begins, x along the wire that comes, y to the side of a positive
 * bend.
 */
export interface HeadReport {
  /**
   * Its peg; absent where the bend axis itself is the bend.
   */
  peg?: PegReport | null;
  /**
   * Radius of the pin that the wire wraps, mm.
   */
  pin_radius_mm: number;
  /**
   * Diameter of the wire, mm.
   */
  wire_mm: number;
}
/**
 * The peg of a bend head.
 */
export interface PegReport {
  /**
   * Where it is while the wire is bent to a right angle, mm; null where it does not get there.
   *
   * @minItems 2
   * @maxItems 2
   */
  at_mm: [number, number] | null;
  /**
   * Where its axis is then, degrees; null likewise.
   */
  axis_deg: number | null;
  /**
   * Offset s of the orbit's centre along the wire, mm.
   */
  orbit_offset_mm: number;
  /**
   * Radius R of its orbit, mm.
   */
  orbit_radius_mm: number;
  radius_mm: number;
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
  name: string | null;
  /**
   * Its SHA-256.
   */
  sha256: string;
  version: string | null;
}
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
export interface DriverEntry {
  /**
   * What it can do.
   */
  capabilities: Capability[];
  description: string | null;
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
  name: string | null;
  /**
   * Why it cannot be used.
   */
  problem: string | null;
  /**
   * What can be done about that.
   */
  remedies?: ErrorRemedy[];
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
   * Whether a machine runs it. Then it is not written for a design that cannot be made, unless a person says so.
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
  gone_edges: number[];
  gone_vertices: number[];
  state: DesignState;
  /**
   * Vertices that were added or changed.
   */
  vertices: VertexView[];
}
export interface ExamplesResponse {
  /**
   * Simple ones first.
   */
  examples: ExampleEntry[];
}
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
  name: string;
}
/**
 * A file, or the beginning of what it would be.
 */
export interface ExportPreview {
  /**
   * Of each file that would be written its first lines; null of one that is no text.
   */
  beginnings: (string | null)[];
  bytes: number[];
  /**
   * All of each file that would be written, in Base64; empty where that was not asked for.
   */
  contents: string[];
  /**
   * Whether the machine can make it.
   */
  feasible: boolean;
  /**
   * The files that were written.
   */
  files: string[];
  format: string;
  /**
   * What was assumed or left out.
   */
  notes: NoteReport[];
}
export interface ProfileExportResponse {
  /**
   * Its file; null where it is returned.
   */
  file: string | null;
  id: string;
  kind: Kind;
  /**
   * What a person should know.
   */
  notes: NoteReport[];
  /**
   * Other profiles that are in the file.
   */
  with: SharedProfile[];
}
/**
 * A profile that goes with another one.
 */
export interface SharedProfile {
  id: string;
  kind: Kind;
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
  problems: ProblemReport[];
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
  name: string;
  /**
   * Whether it is the machine's own or one that its profile lists.
   */
  of_machine: boolean;
  /**
   * Whether a machine runs it: then it is not written for a design that cannot be made.
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
 * What would fix all of a kind.
 */
export interface FixAllResponse {
  /**
   * Null where fewer than two can be fixed, where that would leave more errors than there are, or where the search was
   * stopped.
   */
  all: FixAll | null;
}
/**
 * What fixes all findings of a kind, as one edit.
 */
export interface FixAll {
  fix: Fix;
  /**
   * How many findings of the kind there are less.
   */
  fixed: number;
  /**
   * How many there are now.
   */
  of: number;
}
/**
 * What would fix what the checks say.
 */
export interface FixesResponse {
  /**
   * In the order of the diagnostics, the best of each first.
   */
  fixes: Fix[];
}
/**
 * The open design as a frame, and what the view draws of it.
 */
export interface FrameShown {
  result: FrameResponse;
  shapes: FrameShapes;
}
/**
 * A design as a structure. Linear: small displacements, Hooke's law, rigid joints.
 */
export interface FrameResponse {
  /**
   * The same where struts bow; null where nobody asked.
   */
  bowed: BowedReport | null;
  /**
   * The frame once its joints are closed; null where nobody asked. Roots of mean squares: over the runs, or expected of all wires.
   */
  closing: ClosingReport | null;
  /**
   * What is wrong, worst first.
   */
  diagnostics: DiagnosticReport[];
  /**
   * Those that were written.
   */
  files: string[];
  frame: FrameFigures;
  /**
   * Whether it holds what acts on it.
   */
  holds: boolean;
  material: string;
  /**
   * By rising frequency, rigid ones foremost.
   */
  modes: ModeReport[];
  /**
   * What was merged, ignored or assumed while reading.
   */
  notes: NoteReport[];
  /**
   * Over the runs.
   */
  of_runs: ClosingRuns | null;
  /**
   * What the wires take, as Bend-Forming reckons it; null where joints are not closed.
   */
  resources: ResourcesReport | null;
  /**
   * How many wires were drawn; null where the figures are the exact expectation, or nobody asked.
   */
  runs: number | null;
  /**
   * What loads do; null where nothing holds the frame, or it does not stand.
   */
  static: StaticReport | null;
  timings_ms: {
    [k: string]: number;
  };
}
/**
 * How the frame vibrates where its struts bow.
 */
export interface BowedReport {
  /**
   * By rising frequency, rigid ones foremost.
   */
  modes: ModeReport[];
  /**
   * The lowest frequency at which something bends, as a share of that of straight struts.
   */
  of_straight: number;
  seed: number;
  share: number;
}
export interface ModeReport {
  /**
   * The strut of a local mode.
   */
  edge?: number | null;
  frequency_hz: number;
  kind: ModeKindName;
}
/**
 * A closed frame: over drawn wires roots of mean squares, or those that are expected of all.
 */
export interface ClosingReport {
  /**
   * Force along a strut, RMS over the struts.
   */
  axial_rms_n: number;
  /**
   * What is stored in the wire.
   */
  energy_n_mm: number;
  /**
   * Of how many faces the surface is; null where all vertices count.
   */
  faces: number | null;
  /**
   * How far passes through one vertex are apart at most before they are pulled together; null for an expectation, and where no vertex
   * is passed twice.
   */
  gap_mm: number | null;
  /**
   * The largest force that pulls a pass of the wire to its vertex; null where joints are rigid from the start.
   */
  largest_pull_n: number | null;
  model: ClosingName;
  /**
   * How far the vertices of the faces are from the planes that fit them best, RMS; without faces how far all are from where they
   * should be.
   */
  surface_rms_mm: number;
  /**
   * How far all vertices are from where they should be, after the motion of the whole that fits them best, RMS: without faces the
   * same.
   */
  vertices_rms_mm: number;
  /**
   * Von Mises stress, RMS over the struts, at four points of the surface all along them.
   */
  von_mises_rms_mpa: number;
}
/**
 * The frame that was computed.
 */
export interface FrameFigures {
  /**
   * Length of all struts.
   */
  length_mm: number;
  /**
   * Their mass, without joints.
   */
  mass_g: number;
  /**
   * Struts, each edge once.
   */
  members: number;
  /**
   * Vertices at which struts end.
   */
  nodes: number;
  /**
   * Vertices that are held.
   */
  supports: number;
}
/**
 * Over all runs.
 */
export interface ClosingRuns {
  mean: ClosingFigures;
  /**
   * Standard deviations, with one wire less than there are in the denominator; null of a single wire.
   */
  sd: ClosingFigures | null;
}
/**
 * Figures of closed frames.
 */
export interface ClosingFigures {
  /**
   * Force along a strut, RMS over the struts.
   */
  axial_rms_n: number;
  /**
   * What is stored in the wire.
   */
  energy_n_mm: number;
  /**
   * How far passes through one vertex are apart at most before they are pulled together; null for an expectation, and where no vertex
   * is passed twice.
   */
  gap_mm: number | null;
  /**
   * The largest force that pulls a pass of the wire to its vertex; null where joints are rigid from the start.
   */
  largest_pull_n: number | null;
  /**
   * How far the vertices of the faces are from the planes that fit them best, RMS; without faces how far all are from where they
   * should be.
   */
  surface_rms_mm: number;
  /**
   * How far all vertices are from where they should be, after the motion of the whole that fits them best, RMS: without faces the
   * same.
   */
  vertices_rms_mm: number;
  /**
   * Von Mises stress, RMS over the struts, at four points of the surface all along them.
   */
  von_mises_rms_mpa: number;
}
/**
 * What the wires take, as Table 1 of Bend-Forming has it. Time is energy at the authors' 25 W, and not the time of the machine.
 */
export interface ResourcesReport {
  /**
   * Of all wires.
   */
  bends: number;
  /**
   * Null where the material's profile does not say what forming takes.
   */
  energy_kj: number | null;
  /**
   * What joins the wires at vertices, g.
   */
  joints_g: number;
  /**
   * Of all wires as designed, mm.
   */
  length_mm: number;
  /**
   * Wire and joints, g.
   */
  mass_g: number;
  time_min: number | null;
  wire_g: number;
}
/**
 * What loads do to the frame.
 */
export interface StaticReport {
  /**
   * The vertex that moves farthest.
   */
  at_vertex: number;
  max_displacement_mm: number;
  /**
   * By edge.
   */
  members: MemberReport[];
  reactions: ReactionReport[];
  /**
   * How far forces are from balance at a vertex, as a share of the largest.
   */
  residual: number;
  /**
   * What the loads have done on their way.
   */
  work_n_mm: number;
}
/**
 * What a strut carries.
 */
export interface MemberReport {
  /**
   * Tension in its middle; negative is compression.
   */
  axial_n: number;
  /**
   * Compression as a share of the Euler load of the strut with pinned ends: from 0.5 on, a linear result no longer holds.
   */
  buckling_ratio: number;
  edge: number;
  /**
   * The largest bending moment along it.
   */
  moment_n_mm: number;
  torque_n_mm: number;
  /**
   * The largest stress as a share of the yield strength; null where either is not known.
   */
  utilisation: number | null;
  /**
   * The largest along it; null where its section is no solid round, so that the place of the largest is not known.
   */
  von_mises_mpa: number | null;
}
/**
 * What a support does to the frame.
 */
export interface ReactionReport {
  /**
   * @minItems 3
   * @maxItems 3
   */
  force_n: [number, number, number];
  /**
   * @minItems 3
   * @maxItems 3
   */
  moment_n_mm: [number, number, number];
  vertex: number;
}
/**
 * The struts of a frame, and where they go.
 */
export interface FrameShapes {
  /**
   * The wires with the errors of the first drawn wire; null where joints are not closed, or no wire was drawn.
   */
  closed: ClosedShapes | null;
  /**
   * Under what acts on the frame; null where it floats or does not stand.
   */
  loaded: [number, number, number][][] | null;
  /**
   * Of each mode, the largest displacement 1 mm.
   */
  modes: [number, number, number][][][];
  /**
   * By edge.
   */
  struts: StrutLine[];
}
/**
 * Wires with errors, before and after their joints are closed.
 */
export interface ClosedShapes {
  at_vertex: number;
  /**
   * Closed, after the motion of the whole that fits the drawing best.
   */
  closed: [number, number, number][][];
  /**
   * As the machine bends them: each wire lies where it begins, and its passes through a vertex do not meet.
   */
  made: MadeLine[];
  made_at_vertex: number;
  /**
   * The largest displacement of a vertex then, and the vertex.
   */
  max_closed_mm: number;
  /**
   * The largest distance of a pass from its vertex as made, and that vertex.
   */
  max_made_mm: number;
}
/**
 * A wire, pass by pass.
 */
export interface MadeLine {
  /**
   * The vertices that it passes, mm.
   */
  at_mm: [number, number, number][];
  /**
   * How far each pass is from there, mm.
   */
  by_mm: [number, number, number][];
}
/**
 * A strut as it is drawn.
 */
export interface StrutLine {
  /**
   * Points along it, mm.
   */
  at_mm: [number, number, number][];
  edge: number;
}
/**
 * What there is to choose from for frames.
 */
export interface FrameChoices {
  /**
   * Errors of machines.
   */
  errors: NoiseEntry[];
  /**
   * Machines that build struts.
   */
  strut_builders: StrutBuilderEntry[];
}
/**
 * The errors of a machine, to choose.
 */
export interface NoiseEntry {
  id: string;
  name: string;
}
/**
 * A machine that builds struts, to choose.
 */
export interface StrutBuilderEntry {
  /**
   * What it builds with unless another material is named.
   */
  default_material: string | null;
  id: string;
  name: string;
}
export interface ProfileImportResponse {
  /**
   * Where it is now.
   */
  file: string;
  id: string;
  kind: Kind;
  /**
   * Whether it was there already, with nothing different: then nothing was written.
   */
  known: boolean;
  /**
   * Its name for people.
   */
  name: string;
  /**
   * The name that it has in the file, where another profile here is called so.
   */
  own_name: string | null;
  /**
   * Other profiles that came with it, under the ids that they have here.
   */
  with: SharedProfile[];
}
/**
 * The load cases of a file.
 */
export interface LoadCases {
  /**
   * By name.
   */
  cases: LoadCaseEntry[];
  /**
   * The file.
   */
  name: string;
}
/**
 * A load case, to choose.
 */
export interface LoadCaseEntry {
  /**
   * How many edges bear a load along them.
   */
  along_edges: number;
  /**
   * Forces at vertices.
   */
  forces: VertexForce[];
  /**
   * As multiples of standard gravity; null where the case says nothing of it.
   *
   * @minItems 3
   * @maxItems 3
   */
  gravity: [number, number, number] | null;
  /**
   * How many vertices bear a moment.
   */
  moments: number;
  name: string;
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
export interface LookResponse {
  /**
   * Whether units and scale are open: the format does not say them.
   */
  asks_units: boolean;
  /**
   * Of its lines, vertices with two edges that the machine of the open design bends; all corners without one.
   */
  bends: number;
  /**
   * What would become of the curves of a drawing; null unless the edges have a least length.
   */
  curves: CurvesReport | null;
  /**
   * Its lines.
   */
  edges: number;
  /**
   * Faces of its surface.
   */
  faces: number;
  format: string;
  /**
   * The layers of a drawing, hidden ones included.
   */
  layers: string[];
  /**
   * The name of the machine of the open design; null without one.
   */
  machine: string | null;
  /**
   * What edges it can make.
   */
  machine_edges: MachineEdges | null;
  name: string;
  /**
   * What would be merged, ignored or assumed.
   */
  notes: NoteReport[];
  /**
   * Whether the machine of the open design runs it as it stands: a program of its own format.
   */
  runs: boolean;
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
 * What was made of the curves of a drawing.
 */
export interface CurvesReport {
  /**
   * Where that is, mm.
   *
   * @minItems 3
   * @maxItems 3
   */
  at_mm: [number, number, number];
  /**
   * How many curves are farther off than the tolerance, since closer edges would be too short.
   */
  coarser: number;
  /**
   * How many curves there are.
   */
  curves: number;
  /**
   * The largest distance between the drawing and its edges, mm.
   */
  deviation_mm: number;
  /**
   * How many curves are tighter than the machine bends; 0 where it is not known.
   */
  tight: number;
  /**
   * Where that is, mm.
   *
   * @minItems 3
   * @maxItems 3
   */
  tightest_at_mm: [number, number, number] | null;
  /**
   * The radius of the tightest of these, mm.
   */
  tightest_mm: number | null;
  /**
   * How many edges are too short all the same: their curves have no room for longer ones.
   */
  too_short: number;
}
/**
 * What of edges a machine can make with its wire.
 */
export interface MachineEdges {
  /**
   * Centreline radius of its bends, mm.
   */
  bend_radius_mm: number;
  /**
   * The shortest edge between two bends of up to 90°, mm.
   */
  shortest_edge_mm: number;
}
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
   * The calibration that made this version of a machine, and of the wire that it names; absent of what none has made.
   */
  calibrated?: CalibratedVersion | null;
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
   * Whether it bends about a pin by a peg, so that a simulated machine can have its bend head.
   */
  has_peg: boolean;
  id: string;
  /**
   * Shortest designed edge, in mm.
   */
  min_edge_mm: number;
  name: string;
  /**
   * Its own format, where only its driver writes it.
   */
  native: string | null;
  /**
   * The noise profile that its errors are taken from, where its profile names one.
   */
  noise: string | null;
  /**
   * Whether it comes with the program.
   */
  shipped: boolean;
}
/**
 * A calibration that made a version of a machine and its wire.
 */
export interface CalibratedVersion {
  /**
   * The day of the measurement.
   */
  date: string;
  /**
   * The machine that it was made from.
   */
  machine: string;
  /**
   * The wire that it was made from.
   */
  material: string;
  /**
   * How many readings it was from.
   */
  readings: number;
}
/**
 * How the machine bends the open design.
 */
export interface MadeResponse {
  /**
   * Whether the driver's simulated machine bent it; otherwise the formulas of the compensation did, backwards.
   */
  by_machine: boolean;
  /**
   * What the machine reported, and what was left out.
   */
  notes: NoteReport[];
  /**
   * The wires, in the order of the program.
   */
  wires: MadeWire[];
}
/**
 * A wire as it is bent.
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
   * How it lies in the machine while each step bends it; fewer where it has fewer corners.
   */
  poses: PoseReport[];
  /**
   * Points along its middle, mm; empty where only formulas computed it.
   */
  wire_mm: [number, number, number][];
  /**
   * The largest of them.
   */
  worst_mm: number;
}
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
  diameter_mm: number;
  /**
   * Its profile.
   */
  file: string;
  id: string;
  /**
   * Depth of the neutral fibre, as a fraction of the diameter.
   */
  k_factor: number;
  name: string;
  /**
   * Price of a millimetre, in `currency`; null where it is not known.
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
export interface OutcomeResponse {
  /**
   * Null of an edit that is neither a shape nor a fillet of corners.
   */
  outcome: EditOutcome | null;
}
export interface PortsResponse {
  /**
   * Those that a machine is likely at first.
   */
  ports: PortEntry[];
  /**
   * Drivers that could not be asked, and why.
   */
  problems: string[];
  /**
   * What can be done about that.
   */
  remedies?: ErrorRemedy[];
}
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
 * How far off the open design will be.
 */
export interface PredictedDesign {
  /**
   * Null where it was stopped.
   */
  found: Prediction | null;
}
/**
 * How far off wires will be, by the formulas of the compensation turned round. Distances are taken with the first vertex and the
 * first direction in place.
 */
export interface Prediction {
  noise: string;
  /**
   * How often each wire was bent.
   */
  runs: number;
  /**
   * How exact a machine must be; null where nobody asked.
   */
  tolerance: SimulatedTolerance | null;
  wires: SimulatedWire[];
}
/**
 * How large errors may be so that each vertex, taken by itself, is near enough to its place in 95 % of the wires.
 */
export interface SimulatedTolerance {
  /**
   * How large each kind of error may be where nothing else is off.
   */
  alone: SourceTolerance[];
  /**
   * Whether a machine without errors comes as near. If not, everything else is null.
   */
  possible: boolean;
  /**
   * How many times as large as they are the errors of the noise profile may be, all together; null where it has none, or where they may
   * be as large as they like.
   */
  together: number | null;
  /**
   * How near, mm.
   */
  within_mm: number;
}
/**
 * How large one kind of error may be where nothing else is off.
 */
export interface SourceTolerance {
  /**
   * Standard deviation: mm of feeds, degrees of rotations and bends, of a strut's bow as a share of its length. Null where no error of this
   * kind takes a vertex so far.
   */
  sigma: number | null;
  source: ErrorSourceName;
}
export interface SimulatedWire {
  /**
   * Where the simulated wires hit the machine or themselves; null where nobody asked, or with a note that says why not.
   */
  collisions: SimulatedCollisions | null;
  /**
   * The vertices that are passed more than once.
   */
  gaps: GapReport[];
  /**
   * How far each kind of error alone moves the wire, the largest first; empty without errors.
   */
  sources: SourceShare[];
  /**
   * How far the errors of each step move the wire, in the order of the program; empty without errors.
   */
  steps: StepShare[];
  /**
   * In the order of the route, a vertex as often as it is passed.
   */
  vertices: VertexReport[];
  /**
   * The largest `machine_mm` of a vertex.
   */
  worst_machine_mm: number | null;
  /**
   * The largest `mean_mm`.
   */
  worst_mean_mm: number;
  /**
   * The largest `radius_95_mm`.
   */
  worst_radius_95_mm: number;
  /**
   * How far the worst vertex would be off if the axes took the commands to their resolutions, in mm.
   */
  worst_rounded_mm: number;
  /**
   * The largest `systematic_mm`.
   */
  worst_systematic_mm: number;
}
/**
 * Where the simulated wires of one wire of a job hit the machine or themselves while they are bent.
 */
export interface SimulatedCollisions {
  /**
   * How many of them hit something. What only comes nearer than the clearance does not count.
   */
  colliding: number;
  /**
   * What the checks say of each thing that is hit or nearer than the clearance, of the wire that goes deepest into it; errors first.
   */
  diagnostics: SimulatedContact[];
  /**
   * `colliding` as a share of `wires`, 0 to 1.
   */
  share: number;
  /**
   * How many wires were looked at: one that the simulated machine or, without one, the formulas bend without errors, else one for
   * each run.
   */
  wires: number;
}
/**
 * What is said of one thing that simulated wires hit.
 */
export interface SimulatedContact {
  /**
   * The body of the machine that the wire hits, as its profile calls it.
   */
  body?: string | null;
  code: DiagnosticCode;
  /**
   * The edge that it is about foremost.
   */
  edge?: number | null;
  /**
   * All its edges, where there are several.
   */
  edges?: number[];
  /**
   * What to do: the remedies in words.
   */
  help: string;
  /**
   * The limit, in `unit`.
   */
  limit?: number | null;
  /**
   * Why the limit is what it is, where its profile or driver says so: `limit_source` without what it stands in.
   */
  limit_reason?: string | null;
  /**
   * Where the limit comes from.
   */
  limit_source?: string | null;
  /**
   * What it says, with its figures: a sentence without a full stop.
   */
  message: string;
  /**
   * What can be done about it, the most promising first.
   */
  remedies?: RemedyReport[];
  /**
   * Which of the wires the finding is of, from 0.
   */
  run: number;
  /**
   * Of a search that has found no program without a collision: what was in its way, and what helps.
   */
  search?: UnfoundReport | null;
  severity: SeverityName;
  /**
   * The step of the program, counted from 0.
   */
  step?: number | null;
  /**
   * The unit of value and limit: `mm`, `deg`, `mpa`, or none for a count and for a share.
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
   * How many of the wires hit it, or come nearer to it than the clearance.
   */
  wires: number;
}
/**
 * How far the passes of the wire through one vertex lie apart.
 */
export interface GapReport {
  /**
   * Their largest distance on the simulated machine's wire, in mm; null without such a machine.
   */
  machine_mm: number | null;
  /**
   * Mean of the largest distance, in mm.
   */
  mean_mm: number;
  /**
   * How often the wire comes through.
   */
  passes: number;
  /**
   * What 95 % of the runs stay within, in mm.
   */
  radius_95_mm: number;
  vertex: number;
}
/**
 * How far one kind of error moves the wire where nothing else is off, to first order.
 */
export interface SourceShare {
  /**
   * Root mean square of the distance of all vertices from where they should be, mm.
   */
  rms_mm: number;
  source: ErrorSourceName;
}
/**
 * How far the errors of one step move the wire where nothing else is off, to first order, as root mean square over all vertices.
 */
export interface StepShare {
  /**
   * Those of its bend, mm.
   */
  bend_mm: number;
  /**
   * Those of its feed and of the bow of its strut, mm.
   */
  feed_mm: number;
  /**
   * Those of its rotation, mm.
   */
  rotate_mm: number;
  /**
   * From 1.
   */
  step: number;
  /**
   * The vertex at which it ends.
   */
  vertex: number;
}
/**
 * How far one vertex of the route lies from where it should.
 */
export interface VertexReport {
  /**
   * How far the simulated machine's wire has it from where the design has it, in mm; null without such a machine.
   */
  machine_mm: number | null;
  /**
   * Mean distance over all runs, in mm.
   */
  mean_mm: number;
  /**
   * Distance that 95 % of the runs stay within, in mm.
   */
  radius_95_mm: number;
  /**
   * The same by the closed formulas, without errors.
   */
  systematic_mm: number;
  vertex: number;
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
   * What a machine's bend axis has beside what bends each wire; absent where it states none.
   */
  bend_torque?: BendTorqueReport | null;
  /**
   * The profile itself, its parent, and so on.
   */
  chain: AncestorReport[];
  id: string;
  kind: Kind;
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
 * What the bend axis has, and what it takes to bend each wire.
 */
export interface BendTorqueReport {
  /**
   * What the axis has, N·m.
   */
  available_n_m: number;
  /**
   * There is a warning where it has less than so many times what a wire takes.
   */
  margin: number;
  /**
   * The wires that fit the machine, the strongest first.
   */
  wires: WireTorqueReport[];
}
export interface WireTorqueReport {
  /**
   * The material, by id.
   */
  material: string;
  /**
   * Plastic moment of the wire, N·m.
   */
  needed_n_m: number;
  /**
   * So many times as much the axis has.
   */
  times: number;
}
/**
 * A profile of a chain.
 */
export interface AncestorReport {
  file: string;
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
  value: unknown;
}
/**
 * A profile with what its editor needs.
 */
export interface ProfileView {
  file: string;
  /**
   * Whether its last change can be taken back.
   */
  has_last_change: boolean;
  /**
   * Of a machine its bend head; absent where its figures make none.
   */
  head?: HeadReport | null;
  profile: ProfileExplainResponse;
  /**
   * Of a machine its bodies.
   */
  shapes: Shape[];
  /**
   * Whether it comes with the program: then it cannot be changed, but copied.
   */
  shipped: boolean;
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
   * Hash of the job that arming the design as it is would give; null where none can be made. A wire of the
   * connected machine whose job has this hash is one of this very program.
   */
  job_hash: string | null;
  /**
   * Pause points of the design that no wire comes to.
   */
  left_out: LeftOutPause[];
  machine: string;
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
 * A pause point of the design after which nothing of a wire is bent.
 */
export interface LeftOutPause {
  note: string;
  /**
   * From 1, over all wires in their order.
   */
  pass: number;
  vertex: number;
  /**
   * Why, for a person.
   */
  why: string;
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
  id: string;
  /**
   * How often it was stopped or failed.
   */
  interruptions: number | null;
  job_hash: string | null;
  machine: string | null;
  /**
   * The last step that is done.
   */
  made: number | null;
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
   * At how many pause points a person has let it go on.
   */
  pauses: number | null;
  /**
   * Which piece it is, where several were to be bent in a row.
   */
  piece: Piece | null;
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
   * How far the worst corner is from the design, in mm, where that was measured.
   */
  worst_deviation_mm: number | null;
}
/**
 * One record.
 */
export interface RunsShowResponse {
  id: string;
  journal: string;
  record: Record;
}
/**
 * What was bent of a wire.
 */
export interface Record {
  /**
   * Corners of the wire, where a simulated machine bent it, mm.
   */
  corners_mm: [number, number, number][];
  /**
   * What was said of steps that were in doubt, in order.
   */
  decisions: Decision[];
  /**
   * How far each corner is from the design, mm; absent where that was not measured.
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
   * The last step that is done, or, where the machine does not report that, that has had its time.
   */
  made: number;
  outcome: Outcome;
  /**
   * Pause points at which a person has said that the wire goes on, in order.
   */
  pauses: ConfirmedPause[];
  /**
   * When it was begun.
   */
  started: string;
}
/**
 * What was said of a step in doubt: by a person, or by the machine where it had counted how far it was.
 */
export interface Decision {
  at: string;
  /**
   * Whether it was done.
   */
  made: boolean;
  /**
   * How much of it was in the wire, where it was done in part; its rest was done then.
   */
  part: PartInWire | null;
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
   * The last step that was known to be done.
   */
  after: number;
  at: string;
  /**
   * What happened, for a person.
   */
  what: string;
}
/**
 * What is to be bent, of what, on which machine.
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
  driver_version: string;
  /**
   * How long each step is reckoned to take, s; empty where there is no estimate.
   */
  estimates_s: number[];
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
   * Which piece it is, where several of the same were to be bent in a row; absent otherwise.
   */
  piece?: Piece | null;
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
 * A pause point past which a person has let the wire go on.
 */
export interface ConfirmedPause {
  /**
   * The step after which the machine has waited.
   */
  after: number;
  at: string;
  /**
   * What they had to do there.
   */
  note: string;
}
/**
 * Files that were written.
 */
export interface SavedFrame {
  /**
   * None where the frame floats or does not stand.
   */
  files: string[];
  /**
   * What was left out.
   */
  notes: NoteReport[];
}
/**
 * A job that was written.
 */
export interface SavedJob {
  file: string;
  job_hash: string;
  /**
   * What a person should know who runs it.
   */
  notes: NoteReport[];
}
/**
 * The recording that was written.
 */
export interface SavedRecording {
  file: string;
}
/**
 * A wireframe that was written.
 */
export interface SavedWireframe {
  file: string;
}
/**
 * A sequence with what a view draws of it.
 */
export interface DrawnSequence {
  /**
   * All directions of the head that the machine has.
   */
  directions: [number, number, number][];
  /**
   * Half section of the head from its tip: how far along its axis, and its radius, mm.
   */
  head_mm: [number, number][];
  /**
   * How the head moves in each step.
   */
  moves: HeadMove[];
  sequence: SequenceResponse;
  /**
   * Whether somebody has stopped the search.
   */
  stopped: boolean;
  strut_radius_mm: number;
}
/**
 * The tip of the head while a strut is built.
 */
export interface HeadMove {
  /**
   * The directions that are free, by their places; of a sequence that is checked only the one that is taken.
   */
  free: number[];
  /**
   * @minItems 3
   * @maxItems 3
   */
  from_mm: [number, number, number];
  /**
   * @minItems 3
   * @maxItems 3
   */
  to_mm: [number, number, number];
}
/**
 * The order in which a frame is built.
 */
export interface SequenceResponse {
  diagnostics: DiagnosticReport[];
  /**
   * How far a joint may be from where it is drawn.
   */
  epsilon_mm: number;
  /**
   * Whether the frame can be built in this order.
   */
  feasible: boolean;
  /**
   * The edges of each layer, from the ground; null where nobody asked, or the frame as a whole cannot be built.
   */
  layers: number[][] | null;
  /**
   * The strut builder.
   */
  machine: string;
  material: string;
  /**
   * The largest sag of all steps; null without steps, or where what is built does not stand.
   */
  max_displacement_mm: number | null;
  /**
   * How many directions of the head are free where fewest are; null where a sequence is checked.
   */
  min_free_directions: number | null;
  /**
   * What was merged, ignored or assumed while reading.
   */
  notes: NoteReport[];
  /**
   * What was in the way where a search came farthest.
   */
  obstacle: ObstacleReport | null;
  /**
   * The longest part of an order that was found; null where all of it was, or none can be.
   */
  partial: PartialReport | null;
  /**
   * Whether that is certain; a search that ended early knows nothing of orders that it did not try.
   */
  proved: boolean;
  /**
   * How many steps share a vertex with the one before.
   */
  sharing: number;
  /**
   * What is placed, the first step foremost; empty where no order was found.
   */
  steps: SequenceStepReport[];
  /**
   * How the order was found; null where none was, or one is checked.
   */
  strategy: StrategyName | null;
  /**
   * How long the machine takes; null where a sequence is checked.
   */
  time_s: number | null;
  timings_ms: {
    [k: string]: number;
  };
  /**
   * How far the head travels between struts; null where a sequence is checked.
   */
  travel_mm: number | null;
}
/**
 * What was in the way where a search came farthest.
 */
export interface ObstacleReport {
  /**
   * How far it sags.
   */
  displacement_mm: number | null;
  /**
   * The strut that cannot be placed then; null where it is the frame as a whole.
   */
  edge: number | null;
  /**
   * The struts in its way, or at the vertex that sags.
   */
  edges: number[];
  rule: ObstacleRuleName;
  /**
   * The step, from 1, that none of what stands then can be.
   */
  step: number;
  /**
   * The vertex that sags or is out of reach.
   */
  vertex: number | null;
}
/**
 * A part of an order: the edges of each step.
 */
export interface PartialReport {
  /**
   * How it begins; empty where the search takes the frame apart from its end.
   */
  first: number[][];
  /**
   * How it ends; empty where the search builds it up.
   */
  last: number[][];
}
/**
 * What is placed at once.
 */
export interface SequenceStepReport {
  /**
   * The direction of the head's axis, from the tip into the head.
   *
   * @minItems 3
   * @maxItems 3
   */
  direction: [number, number, number] | null;
  /**
   * Its edge, or the first of several.
   */
  edge: number;
  /**
   * All edges of a wire or rod; not there for a strut that is drawn.
   */
  edges?: number[];
  /**
   * How many directions are free, at the joint with the fewest; where a sequence is checked, of those that it gives.
   */
  free_directions: number;
  /**
   * The vertex from which the head draws it, or at which it stands first.
   */
  from_vertex: number | null;
  /**
   * How the head stands at each joint of a wire or rod; not there for a strut that is drawn.
   */
  joints?: SequenceJoint[];
  /**
   * The largest displacement of a vertex once it is placed; null where what is built does not stand.
   */
  max_displacement_mm: number | null;
  type: StepTypeName;
}
/**
 * How the head stands at a joint.
 */
export interface SequenceJoint {
  /**
   * @minItems 3
   * @maxItems 3
   */
  direction: [number, number, number];
  free_directions: number;
  vertex: number;
}
/**
 * How lengths are written from here on, in what is asked again.
 */
export interface LengthsShown {
  unit: ShownUnit;
}
/**
 * No search goes on any more.
 */
export interface AvoidingStopped {}
/**
 * Nothing is looked for any more.
 */
export interface CollisionsStopped {}
/**
 * No frame is computed any more.
 */
export interface FrameStopped {}
/**
 * No prediction is under way any more.
 */
export interface PredictionStopped {}
/**
 * Nothing is searched for any more.
 */
export interface SequenceStopped {}
/**
 * How good the motions of a machine must be: standard deviations without a systematic part.
 */
export interface ToleranceResponse {
  achieved: AchievedReport;
  /**
   * Of bends and rotations; null where they do not vary.
   */
  angle_sigma_deg: number | null;
  /**
   * Of feeds; null where they do not vary.
   */
  feed_sigma_mm: number | null;
  /**
   * Of a truss by closed formulas, where they are known for so many rings.
   */
  first_frequency: TrussFrequency | null;
  governed_by: RequirementName;
  material: string;
  /**
   * What was merged, ignored or assumed while reading.
   */
  notes: NoteReport[];
}
/**
 * What the frame comes to, expected of all wires; of a truss by closed formulas no stress is known.
 */
export interface AchievedReport {
  force_n: number;
  stress_mpa: number | null;
  surface_mm: number;
}
/**
 * The first frequency of a free truss by closed formulas.
 */
export interface TrussFrequency {
  /**
   * How far struts bow, as a share of their length.
   */
  bow: number;
  /**
   * The same by the exact tangent of an arc whose ends turn, and of one whose ends do not: rigid joints lie between.
   *
   * @minItems 2
   * @maxItems 2
   */
  bowed_between_hz: [number, number];
  /**
   * With struts that bow so far, as Bend-Forming has it.
   */
  bowed_hz: number;
  straight_hz: number;
}
export interface Events {
  operator: OperatorEvent;
  refusal: ApiErrorReport;
  work: Work;
}
/**
 * What became of the wires of the request.
 */
export interface RunResponse {
  /**
   * The records that were written where they were asked for.
   */
  files: string[];
  /**
   * What the machine says that it is.
   */
  identity: string | null;
  job_hash: string;
  /**
   * Wires of the piece that were asked for and are not begun: of several that a machine bends one after the other, those that follow.
   */
  left: number[];
  /**
   * Why not; null where nothing is left, or a wire before them was not finished.
   */
  left_because: LeftBecause | null;
  machine: string;
  material: string;
  /**
   * What a person should know.
   */
  notes: NoteReport[];
  pieces: PiecesReport;
  /**
   * Where the machine was; null where none was connected.
   */
  port: string | null;
  /**
   * The wires, in the order in which they were run.
   */
  wires: WireRun[];
}
/**
 * How far they are.
 */
export interface PiecesReport {
  /**
   * How many came to their end.
   */
  made: number;
  /**
   * How many there were to be.
   */
  of: number;
  /**
   * Wire that is left, mm; null where it is not known.
   */
  stock_left_mm: number | null;
}
/**
 * What became of one wire.
 */
export interface WireRun {
  /**
   * How far each vertex is from the design, in mm, where a simulated machine bent the wire.
   */
  deviations_mm: number[] | null;
  done_by: DoneBy;
  /**
   * How long the machine was at work on it, in all of its parts, without pauses, s.
   */
  elapsed_s: number;
  /**
   * The id of its record: see `wirebend runs`.
   */
  id: string;
  /**
   * Steps in doubt, of which it is not known whether they were done: the first and the last.
   *
   * @minItems 2
   * @maxItems 2
   */
  in_doubt: [number, number] | null;
  /**
   * The last step that is done, or, where the machine does not report that, that has had its time.
   */
  made: number;
  outcome: RunOutcome;
  /**
   * Which piece it is of, where there were to be several.
   */
  piece: Piece | null;
  /**
   * What failed, or why it was stopped without a request.
   */
  problem: ProblemReport | null;
  /**
   * The command that resumes it, where there is something to resume; only a command line has one.
   */
  resume: string | null;
  /**
   * Whether the machine stands after a stop, after its driver was lost, or after a fault while it might move; null
   * where there was none of them.
   */
  standstill: Standstill | null;
  /**
   * How many there are.
   */
  steps: number;
  /**
   * Wire that had to be put in, in mm.
   */
  stock_mm: number;
  /**
   * What caused a stop; null without one, and for one of the machine itself.
   */
  stopped_by: StoppedBy | null;
  /**
   * The step that was stopped in its middle, as far as the machine counts.
   */
  stopped_in: StoppedIn | null;
  /**
   * Its index, from 0.
   */
  wire: number;
}
/**
 * A step that was stopped in its middle.
 */
export interface StoppedIn {
  /**
   * Where the bend axis stands, degrees; null where the machine was homed since.
   */
  bend_at_deg: number | null;
  made: PartOfStep;
  of: JobStep;
  step: number;
  /**
   * Whether that is sure. An axis that was on its way may have lost steps: then the user has to look at the wire.
   */
  sure: boolean;
}
/**
 * Why something came to nothing. A window shows the message and may go by the code; it never compares texts.
 */
export interface ApiErrorReport {
  code: ErrorCode;
  /**
   * What the checks say, where that is the reason.
   */
  diagnostics: DiagnosticReport[];
  kind: ErrorKind;
  message: string;
  /**
   * What can be done about it.
   */
  remedies: ErrorRemedy[];
}
/**
 * How far long work is.
 */
export interface Work {
  /**
   * What was asked for.
   */
  ask: string;
  /**
   * So many things are done.
   */
  done: number;
  /**
   * What a search for programs without collisions has found; null where none goes on.
   */
  found: FoundSoFar | null;
  /**
   * Of so many; 0 where that is not known.
   */
  of: number;
  /**
   * A word or two for a person.
   */
  stage: string;
}
/**
 * What a search for programs without collisions has found until now, for the part of the design that it searches.
 */
export interface FoundSoFar {
  /**
   * The best program; null where none without collisions is found.
   */
  best: BestSoFar | null;
  /**
   * Which part it is, from 1.
   */
  part: number;
  /**
   * How many parts the design has.
   */
  parts: number;
}
/**
 * A program for a part of the design.
 */
export interface BestSoFar {
  /**
   * The length of the edges that the wires run along again, mm.
   */
  doubled_mm: number;
  /**
   * How many wires it has.
   */
  wires: number;
}
