/* Made by `make generate` from crates/app/schema. Do not edit. */

/**
 * Something that an operator tells.
 */
export type OperatorEvent =
  | (MachineState & {
      event: "state";
    })
  | (News & {
      event: "news";
    })
  | (Question & {
      event: "question";
    })
  | {
      answer: Answer;
      event: "answered";
      /**
       * Which.
       */
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
  | {
      /**
       * A name that stays.
       */
      code: string;
      event: "problem";
      /**
       * What happened and what to do.
       */
      message: string;
    };
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
 * Something that happened on a machine, or is about to.
 */
export type News =
  | {
      /**
       * The lines.
       */
      lines: string[];
      news: "about";
    }
  | {
      news: "homing";
    }
  | {
      /**
       * Since the wire was begun or taken up, s.
       */
      elapsed_s: number;
      /**
       * The last step that was made.
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
  | (StepReport & {
      news: "position";
    })
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
  | {
      /**
       * A name that stays.
       */
      code: string;
      /**
       * For a person.
       */
      message: string;
      news: "warning";
    }
  | {
      by: PausedBy;
      news: "paused";
    }
  | {
      news: "resumed";
    };
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
 * Why wires, or moves by hand, were not begun.
 */
export type LeftBecause = "declined" | "nobody-asked";
/**
 * What became of a wire.
 */
export type RunOutcome = "made" | "made-before" | "sent" | "stopped" | "failed" | "abandoned";
/**
 * Whether a machine that was stopped, or whose driver was lost or has told of a fault, stands.
 */
export type Standstill = "awaited" | "confirmed" | "not-confirmed";
/**
 * Who brought the stop about.
 */
export type StoppedBy = "driver" | "nothing-more" | "end-of-driver" | "host";
/**
 * How bad it is.
 */
export type SeverityName = "error" | "warning" | "info";
/**
 * Whose turn it is.
 */
export type ErrorKind = "usage" | "bad-input" | "not-feasible" | "failure" | "stopped" | "may-move";

export interface Tells {
  operator: OperatorEvent;
  refusal: Refusal;
  work: Work;
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
 * What became of the wires that were to be made.
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
  /**
   * Hash of the job.
   */
  job_hash: string;
  /**
   * Wires that were asked for and not begun.
   */
  left: number[];
  /**
   * Why not; null where nothing is left, or a wire before them was not made.
   */
  left_because: LeftBecause | null;
  /**
   * The machine.
   */
  machine: string;
  /**
   * The material.
   */
  material: string;
  /**
   * What a person should know.
   */
  notes: NoteReport[];
  /**
   * Where the machine was; null where none was connected.
   */
  port: string | null;
  /**
   * The wires, in the order in which they were taken up.
   */
  wires: WireRun[];
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
 * What became of one wire.
 */
export interface WireRun {
  /**
   * How far each vertex is from the design, in mm, where a simulated machine made the wire.
   */
  deviations_mm: number[] | null;
  done_by: DoneBy;
  /**
   * How long it took this time, in s.
   */
  elapsed_s: number;
  /**
   * The id of its record: see `wirebend runs`.
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
   * The last step that was made, or, where the machine does not say so, that has had its time.
   */
  made: number;
  outcome: RunOutcome;
  /**
   * What failed, or why it was stopped where nobody has asked for that.
   */
  problem: RunProblem | null;
  /**
   * The command that goes on with it, where there is something to go on with.
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
   * Who brought a stop about; null without one, and for one of the machine itself.
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
   * Where the bend axis stands, degrees.
   */
  bend_at_deg: number;
  made: PartOfStep;
  of: StepReport;
  /**
   * The step.
   */
  step: number;
  /**
   * Whether that is sure. An axis that was on its way may have lost steps: then somebody has to look at the wire.
   */
  sure: boolean;
}
/**
 * Why something came to nothing. A window shows the message and may go by the code; it never compares texts.
 */
export interface Refusal {
  /**
   * A name that stays the same while the wording may change.
   */
  code: string;
  /**
   * What the checks say, where that is the reason.
   */
  diagnostics: DiagnosticReport[];
  kind: ErrorKind;
  /**
   * What is wrong, where, and what to do.
   */
  message: string;
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
   * Of so many; 0 where that is not known.
   */
  of: number;
  /**
   * A word or two for a person.
   */
  stage: string;
}
