import { create } from "zustand";
import type { SimulatedAs } from "../../generated/requests";
import type { MachineNow, PortEntry, RunEntry } from "../../generated/responses";
import { platform } from "../../platform";
import { errorText } from "../../platform/error_text";
import { dismissAll, tell, told } from "../asking/problems";
import { asking } from "../asking/work";
import { ofDesign, useDesign } from "../design/design";
import { endLive, isOfDesign, lookAtArmed, showDoubt, showLive, showMade } from "../program/program";
import { useRunFile } from "../program/run_file";
import { useUi } from "../window/ui";
import { type ConsoleLine, withLines, withTyped } from "./console";
import {
  type Answer,
  isInWire,
  type MachineState,
  type Move,
  type OperatorEvent,
  type Order,
  type Phase,
  type Question,
  type WireRun,
} from "./operator";
import { forgetRow, hearRow, setAccepted, useRow } from "./row";

/** Which wire it is whose end is told. */
export interface EndedAs {
  /** The name of its design, where that is not what is open, as it is. */
  readonly of: string | null;
  /** It is one of several. */
  readonly several: boolean;
}

interface RunStore {
  /** How the machine stands; null as long as none was connected. */
  readonly state: MachineState | null;
  /** The order to bend wires goes on, but none is in the machine just now: one is cut off, or the next one is prepared. */
  readonly between: boolean;
  readonly question: Question | null;
  readonly console: readonly ConsoleLine[];
  /** Lines that were typed for a machine, the last at the end. */
  readonly typed: readonly string[];
  /** The line that the machine's driver has refused, to be corrected. */
  readonly refusedLine: string | null;
  /** Moves by hand that are kept. */
  readonly recorded: readonly Move[];
  /** What became of the wire that was bent last. */
  readonly ended: WireRun | null;
  readonly endedAs: EndedAs;
  /** What was bent before, the last first; null before that is known. */
  readonly runs: readonly RunEntry[] | null;
  /** Null before they are known. */
  readonly ports: readonly PortEntry[] | null;
  readonly portProblem: string | null;
  /** The port that a person has chosen, by machine: it stays chosen when the connection is closed. */
  readonly chosenPorts: ReadonlyMap<string, string>;
  /** An order is on its way. */
  readonly ordering: boolean;
}

export const useRun = create<RunStore>()(() => ({
  state: null,
  between: false,
  question: null,
  console: [],
  typed: [],
  refusedLine: null,
  recorded: [],
  ended: null,
  endedAs: { of: null, several: false },
  runs: null,
  ports: null,
  portProblem: null,
  chosenPorts: new Map(),
  ordering: false,
}));

export function choosePort(machine: string, port: string): void {
  useRun.setState(({ chosenPorts }) => ({ chosenPorts: new Map(chosenPorts).set(machine, port) }));
}

/** Whether there is a session, so that there may be something to stop. */
export const isOpen = (state: MachineState | null): boolean => state !== null && state.phase !== "closed";

/** Whether wires are being bent, until the last one of a row is. */
export const isBending = ({ state, between }: RunStore): boolean =>
  state !== null && (isInWire(state.phase) || between);

/** How a machine stands on which nothing goes on by itself. */
const OVER: ReadonlySet<Phase> = new Set(["stopping", "stopped", "failed", "closed"]);

/** How many states were reported: an answer that one has overtaken is older than what is known. */
let heard = 0;

function endedAs(
  { job_hash, wires }: Extract<OperatorEvent, { event: "run-ended" }>,
  state: MachineState | null,
): EndedAs {
  const wire = state?.wire?.job_hash === job_hash ? state.wire : null;
  return {
    of: wire && !isOfDesign(job_hash) ? wire.name : null,
    several: useRow.getState().rest.length > 0 || (wires.at(-1)?.wire ?? 0) > 0,
  };
}

/** Takes the state of an answer, unless a newer one was reported while it was on its way. */
function standAsAnswered(state: MachineState | null, before: number): void {
  if (heard === before) stand(state);
}

function stand(state: MachineState | null): void {
  useRun.setState((before) => ({
    state,
    between: state?.busy === true && !isInWire(state.phase) && !OVER.has(state.phase) && isBending(before),
    question: state?.question === undefined ? before.question : state.question,
  }));
  if (state?.wire && (isInWire(state.phase) || state.phase === "armed")) showWire();
  else if (state?.wire && state.question?.doubt) void showDoubt(state.wire, state.question.doubt);
  else endLive();
}

