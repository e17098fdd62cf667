/** Which of the machine's buttons can be used, and why the others cannot: by what the operator says that it can be told. */

import type { MachineState, OrderName, Phase } from "../../state/operator";

/** Why it cannot be used; null where it can. */
type Why = string | null;

/** The wire that would be armed. */
export interface Prospect {
  /** Whether there is a design with a program, and whether the machine can make it. */
  readonly program: boolean;
  readonly feasible: boolean;
}

export interface RunButtons {
  readonly home: Why;
  readonly arm: Why;
  /** Why there is no wire of the design to arm, whatever the machine does. */
  readonly noWire: Why;
  readonly start: Why;
  readonly disarm: Why;
  /** One button that pauses or goes on. */
  readonly pause: { readonly order: "pause" | "resume"; readonly why: Why };
  readonly jog: Why;
  readonly resumeRun: Why;
  readonly abandon: Why;
  readonly replay: Why;
  readonly writeSettings: Why;
  readonly disconnect: Why;
  /** The button that goes on from here. */
  readonly next: "connect" | "home" | "arm" | "start" | "pause" | "resume" | null;
}

/** Why something has to wait in a phase. */
const WAIT: Readonly<Record<Phase, string>> = {
  connecting: "The machine is being connected.",
  connected: "Home the machine first.",
  homing: "The machine is homing.",
  ready: "Arm a wire first.",
  moving: "The machine is being moved.",
  armed: "A wire is armed: start or disarm it first.",
  making: "A wire is being made.",
  holding: "The machine holds in the middle of a wire.",
  stopping: "STOP was sent. Waiting until the machine confirms that it stands.",
  stopped: "The machine was stopped: home it first.",
  failed: "The machine failed: connect it again.",
  closed: "Connect a machine first.",
};

/** Phases in which an order is being carried out all the time. */
const AT_WORK: ReadonlySet<Phase> = new Set(["connecting", "homing", "moving", "making", "holding", "stopping"]);

/** Phases in which only what the machine can do stands against an order. */
const AT_REST: ReadonlySet<Phase> = new Set(["connected", "ready", "stopped"]);

export function buttons(state: MachineState | null, prospect: Prospect): RunButtons {
  const phase = state?.phase ?? "closed";
  const wait = state?.question ? "Answer the question first." : state?.busy && !AT_WORK.has(phase) ? "Wait until the machine is done." : null;
  const why = (order: OrderName, reason = WAIT[phase]): Why => (state?.can.includes(order) ? null : (wait ?? reason));
  const holds = phase === "holding";
  const noWire = !prospect.program ? "There is no program to make: see Check." : prospect.feasible ? null : "The machine cannot make the design: see Check.";
  return {
    home: why("home"),
    arm: why("arm") ?? noWire,
    noWire,
    start: why("start", phase === "connected" || phase === "stopped" || phase === "ready" ? "Arm a wire first." : WAIT[phase]),
    disarm: why("disarm", "No wire is armed."),
    pause: { order: holds ? "resume" : "pause", why: why(holds ? "resume" : "pause", phase === "making" ? "This machine cannot pause." : "No wire is being made.") },
    jog: why("jog"),
    resumeRun: why("resume-run"),
    abandon: why("abandon"),
    replay: why("replay"),
    writeSettings: why("write-settings", AT_REST.has(phase) ? "This machine's settings cannot be written from here." : WAIT[phase]),
    disconnect: why("disconnect"),
    next: next(phase, state, noWire === null),
  };
}

function next(phase: Phase, state: MachineState | null, wire: boolean): RunButtons["next"] {
  switch (phase) {
    case "closed":
    case "failed":
      return "connect";
    case "connected":
    case "stopped":
      return state?.can.includes("home") ? "home" : wire ? "arm" : null;
    case "ready":
      return wire ? "arm" : null;
    case "armed":
      return "start";
    case "making":
      return state?.can.includes("pause") ? "pause" : null;
    case "holding":
      return "resume";
    default:
      return null;
  }
}

/** How the machine stands, in a word or two. */
export const PHASES: Readonly<Record<Phase, string>> = {
  connecting: "connecting",
  connected: "not homed",
  homing: "homing",
  ready: "homed",
  moving: "moving",
  armed: "armed",
  making: "making a wire",
  holding: "holding",
  stopping: "stopping",
  stopped: "stopped, not homed",
  failed: "failed",
  closed: "not connected",
};

/** How it stands, and what it does within that; who is asked has to answer first. */
export function doingPhrase({ phase, doing, question }: Pick<MachineState, "phase" | "doing" | "question">): string {
  return question ? "waits for an answer" : (doing ?? PHASES[phase]);
}

/** What the header of the section says. */
export function phrase(state: MachineState | null): string {
  if (!state || state.phase === "closed") return "not connected";
  const who = state.simulated ? "simulated machine" : (state.port ?? state.machine);
  const { wire } = state;
  if (wire && (state.phase === "making" || state.phase === "holding")) return `${PHASES[state.phase]} · ${wire.made} of ${wire.of} made`;
  return `${who} · ${state.phase === "stopped" ? "stopped" : PHASES[state.phase]}`;
}

/** Whether something moves, or may move without being asked again. */
export function isUnderWay(phase: Phase): boolean {
  return ["homing", "moving", "making", "holding", "stopping"].includes(phase);
}
