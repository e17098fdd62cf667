/** Remedies that the window can carry out: a button each, with what follows from it. */

import type { ErrorRemedy } from "../../generated/responses";
import type { MachineState } from "../../state/machine/operator";
import { setCut } from "../../state/machine/row";
import { connect, order, stop } from "../../state/machine/run";
import { useRunFile } from "../../state/program/run_file";
import { run, whyNot } from "../../state/window/commands";
import { useUi } from "../../state/window/ui";
import type { Arming } from "./arming";
import type { RunButtons } from "./buttons";

interface Act {
  readonly label: string;
  /** What follows from it, as a sentence. */
  readonly consequence: string;
  /** Why it cannot be done now. */
  readonly why: string | null;
  readonly run: () => void;
}

const show = (label: string, section: "machine" | "check" | "export", consequence: string): Act => ({
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

/** What is armed where a person is to arm it again. */
export type ToArm = Pick<Arming, "why" | "arm">;

const armAgain = ({ why, arm }: ToArm): Act => ({
  label: "Arm…",
  consequence: "The wire is checked, and you are asked. Nothing moves before Start.",
  why,
  run: arm,
});

/** Giving up the wire that was interrupted; none where there is none. */
function giveUp({ unfinished }: MachineState, { abandon }: RunButtons): readonly Act[] {
  if (!unfinished) return [];
  const { job_hash, wire } = unfinished;
  return [
    {
      label: "Give the wire up",
      consequence: "Giving it up moves nothing. The wire cannot be resumed any more: cut it off and take it out.",
      why: abandon,
      run: () => void order({ order: "abandon", job_hash, wire }),
    },
  ];
}

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
  "arm-or-jog",
  "restrict-access",
]);

/** The buttons for a remedy, one for each choice; none where a person has to do it. */
function actsFor(remedy: ErrorRemedy, state: MachineState, all: RunButtons, toArm: ToArm): readonly Act[] {
  const { unfinished } = state;
  const { file } = useRunFile.getState();
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
          consequence: "Closes this connection and makes another one. Connecting moves nothing.",
          why: null,
          run: () => void connect(state.port, state.simulated_as),
        },
      ];
    case "connect-at":
      return [
        {
          label: `Connect ${remedy.port}`,
          consequence: "Closes this connection and connects the machine at that port. Connecting moves nothing.",
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
          consequence: "The wire is not bent. Disarming moves nothing.",
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
    case "abandon-run":
    case "begin-anew":
      return giveUp(state, all);
    case "arm-again":
    case "arm-or-jog":
      return [armAgain(toArm)];
    case "plan-again":
      // A design is planned anew whenever it is armed.
      return file ? [] : [armAgain(toArm)];
    case "cut-by-hand":
      return [
        {
          label: "Cut by hand",
          consequence: "“Cut each piece off” is turned off: you are asked before each piece.",
          why: null,
          run: () => setCut(false),
        },
      ];
    case "replay-here":
      if (file?.kind !== "moves") return [];
      return [
        {
          label: "Replay anyway…",
          consequence: "You are asked before anything moves. Check that the machine has room for the moves.",
          why: all.replay,
          run: () => void order({ order: "replay", file: file.path, other_machine: true }),
        },
      ];
    case "open-design":
      return [
        {
          label: "Open a file…",
          consequence: "The design that the wire was planned from is opened in place of this one.",
          why: whyNot("open"),
          run: () => void run("open"),
        },
      ];
    case "export-file":
      return [show("Show Export", "export", "Opens Export, with the formats that the machine reads.")];
    case "restrict-access":
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
  toArm: ToArm,
): { readonly acts: readonly Act[]; readonly others: readonly ErrorRemedy[] } {
  const acts = new Map<string, Act>();
  const others: ErrorRemedy[] = [];
  for (const remedy of remedies) {
    const found = actsFor(remedy, state, all, toArm);
    for (const act of found) acts.set(act.label, act);
    if (found.length === 0 || SAID_TOO.has(remedy.remedy)) others.push(remedy);
  }
  return { acts: [...acts.values()], others };
}