/** Shows the wire that is being bent, as far as it is one of the open design; finds whether one that is armed is. */
export function showWire(): void {
  const { state } = useRun.getState();
  if (!state?.wire) return;
  if (isInWire(state.phase)) void showLive(state.wire);
  else if (state.phase === "armed") void lookAtArmed(state.wire);
}

/** Lines come faster than they can be drawn: they are collected for a moment. */
let collected: Omit<ConsoleLine, "id">[] = [];
const COLLECT_MS = 60;

function collect(line: Omit<ConsoleLine, "id">): void {
  collected.push(line);
  if (collected.length > 1) return;
  window.setTimeout(() => {
    const lines = collected;
    collected = [];
    useRun.setState((run) => ({ console: withLines(run.console, lines) }));
  }, COLLECT_MS);
}

export function clearConsole(): void {
  useRun.setState({ console: [] });
}

/** The codes of messages that stay until the machine is connected again. */
const lasting = new Set<string>();

function tellLasting(severity: "error" | "warning", message: string, code: string): void {
  lasting.add(code);
  tell(severity, message, code, true);
}

/** Hears what the operator reports. */
export function hearOperator(event: OperatorEvent): void {
  switch (event.event) {
    case "state": {
      const { event: _, ...state } = event;
      heard += 1;
      stand(state);
      break;
    }
    case "question": {
      const { event: _, ...question } = event;
      useRun.setState({ question });
      break;
    }
    case "answered":
      useRun.setState(({ question }) => ({ question: question?.id === event.id ? null : question }));
      break;
    case "jogged":
      void loadRecorded();
      break;
    case "run-ended":
      // The notes of a wire that was bent were shown on the way.
      if (event.wires.length === 0) for (const note of event.notes) tell("warning", errorText(note), note.code);
      hearRow(event);
      useRun.setState(({ state }) => ({ ended: event.wires.at(-1) ?? null, endedAs: endedAs(event, state) }));
      if (event.wires.at(-1)?.outcome === "made") showMade();
      break;
    case "stopped":
      // Among the lines, when it was pressed: what the machine is sent for it is no line, and comes by the driver or by the program itself.
      collect({ toMachine: SENT.has(event.by) ? true : null, at: Date.now() - event.took_ms, text: STOPPED[event.by] });
      // Whether the machine stands is reported with the state, once it is known.
      if (event.driver_ended)
        tellLasting(
          "warning",
          "The driver did not pass STOP on and was ended. Connect the machine again.",
          "driver-ended",
        );
      break;
    case "problem":
      if (sent !== null) {
        collect({
          toMachine: null,
          at: Date.now(),
          text: `Not sent: ${sent}. ${errorText(event)}`,
        });
        useRun.setState({ refusedLine: sent });
        sent = null;
      }
      // The section shows it beside the buttons that it is about.
      if (!useUi.getState().open.includes("run")) tellLasting("error", errorText(event), event.code);
      break;
    case "news":
      hearProgress(event);
      break;
  }
}

/** What the console says of a stop, by what has sent it. */
const STOPPED: Readonly<Record<Extract<OperatorEvent, { event: "stopped" }>["by"], string>> = {
  driver: "STOP pressed: the driver has sent it",
  "nothing-more": "STOP pressed: nothing more is sent, but this machine cannot be stopped",
  "end-of-driver": "STOP pressed: the driver was ended",
  "end-of-simulation": "STOP pressed: the simulated machine was ended",
  host: "STOP pressed: sent past the driver",
};

/** The stops for which the machine is sent something. */
const SENT: ReadonlySet<keyof typeof STOPPED> = new Set(["driver", "host"]);

function hearProgress(news: Extract<OperatorEvent, { event: "news" }>): void {
  const { state } = useRun.getState();
  switch (news.news) {
    case "console":
      sent = null;
      collect({ toMachine: news.to_machine, at: Date.now(), text: news.text });
      break;
    case "warning":
      tell("warning", errorText(news), news.code);
      break;
    case "wire": {
      const { event: _, news: __, ...wire } = news;
      // Which job it is of was reported with the state.
      if (state?.wire) stand({ ...state, wire: { ...state.wire, ...wire } });
      break;
    }
    case "position": {
      const { feed_mm, rotate_deg, bend_deg } = news;
      if (state) useRun.setState({ state: { ...state, position: { feed_mm, rotate_deg, bend_deg } } });
      break;
    }
    case "about":
    case "paused":
    case "resumed":
      // They come with the question, and with the state.
      break;
  }
}

