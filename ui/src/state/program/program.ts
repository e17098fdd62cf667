import { create } from "zustand";
import type { MachineViewResponse, MadeResponse, ProgramResponse, RunFileReport } from "../../generated/responses";
import type { Played, Shown } from "../../scene/interface";
import { tell, told } from "../asking/problems";
import { asking } from "../asking/work";
import { choicesOf, type DesignStore, useDesign } from "../design/design";
import { useMachines, viewOf } from "../machine/machines";
import type { Doubt, WireState } from "../machine/operator";
import { playedWire } from "./played";
import { useRunFile } from "./run_file";

/** What a program is of: another one has to be made when any of this is another. */
interface Basis {
  readonly vertices: DesignStore["vertices"];
  readonly edges: DesignStore["edges"];
  /** Machine, material and how the wires run, as one text. */
  readonly choices: string;
  /** Where the wires pause, as one text. */
  readonly pauses: string;
  /** How often profiles were changed. */
  readonly profiles: number;
  /** The file that is run instead of the design. */
  readonly file: RunFileReport | null;
}

interface ProgramStore {
  /** The program that was asked for last; null before, and where there is none. */
  readonly program: ProgramResponse | null;
  readonly basis: Basis | null;
  readonly asking: boolean;
  /** Why there is none. */
  readonly problem: string | null;
  /** The machine as it was when the program was made. */
  readonly machine: MachineViewResponse | null;
  /** The wire that is shown, from 0, in the order of `program.wires`. */
  readonly wire: number;
  /** How the machine bends it, asked for on demand; of the same basis as the program. */
  readonly made: MadeResponse | null;
  readonly askingMade: boolean;
}

const NONE: ProgramStore = {
  program: null,
  basis: null,
  asking: false,
  problem: null,
  machine: null,
  wire: 0,
  made: null,
  askingMade: false,
};

export const useProgram = create<ProgramStore>()(() => NONE);

/** What the view plays. */
interface PlaybackStore {
  /** Null: the view shows the design. */
  readonly played: Played | null;
  /** Step with its fraction, from 0 to the number of steps. */
  readonly step: number;
  readonly shown: Shown;
  readonly playing: boolean;
  /** The steps are those that a machine runs just now: they are not played. */
  readonly live: boolean;
  /** The name of the design whose wire a machine bends, where that is not the open design as it is: nothing is shown of it. */
  readonly otherWire: string | null;
}

export const usePlayback = create<PlaybackStore>()(() => ({
  played: null,
  step: 0,
  shown: "designed",
  playing: false,
  live: false,
  otherWire: null,
}));

/** What to say of the wire that a machine bends, or is armed for, where that is not one of what is open; null where it is, or where there is none. */
export function useOtherWire(armed: boolean): string | null {
  const name = usePlayback(({ otherWire }) => otherWire);
  const design = useDesign(({ state }) => state?.name ?? "");
  const file = useRunFile((run) => run.file);
  if (name === null) return null;
  const whose = name || "a design without a name";
  const own = file ? file.name.replace(/\.[^.]*$/, "") : design;
  const other = file ? "which is not the file that is open" : "which is not the open design";
  const why = name !== "" && name === own ? "armed before these changes" : other;
  return armed ? `Start bends the wire of ${whose}, ${why}.` : `This is the wire of ${whose}, ${why}. It is not shown.`;
}

function basisNow(): Basis {
  const { vertices, edges, state } = useDesign.getState();
  const choices = choicesOf(state);
  const pausing = JSON.stringify(state?.pauses ?? []);
  const { file } = useRunFile.getState();
  return { vertices, edges, choices, pauses: pausing, profiles: useMachines.getState().changes, file };
}

function same(a: Basis | null, b: Basis): boolean {
  return sameWires(a, b) && (a?.file !== null || a.pauses === b.pauses);
}

/** Whether the wires are bent the same way, wherever they pause. */
function sameWires(a: Basis | null, b: Basis): boolean {
  // A file is run as it is, whatever becomes of the design behind it.
  if (a?.file && a.file === b.file) return true;
  return (
    a !== null &&
    a.file === b.file &&
    a.vertices === b.vertices &&
    a.edges === b.edges &&
    a.choices === b.choices &&
    a.profiles === b.profiles
  );
}

/** Whether the design or its machine has changed since the program was made. Draws anew when that changes. */
export function useStale(): boolean {
  useDesign();
  useMachines((machines) => machines.changes);
  useRunFile();
  const basis = useProgram((program) => program.basis);
  return basis !== null && !same(basis, basisNow());
}

/** Whether the program is that of the design as it is. */
export const isUpToDate = (): boolean => same(useProgram.getState().basis, basisNow());

/** How often the program was forgotten: what was asked before is no answer then. */
let forgotten = 0;
/** The question that is on its way, and whether its answer counts. */
let underway: Promise<boolean> = Promise.resolve(false);

