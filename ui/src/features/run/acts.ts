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

/** The button for a remedy; null where a person has to do it, beside the machine or elsewhere. */
function actOf({ remedy }: ErrorRemedy, state: MachineState, all: RunButtons): Act | null {
  const { unfinished } = state;
  switch (remedy) {
    case "home":
      return {
        label: "Home",
        consequence: "The axes move at once, until their place is known.",
        why: all.home,
        run: () => void order({ order: "home" }),
      };
    case "connect":
    case "connect-again":
    case "check-power-and-port":
      return {
        label: "Connect again",
        consequence: "This connection is let go of, and another one made. Nothing moves.",
        why: null,
        run: () => void connect(state.port),
      };
    case "start-or-disarm":
      return {
        label: "Disarm",
        consequence: "The wire is not bent. Nothing moves.",
        why: all.disarm,
        run: () => void order({ order: "disarm" }),
      };
    case "stop":
    case "continue-or-stop":
    case "pause-or-stop":
      return {
        label: "STOP",
        consequence: "Everything stops at once. Home before it moves again.",
        why: null,
        run: stop,
      };
    case "write-settings":
      return {
        label: "Write the settings",
        consequence: "The machine is set as its profile says. You are asked before.",
        why: all.writeSettings,
        run: () => void order({ order: "write-settings" }),
      };
    case "resume-run":
    case "resume-without-answer":
      if (!unfinished?.resumable) return null;
      return {
        label: "Resume…",
        consequence: "The wire continues after its last step. You are asked before anything moves.",
        why: all.resumeRun,
        run: () => {
          const { job_hash, wire } = unfinished;
          void order({ order: "resume-run", job_hash, wire, accept_settings: false });
        },
      };
    case "list-drivers":
    case "trust-driver":
    case "update-driver":
    case "change-driver-setting":
      return show("Show the drivers", "machine", "Opens Machine, where drivers are listed and accepted.");
    case "fix-findings":
      return show("Show the problems", "check", "Opens Check, with what can be done about each.");
    default:
      return null;
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
    const act = actOf(remedy, state, all);
    if (act) acts.set(act.label, act);
    else others.push(remedy);
  }
  return { acts: [...acts.values()], others };
}
