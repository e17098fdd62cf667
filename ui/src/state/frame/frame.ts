/** The open design as a frame: what was chosen, and what was computed of it. */

import { create } from "zustand";
import type { ClosingName, FrameSupports, VaryName } from "../../generated/requests";
import type { FrameChoices, FrameShown, ToleranceResponse } from "../../generated/responses";
import { platform } from "../../platform";
import type { Vec3 } from "../../scene/interface";
import { told } from "../asking/problems";
import { asking } from "../asking/work";
import { useDesign } from "../design/design";
import { showFrame } from "./shape";

/** What holds the frame. */
export type Hold = "design" | "free" | "chosen";

export interface FrameChoice {
  /** Null: that of the design. */
  readonly material: string | null;
  readonly hold: Hold;
  /** Vertices that a person has chosen as supports. */
  readonly chosen: ReadonlySet<number>;
  /** Multiples of standard gravity. */
  readonly gravity: Vec3;
  readonly modes: number;
  /** Errors of a machine with which the wires are made and closed; null: joints are not closed. */
  readonly errors: string | null;
  readonly closing: ClosingName;
  readonly runs: number;
  /** Whether wires may run along edges twice. */
  readonly double: boolean;
}

/** What is required of the closed frame; null: nothing. */
export interface Required {
  readonly surface: number | null;
  readonly force: number | null;
  readonly stress: number | null;
  readonly vary: VaryName;
}

/** An answer, and what it is of. */
interface Answer<T> {
  readonly value: T;
  readonly basis: string;
}

interface FrameStore extends FrameChoice {
  /** Whether clicks on vertices choose supports. */
  readonly picking: boolean;
  readonly answer: Answer<FrameShown> | null;
  readonly asking: boolean;
  /** Why there is none. */
  readonly problem: string | null;
  readonly required: Required;
  readonly tolerance: Answer<ToleranceResponse> | null;
  readonly askingTolerance: boolean;
  readonly toleranceProblem: string | null;
  /** Null before they are known. */
  readonly choices: FrameChoices | null;
}

const USUAL: FrameChoice = {
  material: null,
  hold: "design",
  chosen: new Set(),
  gravity: [0, 0, -1],
  modes: 6,
  errors: null,
  closing: "aligned",
  runs: 100,
  double: false,
};

const NO_ANSWERS = {
  picking: false,
  answer: null,
  asking: false,
  problem: null,
  tolerance: null,
  askingTolerance: false,
  toleranceProblem: null,
} as const;

export const useFrame = create<FrameStore>()(() => ({
  ...USUAL,
  ...NO_ANSWERS,
  required: { surface: null, force: null, stress: null, vary: "feed" },
  choices: null,
}));

export function chooseFrame(choice: Partial<FrameChoice>): void {
  useFrame.setState(choice);
}

export function require(required: Partial<Required>): void {
  useFrame.setState((frame) => ({ required: { ...frame.required, ...required } }));
}

let needed: Promise<void> | null = null;

/** Asks once what there is to choose from. */
export function needFrameChoices(): void {
  if (useFrame.getState().choices) return;
  needed ??= told(platform.ask("frame-choices", {}))
    .then((choices) => useFrame.setState({ choices }))
    .finally(() => (needed = null));
}

/** While it is on, clicks on vertices choose supports. */
export function setPicking(picking: boolean): void {
  useFrame.setState(picking ? { picking, hold: "chosen" } : { picking });
}

/** Takes vertices as supports, or lets those go that are. */
export function toggleSupports(vertices: Iterable<number>): void {
  useFrame.setState(({ chosen }) => {
    const after = new Set(chosen);
    for (const vertex of vertices) if (!after.delete(vertex)) after.add(vertex);
    return { chosen: after };
  });
}

function supports({ hold, chosen }: FrameChoice): FrameSupports {
  if (hold === "chosen") return { vertices: [...chosen].toSorted((a, b) => a - b) };
  return hold;
}