/** What a machine that is connected says of itself; null where none is. */
export function saidOf(state: MachineState | null): string | null {
  if (!state || ["connecting", "failed", "closed"].includes(state.phase)) return null;
  return JSON.stringify([state.machine, state.port, state.settings]);
}

/** Takes what the Rust side knows, such as after the window was loaded anew. */
export async function reattach(): Promise<void> {
  const before = heard;
  try {
    standAsAnswered((await platform.ask("machine-state", {})).state, before);
  } catch {
    // Nothing is connected whose state could be taken; connecting says why it cannot be.
  }
}

let portsAsked = 0;

/** Asks for the ports that the machine of the design can be at. Of several questions only the last one's answer counts. */
export async function loadPorts(): Promise<void> {
  const machine = useRunFile.getState().file?.machine ?? useDesign.getState().state?.machine ?? null;
  portsAsked += 1;
  const question = portsAsked;
  let found: Pick<RunStore, "ports" | "portProblem">;
  try {
    const { ports, problems, remedies } = await asking("ports", { machine });
    found = { ports, portProblem: problems.length > 0 ? errorText({ message: problems.join(". "), remedies }) : null };
  } catch (error) {
    found = { ports: [], portProblem: error instanceof Error ? error.message : String(error) };
  }
  if (question === portsAsked) useRun.setState(found);
}

/** Asks for the records of what was bent. */
export async function loadRuns(): Promise<void> {
  const all = await told(asking("runs", {}));
  if (all) useRun.setState({ runs: all.runs.toReversed() });
}

async function ordered(asked: Promise<MachineNow>): Promise<boolean> {
  const before = heard;
  useRun.setState({ ordering: true });
  const now = await told(asked);
  useRun.setState({ ordering: false });
  if (now) standAsAnswered(now.state, before);
  return now !== null;
}

/** `port` null: the simulated machine. `simulatedAs`: what that one has instead of what its profile says. */
export function connect(port: string | null, simulatedAs: SimulatedAs = {}): Promise<boolean> {
  useRun.setState({ ended: null, recorded: [] });
  setAccepted(null);
  const before = [...lasting];
  return ordered(asking("connect", { port, simulated_as: { ...simulatedAs } })).then((connected) => {
    // What was wrong with the connection before is over once there is another.
    for (const code of connected ? before : []) {
      dismissAll(code);
      lasting.delete(code);
    }
    return connected;
  });
}

export function order(what: Order): Promise<boolean> {
  if (what.order === "start" || what.order === "resume-run") useRun.setState({ ended: null });
  const asked = asking("order", { request: what });
  return ordered(useRunFile.getState().file ? asked : ofDesign(asked));
}

/** The line that was typed last, until something of it is heard. */
let sent: string | null = null;

/** Sends a line that was typed; whether it was taken. A driver may refuse it afterwards. */
export async function sendLine(line: string): Promise<boolean> {
  useRun.setState(({ typed }) => ({ typed: withTyped(typed, line), refusedLine: null }));
  sent = line;
  return order({ order: "console", line });
}

export function answer(question: number, what: Answer): Promise<boolean> {
  return ordered(platform.ask("answer", { question, answer: what }));
}

/** Which moves are kept is for the operator to say. */
async function loadRecorded(): Promise<void> {
  const recorded = await told(platform.ask("recorded", {}));
  if (recorded) useRun.setState({ recorded: recorded.moves });
}

export async function clearRecording(): Promise<void> {
  const left = await told(platform.ask("clear-recording", {}));
  if (left) useRun.setState({ recorded: left.moves });
}

/** Writes the recorded moves; null where that came to nothing. */
export async function saveRecording(path: string): Promise<string | null> {
  // The dialog has asked whether a file that is there may be replaced.
  const saved = await told(platform.ask("save-recording", { output: { path, force: true } }));
  return saved?.file ?? null;
}

/** The button that pauses and resumes. */
export const PAUSE_BUTTON = "pause-machine";

/** Pauses the wire that is bent, by a key from wherever it is pressed. It resumes by the button, which then has the focus. */
export function pauseByKey(): void {
  useUi.getState().showSection("run");
  if (useRun.getState().state?.phase === "making") void order({ order: "pause" });
  window.setTimeout(() => document.getElementById(PAUSE_BUTTON)?.focus(), 0);
}

/** Stops the machine. Waits for nothing else. */
export function stop(): void {
  void told(platform.stop());
}

/** What became of the last wire is said of the design that it is of. */
export function forgetEnded(): void {
  useRun.setState({ ended: null });
  forgetRow();
}
