/** Remedies that the window can carry out: a button each, with what follows from it. */

import type { ErrorRemedy } from "../../generated/responses";
import type { MachineState } from "../../state/machine/operator";
import { connect, order, stop } from "../../state/machine/run";
import { useUi } from "../../state/window/ui";
import type { RunButtons } from "./buttons";

interface Act {
  readonly label: string;
  /** What follows from it, as a sentence. */
  readonly consequence: string;
  /** Why it cannot be done now. */
  readonly why: string | null;
  readonly run: () => void;
}

const show = (label: string, section: "machine" | "check", consequence: string): Act => ({
  label,
  consequence,
  why: null,
  run: () => useUi.getState().showSection(section),
});

/** Pausing, or resuming after a pause: whichever the machine takes now. */
const pauseOrResume = ({ pause }: RunButtons): Act => ({
  label: pause.order === "pause" ? "Pause" : "Resume",
  consequence: pause.order === "pause" ? "The machine holds, and can be resumed." : "The wire continues at once.",
  why: pause.why,
  run: () => void order({ order: pause.order }),
});

const STOP: Act = {
  label: "STOP",
  consequence: "Everything stops at once. Home before it moves again.",
  why: null,
  run: stop,
};

/** Of these a button is only a part: what a person does themselves, beside the machine or elsewhere, is said as well. */
const SAID_TOO: ReadonlySet<ErrorRemedy["remedy"]> = new Set([
  "check-power-and-port",
  "trust-driver",
  "update-driver",
  "change-driver-setting",
]);

/** The buttons for a remedy, one for each choice; none where a person has to do it. */
function actsFor(remedy: ErrorRemedy, state: MachineState, all: RunButtons): readonly Act[] {
  const { unfinished } = state;
  switch (remedy.remedy) {
    case "home":
      return [
        {
          label: "Home",
          consequence: "The axes move at once, until their place is known.",
          why: all.home,
          run: () => void order({ order: "home" }),
        },
      ];
    case "connect":
    case "connect-again":
    case "check-power-and-port":
      return [
        {
          label: "Connect again",
          consequence: "This connection is closed, and another one made. Nothing moves.",
          why: null,
          run: () => void connect(state.port, state.simulated_as),
        },
      ];
    case "connect-at":
      return [
        {
          label: `Connect ${remedy.port}`,
          consequence: "This connection is closed, and one to the machine at that port made. Nothing moves.",
          why: null,
          run: () => void connect(remedy.port, state.simulated_as),
        },
      ];
    case "start-or-disarm":
      return [
        {
          label: "Start",
          consequence: "The armed wire is bent. The machine moves at once.",
          why: all.start,
          run: () => void order({ order: "start" }),
        },
        {
          label: "Disarm",
          consequence: "The wire is not bent. Nothing moves.",
          why: all.disarm,
          run: () => void order({ order: "disarm" }),
        },
      ];
    case "stop":
      return [STOP];
    case "continue-or-stop":
    case "pause-or-stop":
      return [pauseOrResume(all), STOP];
    case "write-settings":
      return [
        {
          label: "Write the settings",
          consequence: "The machine is set as its profile says. You are asked before.",
          why: all.writeSettings,
          run: () => void order({ order: "write-settings" }),
        },
      ];
    case "resume-run":
    case "resume-without-answer":
      if (!unfinished?.resumable) return [];
      return [
        {
          label: "Resume…",
          consequence: "The wire continues after its last step. You are asked before anything moves.",
          why: all.resumeRun,
          run: () => {
            const { job_hash, wire } = unfinished;
            void order({ order: "resume-run", job_hash, wire, accept_settings: false });
          },
        },
      ];
    case "list-drivers":
    case "trust-driver":
    case "update-driver":
    case "change-driver-setting":
      return [show("Show the drivers", "machine", "Opens Machine, where drivers are listed and accepted.")];
    case "fix-findings":
      return [show("Show the problems", "check", "Opens Check, with what can be done about each.")];
    default:
      return [];
  }
}

/** The buttons for a problem, each once, and the remedies that are left to say. */
export function actsOf(
  remedies: readonly ErrorRemedy[],
  state: MachineState,
  all: RunButtons,
): { readonly acts: readonly Act[]; readonly others: readonly ErrorRemedy[] } {
  const acts = new Map<string, Act>();
  const others: ErrorRemedy[] = [];
  for (const remedy of remedies) {
    const found = actsFor(remedy, state, all);
    for (const act of found) acts.set(act.label, act);
    if (found.length === 0 || SAID_TOO.has(remedy.remedy)) others.push(remedy);
  }
  return { acts: [...acts.values()], others };
}