/** What an answer is of: with anything of this another it is out of date. */
function basisOf(choice: FrameChoice): string {
  const { material, gravity, modes, errors, closing, runs, double } = choice;
  const { version, state } = useDesign.getState();
  const closes = errors === null ? null : [errors, closing, runs, double, state?.machine];
  return JSON.stringify([version, state?.material, material, supports(choice), gravity, modes, closes]);
}

function toleranceBasis({ required, material, closing, double }: FrameStore): string {
  const { version, state } = useDesign.getState();
  return JSON.stringify([version, state?.machine, state?.material, required, material, closing, double]);
}

/** Whether anything was changed since the frame was computed. */
export function useFrameStale(): boolean {
  useDesign();
  const frame = useFrame();
  return frame.answer !== null && frame.answer.basis !== basisOf(frame);
}

export function useToleranceStale(): boolean {
  useDesign();
  const frame = useFrame();
  return frame.tolerance !== null && frame.tolerance.basis !== toleranceBasis(frame);
}

const wordsOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** Of several questions only the last one's answer counts. */
let asked = 0;
/** How many designs there were: what was asked of one is no answer for another. */
let opened = 0;

/** Computes the design as a frame, and shows it. */
export async function computeFrame(): Promise<void> {
  const choice = useFrame.getState();
  if (choice.asking) return;
  const { material, gravity, modes, errors, closing, runs, double } = choice;
  const basis = basisOf(choice);
  asked += 1;
  const question = asked;
  useFrame.setState({ asking: true, picking: false });
  let answer: Pick<FrameStore, "answer" | "problem">;
  try {
    const close = errors === null ? null : { errors, closing, runs, seed: 1 };
    const value = await asking("frame", {
      material,
      supports: supports(choice),
      gravity: [...gravity] as [number, number, number],
      modes,
      close,
      double,
    });
    answer = { answer: { value, basis }, problem: null };
  } catch (error) {
    answer = { answer: null, problem: wordsOf(error) };
  }
  if (question !== asked) return;
  useFrame.setState({ ...answer, asking: false });
  showFrame(answer.answer ? firstView(answer.answer.value) : null);
}

/** What is shown first of an answer: what it carries, else how it vibrates. */
function firstView({ shapes, result }: FrameShown): Parameters<typeof showFrame>[0] {
  if (shapes.loaded) return { kind: "loaded" };
  const bends = result.modes.findIndex(({ kind }) => kind !== "rigid");
  return bends >= 0 ? { kind: "mode", mode: bends } : null;
}

/** Asks how good a machine must be. */
export async function askTolerance(): Promise<void> {
  const frame = useFrame.getState();
  if (frame.askingTolerance) return;
  const { required, material, closing, double } = frame;
  const basis = toleranceBasis(frame);
  useFrame.setState({ askingTolerance: true });
  const before = opened;
  let answer: Pick<FrameStore, "tolerance" | "toleranceProblem">;
  try {
    const { surface, force, stress, vary } = required;
    const value = await asking("tolerance", {
      material,
      required: { surface_mm: surface, force_n: force, stress_mpa: stress },
      vary,
      closing,
      double,
    });
    answer = { tolerance: { value, basis }, toleranceProblem: null };
  } catch (error) {
    answer = { tolerance: null, toleranceProblem: wordsOf(error) };
  }
  if (before === opened) useFrame.setState({ ...answer, askingTolerance: false });
}

/** Forgets what was of a design that was closed. */
export function forgetFrame(): void {
  asked += 1;
  opened += 1;
  useFrame.setState({ ...NO_ANSWERS, hold: "design", chosen: new Set() });
  showFrame(null);
}

/** Supports that are not there any more hold nothing. */
export function keepSupports(): void {
  const { vertices } = useDesign.getState();
  const { chosen } = useFrame.getState();
  const left = [...chosen].filter((id) => vertices.has(id));
  if (left.length < chosen.size) useFrame.setState({ chosen: new Set(left) });
}