/** Whether there is a wire to play. */
const hasWires = (): boolean => (useProgram.getState().program?.wires.length ?? 0) > 0;

/** Why nothing can be played of what is open as it is: it was asked for and has no program. Null where it has, or before it was asked. */
export function whyNoProgram(): string | null {
  if (!isUpToDate() || hasWires()) return null;
  return useRunFile.getState().file ? "This file has no program to play." : "There is no program: see Check.";
}

/** Brings the program up to date; true when there is one. */
export async function makeProgram(): Promise<boolean> {
  const basis = basisNow();
  const { state } = useDesign.getState();
  // The design itself may not be here yet, such as when a machine is at work while the window is loaded.
  if (!state) return false;
  const machine = basis.file?.machine ?? state.machine;
  if (same(useProgram.getState().basis, basis)) return hasWires();
  // One question is on its way at a time; it was asked of the design as it was then.
  if (useProgram.getState().asking) return (await underway) && makeProgram();
  underway = ask(basis, machine);
  return (await underway) && hasWires();
}

/** Asks for the program, and shows it where it is played; false where it was forgotten meanwhile. */
async function ask(basis: Basis, machine: string | null): Promise<boolean> {
  const before = forgotten;
  useProgram.setState({ asking: true });
  let answer: Partial<ProgramStore>;
  try {
    const [program, view] = await Promise.all([asking("program", {}), machine ? viewOf(machine) : null]);
    const wire = Math.min(useProgram.getState().wire, Math.max(program.wires.length - 1, 0));
    answer = { program, machine: view, basis, wire, made: null, problem: null };
  } catch (error) {
    const problem = error instanceof Error ? error.message : String(error);
    answer = { program: null, machine: null, basis, made: null, problem };
  }
  if (before !== forgotten) return false;
  useProgram.setState({ ...answer, asking: false });
  // How the machine bends it is not known of this one.
  usePlayback.setState({ shown: "designed" });
  const { played, step } = usePlayback.getState();
  if (played) show(step);
  return true;
}

/** Asks how the machine bends it, which may take a while; true when it is known. */
export async function simulate(): Promise<boolean> {
  if (!(await makeProgram())) return false;
  const { basis, made } = useProgram.getState();
  if (made) return true;
  if (simulating?.basis !== basis) simulating = { basis, known: askMade(basis) };
  return simulating.known;
}

/** The simulation that is on its way, and of what. */
let simulating: { readonly basis: Basis | null; readonly known: Promise<boolean> } | null = null;

async function askMade(basis: Basis | null): Promise<boolean> {
  useProgram.setState({ askingMade: true });
  const answer = await told(asking("made", {}));
  const isLast = simulating?.basis === basis;
  if (isLast) {
    simulating = null;
    useProgram.setState({ askingMade: false });
  }
  // What was asked of another design is no answer for this one.
  if (!answer || !isLast || useProgram.getState().basis !== basis) return false;
  useProgram.setState({ made: answer });
  const { played, step } = usePlayback.getState();
  if (played) show(step);
  return true;
}

/** Forgets the program, such as that of a design that was closed. */
export function forgetProgram(): void {
  forgotten += 1;
  useProgram.setState({ ...NONE });
  showDesignAgain();
}

export function chooseWire(wire: number): void {
  useProgram.setState({ wire });
  if (usePlayback.getState().played) show(0);
}

/** What is played consists of: while all of this is the same the view keeps its machine, also while a person slides. */
let playedOf: readonly unknown[] = [];

/** Shows the wire in the view, at a position. Without a program nothing is shown. */
export function show(step: number): void {
  const { program, machine, made, wire } = useProgram.getState();
  const before = usePlayback.getState();
  const of = [program, machine, made, wire];
  const kept = before.played && of.every((one, index) => one === playedOf[index]) ? before.played : null;
  const played = kept ?? (program ? playedWire(program, wire, machine, made) : null);
  if (!played) {
    showDesignAgain();
    return;
  }
  playedOf = of;
  const shown = made ? before.shown : "designed";
  usePlayback.setState({ played, shown, step: Math.min(Math.max(step, 0), played.steps.length) });
}

/** The view shows the design again. */
export function showDesignAgain(): void {
  usePlayback.setState({ played: null, step: 0, playing: false, live: false });
}

/** What a person chose to see last: it may not be known yet. */
let wanted: Shown = "designed";

export async function chooseShown(shown: Shown): Promise<void> {
  wanted = shown;
  if (shown !== "designed" && !(await simulate())) return;
  if (wanted !== shown) return;
  usePlayback.setState({ shown });
  if (!usePlayback.getState().played) show(0);
}

/** Makes the program for a person who plays it: false also where a running machine has the view, by then or before. */
async function makeToPlay(): Promise<boolean> {
  const isLive = () => usePlayback.getState().live;
  while (!isLive() && (await makeProgram())) {
    // Of a design that was changed meanwhile it is made once more.
    if (isUpToDate()) return !isLive();
  }
  return false;
}

