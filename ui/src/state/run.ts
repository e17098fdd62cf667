import { create } from "zustand";
import type { MachineNow, PortEntry, RunEntry } from "../generated/responses";
import { platform } from "../platform";
import { type ConsoleLine, withLines } from "./console";
import { checkDesign, useDesign } from "./design";
import { useFiles } from "./files";
import { tell, told } from "./problems";
import { endLive, showDoubt, showLive } from "./program";
import { type Answer, type MachineState, type Move, operatorEvent, type OperatorEvent, type Order, type Question, type WireRun } from "./operator";
import { useUi } from "./ui";
import { worded } from "./wording";
import { asking, hear } from "./work";

interface RunStore {
  /** How the machine stands; null as long as none was connected. */
  readonly state: MachineState | null;
  readonly question: Question | null;
  readonly console: readonly ConsoleLine[];
  /** Moves that were made by hand and are kept. */
  readonly recorded: readonly Move[];
  /** What became of the wire that was made last. */
  readonly ended: WireRun | null;
  /** What was made before, the last first; null before that is known. */
  readonly runs: readonly RunEntry[] | null;
  /** Null before they are known. */
  readonly ports: readonly PortEntry[] | null;
  readonly portProblem: string | null;
  /** An order is on its way. */
  readonly ordering: boolean;
}

export const useRun = create<RunStore>()(() => ({
  state: null,
  question: null,
  console: [],
  recorded: [],
  ended: null,
  runs: null,
  ports: null,
  portProblem: null,
  ordering: false,
}));

/** Whether there is a session, so that there may be something to stop. */
export const isOpen = (state: MachineState | null): boolean => state !== null && state.phase !== "closed";

/** How many states were told: an answer that one has overtaken is older than what is known. */
let heard = 0;

/** Takes up the state of an answer, unless a newer one was told while it was on its way. */
function standAsAnswered(state: MachineState | null, before: number): void {
  if (heard === before) stand(state);
}

function stand(state: MachineState | null): void {
  useRun.setState(({ question }) => ({ state, question: state?.question === undefined ? question : state.question }));
  if (state && isMade(state)) showWire();
  else if (state?.wire && state.question?.doubt) void showDoubt(state.wire, state.question.doubt);
  else endLive();
}

const isMade = ({ phase }: MachineState): boolean => phase === "making" || phase === "holding";

/** Shows the wire that is being made, as far as it is one of the open design. */
function showWire(): void {
  const { state } = useRun.getState();
  if (state?.wire && isMade(state)) void showLive(state.wire, state.position);
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

/** Hears what the operator tells. */
export function hearOperator(event: OperatorEvent): void {
  switch (event.event) {
    case "state": {
      const { event: _, ...state } = event;
      heard += 1;
      return stand(state);
    }
    case "question": {
      const { event: _, ...question } = event;
      return useRun.setState({ question });
    }
    case "answered":
      return useRun.setState(({ question }) => ({ question: question?.id === event.id ? null : question }));
    case "jogged":
      return void loadRecorded();
    case "run-ended":
      // Of a wire that was made its notes were told on the way.
      if (event.wires.length === 0) for (const note of event.notes) tell("warning", worded(note), note.code);
      return useRun.setState({ ended: event.wires.at(-1) ?? null });
    case "stopped":
      // Whether the machine stands is told with the state, once it is known.
      if (event.driver_ended) tell("warning", "The driver did not pass STOP on and was ended. Connect the machine again.", "driver-ended");
      return;
    case "problem":
      // The section shows it beside the buttons that it is about.
      return useUi.getState().open.includes("run") ? undefined : tell("error", worded(event), event.code);
    case "news":
      return hearNews(event);
  }
}

function hearNews(news: Extract<OperatorEvent, { event: "news" }>): void {
  const { state } = useRun.getState();
  switch (news.news) {
    case "console":
      return collect({ toMachine: news.to_machine, text: news.text });
    case "warning":
      return tell("warning", worded(news), news.code);
    case "wire": {
      const { event: _, news: __, ...wire } = news;
      // Which job it is of was told with the state.
      return state?.wire ? stand({ ...state, wire: { ...state.wire, ...wire } }) : undefined;
    }
    case "position": {
      const { feed_mm, rotate_deg, bend_deg } = news;
      if (state) useRun.setState({ state: { ...state, position: { feed_mm, rotate_deg, bend_deg } } });
      return showWire();
    }
    case "about":
    case "paused":
    case "resumed":
      // They come with the question, and with the state.
      return;
  }
}

hear((heard) => {
  const event = operatorEvent(heard);
  if (event) hearOperator(event);
});

// Whose wire it is, is another question with each design, and a machine that holds tells nothing by itself.
useFiles.subscribe(({ opened }, before) => {
  // The design is there after this turn.
  if (opened !== before.opened) queueMicrotask(showWire);
});
useDesign.subscribe(({ state }, before) => {
  if (state && !before.state) showWire();
});

/** What a machine that is connected says of itself; null where none is. */
function saidOf(state: MachineState | null): string | null {
  if (!state || ["connecting", "failed", "closed"].includes(state.phase)) return null;
  return JSON.stringify([state.machine, state.port, state.settings]);
}

// What a connected machine takes is part of what is checked.
useRun.subscribe(({ state }, before) => {
  if (state !== before.state && saidOf(state) !== saidOf(before.state)) checkDesign();
});

/** Takes up what the Rust side knows, such as after the window was loaded anew. */
export async function takeUp(): Promise<void> {
  const before = heard;
  try {
    standAsAnswered((await platform.ask("machine-state", {})).state, before);
  } catch {
    // Nothing is connected that could be taken up; connecting says why it cannot be.
  }
}

let portsAsked = 0;

/** Asks for the ports that the machine of the design can be at. Of several questions only the last one's answer counts. */
export async function loadPorts(): Promise<void> {
  const machine = useDesign.getState().state?.machine ?? null;
  portsAsked += 1;
  const question = portsAsked;
  let found: Pick<RunStore, "ports" | "portProblem">;
  try {
    const { ports, problems } = await asking("ports", { machine });
    found = { ports, portProblem: problems.length > 0 ? problems.join(" ") : null };
  } catch (error) {
    found = { ports: [], portProblem: error instanceof Error ? error.message : String(error) };
  }
  if (question === portsAsked) useRun.setState(found);
}

/** Asks for the records of what was made. */
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

/** `port` null: the simulated machine. */
export function connect(port: string | null): Promise<boolean> {
  useRun.setState({ ended: null, recorded: [] });
  return ordered(asking("connect", { port }));
}

export function order(what: Order): Promise<boolean> {
  if (what.order === "start" || what.order === "resume-run") useRun.setState({ ended: null });
  return ordered(asking("order", { request: what }));
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

/** Stops the machine. Waits for nothing else. */
export function stop(): void {
  void told(platform.stop());
}

// What became of the last wire is said of the design that it is of.
useFiles.subscribe(({ opened }, before) => {
  if (opened !== before.opened) useRun.setState({ ended: null });
});
