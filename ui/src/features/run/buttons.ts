/** Which of the machine's buttons can be used, and why the others cannot, as the machine's state says. */

import type { RunFileReport } from "../../generated/responses";
import { type Because, isInWire, type MachineState, type OrderName, type Phase } from "../../state/machine/operator";

type RunFileKind = RunFileReport["kind"];

/** Why it cannot be used; null where it can. */
type Why = string | null;

/** The wire that would be armed. */
export interface Prospect {
  /** The machine that it is for; null where there is none. */
  readonly machine: string | null;
  /** Whether there is a design with a program, and whether the machine can make it. */
  readonly program: boolean;
  readonly feasible: boolean;
  /** What is run instead of the design. */
  readonly file: RunFileKind | null;
}

export interface RunButtons {
  readonly home: Why;
  readonly arm: Why;
  /** Why there is no wire of the design to arm, whatever the machine does. */
  readonly noWire: Why;
  readonly start: Why;
  readonly disarm: Why;
  /** One button that pauses or resumes. */
  readonly pause: { readonly order: "pause" | "resume"; readonly why: Why };
  readonly speed: Why;
  readonly jog: Why;
  readonly resumeRun: Why;
  readonly abandon: Why;
  readonly replay: Why;
  readonly dryRun: Why;
  readonly writeSettings: Why;
  readonly console: Why;
  readonly disconnect: Why;
  /** The button that leads on from here. */
  readonly next: "connect" | "home" | "arm" | "start" | "pause" | "resume" | null;
}

/** Why an order is not possible now. */
const BECAUSE: Readonly<Record<Because, string>> = {
  connecting: "The machine is being connected.",
  "not-homed": "Home the machine first.",
  homing: "The machine is homing.",
  moving: "The machine is being moved.",
  "no-wire-armed": "Arm the machine first.",
  "wire-armed": "The machine is armed: start or disarm it first.",
  "no-wire-under-way": "No wire is being bent.",
  "wire-under-way": "A wire is being bent.",
  holding: "The machine is paused in the middle of a wire.",
  stopping: "STOP was sent. Waiting until the machine confirms that it stands.",
  failed: "The machine failed: connect it again.",
  "not-connected": "Connect a machine first.",
  unable: "This machine cannot do that.",
  busy: "Wait until the machine is done.",
  "question-open": "Answer the question first.",
};

/** The same of what a machine's driver cannot do, where there is more to say. */
const UNABLE: Readonly<Partial<Record<OrderName, string>>> = {
  pause: "This machine cannot pause.",
  "dry-run": "This machine's driver has no dry run.",
  console: "This machine's driver takes no typed lines.",
  "write-settings": "This machine's settings cannot be written from here.",
};

function whyNot(state: MachineState | null, order: OrderName): Why {
  if (!state) return BECAUSE["not-connected"];
  const because = state.cannot.find((refused) => refused.order === order)?.because;
  if (because === undefined) return null;
  return (because === "unable" && UNABLE[order]) || BECAUSE[because];
}

/** Why there is no wire to arm. */
function whyNoWire({ program, feasible, file }: Prospect): Why {
  if (file === "moves") return "Recorded moves are replayed, not armed.";
  if (!program) return "There is no program to run: see Check.";
  if (feasible) return null;
  return file
    ? "The machine cannot make the program as it stands: see above."
    : "The machine cannot make the design: see Check.";
}

export function buttons(state: MachineState | null, prospect: Prospect): RunButtons {
  const why = (order: OrderName): Why => whyNot(state, order);
  const noWire = whyNoWire(prospect);
  // Whatever a person wants all the same: the machine would refuse it.
  const isOther = state !== null && prospect.machine !== null && state.machine !== prospect.machine;
  const other = isOther ? "The wire is for another machine than the one that is connected." : null;
  const pause = state?.phase === "holding" ? "resume" : "pause";
  return {
    home: why("home"),
    arm: why("arm") ?? other ?? noWire,
    noWire,
    start: why("start"),
    disarm: why("disarm"),
    pause: { order: pause, why: why(pause) },
    speed: why("speed"),
    jog: why("jog"),
    resumeRun: why("resume-run"),
    abandon: why("abandon"),
    replay: why("replay"),
    dryRun: why("dry-run") ?? other ?? noWire,
    writeSettings: why("write-settings"),
    console: why("console"),
    disconnect: why("disconnect"),
    next: next(state?.phase ?? "closed", (order) => why(order) === null, noWire === null && !isOther),
  };
}

/** `can`: whether that order is possible now; `wire`: whether there is one to arm. */
function next(phase: Phase, can: (order: OrderName) => boolean, wire: boolean): RunButtons["next"] {
  switch (phase) {
    case "closed":
    case "failed":
      return "connect";
    case "connected":
    case "stopped":
      return can("home") ? "home" : wire ? "arm" : null;
    case "ready":
      return wire ? "arm" : null;
    case "armed":
      return "start";
    case "making":
      return can("pause") ? "pause" : null;
    case "holding":
      return "resume";
    case "connecting":
    case "homing":
    case "moving":
    case "stopping":
      return null;
  }
}

/** How the machine stands, in a word or two. */
const PHASES: Readonly<Record<Phase, string>> = {
  connecting: "connecting",
  connected: "not homed",
  homing: "homing",
  ready: "homed",
  moving: "moving",
  armed: "armed",
  making: "bending",
  holding: "paused",
  stopping: "stopping",
  stopped: "stopped, not homed",
  failed: "failed",
  closed: "not connected",
};

/** How it stands, and what it does within that, unless it is paused; a user who is asked has to answer first. */
export function doingPhrase({ phase, doing, question }: Pick<MachineState, "phase" | "doing" | "question">): string {
  if (question) return "waits for an answer";
  return phase === "holding" ? PHASES.holding : (doing ?? PHASES[phase]);
}

/** What the header of the section says. */
export function phrase(state: MachineState | null): string {
  if (!state || state.phase === "closed") return "not connected";
  const who = state.simulated ? "simulated machine" : (state.port ?? state.machine);
  const { wire } = state;
  if (wire && isInWire(state.phase)) return `${PHASES[state.phase]} · ${wire.made} of ${wire.of} done`;
  return `${who} · ${state.phase === "stopped" ? "stopped" : PHASES[state.phase]}`;
}