/** Something that the person does with the program: a job in the view of a running machine is left alone. */
export async function goTo(step: number): Promise<void> {
  if (!(await makeToPlay())) return;
  usePlayback.setState({ playing: false });
  show(step);
}

async function play(): Promise<void> {
  if (!(await makeToPlay())) {
    const why = whyNoProgram();
    // Only now it is known: a press that did nothing at all would be pressed again.
    if (why) tell("info", why, "no-program");
    return;
  }
  const { played, step } = usePlayback.getState();
  if (!played) show(0);
  else if (step >= played.steps.length) show(0);
  usePlayback.setState({ playing: usePlayback.getState().played !== null });
}

export function pause(): void {
  usePlayback.setState({ playing: false });
}

/** What the key for it does. */
export function togglePlay(): void {
  if (usePlayback.getState().playing) pause();
  else void play();
}

/** The wire that the view follows, where it is as the machine said last, and whether it was bent to its end since. */
let followed: { readonly job_hash: string; readonly wire: number; step: number | null; made: boolean } | null = null;

/** Changes when a wire is over: what was asked because of it comes too late then. */
let over = 0;

/** Shows how far a machine is with a wire, where it is one of the open design as it is. */
export async function showLive({
  job_hash,
  name,
  wire,
  made,
  in_step,
}: Pick<WireState, "job_hash" | "name" | "wire" | "made" | "in_step">): Promise<void> {
  const isShown = () => useProgram.getState().program?.job_hash === job_hash;
  if (followed?.job_hash !== job_hash || followed.wire !== wire || followed.made) {
    followed = { job_hash, wire, step: null, made: false };
  }
  const follows = followed;
  // A program that was made meanwhile is that of a design that was changed.
  if (!usePlayback.getState().live || !isShown()) {
    const before = over;
    // What somebody else asks for is waited for by the next report: by then it may be of another design.
    if (!isUpToDate() && (useProgram.getState().asking || !(await makeProgram())) && !isUpToDate()) return;
    if (before !== over) {
      // It was bent before its program was there.
      if (follows.made && isShown()) showEnd(wire);
      return;
    }
    if (!isShown()) {
      if (usePlayback.getState().live) showDesignAgain();
      return usePlayback.setState({ otherWire: name });
    }
    usePlayback.setState({ playing: false, otherWire: null });
    useProgram.setState({ wire });
    show(made);
  }
  const steps = useProgram.getState().program?.wires[wire]?.steps ?? [];
  follows.step = Math.min(made + in_step, steps.length);
  usePlayback.setState({ live: true, step: follows.step });
}

function showEnd(wire: number): void {
  useProgram.setState({ wire });
  show(useProgram.getState().program?.wires[wire]?.steps.length ?? 0);
}

/** Shows a wire as far as it is bent, with what the machine has counted of the step in doubt. */
export async function showDoubt(
  wire: Pick<WireState, "job_hash" | "name" | "wire">,
  { step, in_step }: Doubt,
): Promise<void> {
  await showLive({ ...wire, made: step - 1, in_step });
}

/** Finds whether the wire that a machine is armed for is one of the open design as it is. Nothing is shown of it before it is begun. */
export async function lookAtArmed({ job_hash, name }: Pick<WireState, "job_hash" | "name">): Promise<void> {
  // What was asked of a wire before, armed or bent, is no answer for this one.
  over += 1;
  const before = over;
  if (usePlayback.getState().live) usePlayback.setState({ live: false });
  if (!isUpToDate() && !(await makeProgram()) && !isUpToDate()) return;
  if (before === over) usePlayback.setState({ otherWire: isOfDesign(job_hash) ? null : name });
}

/** Whether a job is that of what is open, as it is. */
export const isOfDesign = (job_hash: string): boolean =>
  isUpToDate() && useProgram.getState().program?.job_hash === job_hash;

/** The machine is done with the wire: the person may play it. */
export function endLive(): void {
  over += 1;
  const { live, otherWire } = usePlayback.getState();
  if (live || otherWire !== null) usePlayback.setState({ live: false, otherWire: null });
}

/** A wire was made to its end: what follows it goes there, too. The machine's last word of its place is of a moment before. */
export function showMade(): void {
  if (!followed) return;
  followed.made = true;
  const { played, playing, step } = usePlayback.getState();
  // A person who looks at another step goes on looking.
  if (played && !playing && step === followed.step) showEnd(followed.wire);
}

/** The view goes back to the design as soon as that is another one: a person wants to see what they change. */
export function leaveStaleProgram(): void {
  const { played, live } = usePlayback.getState();
  const { asking, basis } = useProgram.getState();
  if (played && !live && !asking && !sameWires(basis, basisNow())) showDesignAgain();
}
