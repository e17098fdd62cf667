/** How far off the machine will make the open design: what was asked, and what was found. */

import { create } from "zustand";
import type { Prediction } from "../../generated/responses";
import { platform } from "../../platform";
import { asking } from "../asking/work";
import { type Basis, designNow, isSame } from "../design/content";
import { useDesign, wiresOf } from "../design/design";
import { useFrame } from "../frame/frame";
import { useMachines } from "../machine/machines";

interface Answer {
  readonly value: Prediction;
  /** What it is of. */
  readonly basis: Basis;
}

interface PredictionStore {
  /** A noise profile; null: that of the machine, or a typical one. */
  readonly noise: string | null;
  /** How close every vertex has to be to its place, mm. */
  readonly within: number;
  readonly answer: Answer | null;
  readonly asking: boolean;
  /** Why there is none. */
  readonly problem: string | null;
  /** Whether the view shows how far vertices scatter. */
  readonly shown: boolean;
}

const NONE = { answer: null, asking: false, problem: null } as const;

/** So many wires tell the distance of 95 % to about 2 %. */
const RUNS = 2000;
/** Everything that is drawn at random is drawn again the same. */
const SEED = 1;

export const usePrediction = create<PredictionStore>()(() => ({ ...NONE, noise: null, within: 1, shown: true }));

export function choosePrediction(choice: Partial<Pick<PredictionStore, "noise" | "within" | "shown">>): void {
  usePrediction.setState(choice);
}

/** The noise profile that the profile of a machine names. */
export const noiseOf = (
  machines: readonly { readonly id: string; readonly noise: string | null }[] | null,
  machine: string | null,
): string | null => machines?.find(({ id }) => id === machine)?.noise ?? null;

/** The noise profile that is taken: the one that was chosen, else that of the machine, else the first that has errors. */
export function noiseTaken(
  noise: string | null,
  /** That which the machine's profile names. */
  own: string | null,
  known: readonly { id: string }[],
): string | null {
  const has = (id: string | null) => known.some((entry) => entry.id === id);
  if (noise !== null && has(noise)) return noise;
  if (has(own)) return own;
  return known.find(({ id }) => id !== "none")?.id ?? null;
}

const taken = (): string | null =>
  noiseTaken(
    usePrediction.getState().noise,
    noiseOf(useMachines.getState().machines, useDesign.getState().state?.machine ?? null),
    useFrame.getState().choices?.errors ?? [],
  );

function basisOf(): Basis {
  const { state } = useDesign.getState();
  return designNow(useMachines.getState().changes, wiresOf(state), taken(), usePrediction.getState().within);
}

/** Supports, joints and ceilings have no part in how a wire is bent. */
const isCurrent = ({ basis }: Answer): boolean => isSame(basis, basisOf(), []);

/** Whether anything was changed since it was predicted. */
export function usePredictionStale(): boolean {
  useDesign();
  useMachines(({ changes }) => changes);
  useFrame(({ choices }) => choices);
  const { answer } = usePrediction();
  return answer !== null && !isCurrent(answer);
}

/** What is shown of it: an answer that is of the design as it is. */
export const predictedNow = (): Prediction | null => {
  const { answer, shown } = usePrediction.getState();
  return shown && answer && isCurrent(answer) ? answer.value : null;
};

/** Of several questions only the last one's answer counts. */
let asked = 0;

export async function predict(): Promise<void> {
  const noise = taken();
  if (noise === null) return;
  const basis = basisOf();
  asked += 1;
  const question = asked;
  usePrediction.setState({ asking: true, problem: null });
  let after: Pick<PredictionStore, "answer" | "problem">;
  try {
    const { within } = usePrediction.getState();
    const { found } = await asking("predict", { noise, runs: RUNS, seed: SEED, within_mm: within });
    after = { answer: found ? { value: found, basis } : null, problem: null };
  } catch (error) {
    after = { answer: null, problem: error instanceof Error ? error.message : String(error) };
  }
  if (question === asked) usePrediction.setState({ ...after, asking: false });
}

/** A person does not want to wait for it any more. */
export async function stopPrediction(): Promise<void> {
  await platform.ask("stop-prediction", {}).catch(() => {});
}

/** Forgets why there was no answer. */
export function forgetPredictionProblem(): void {
  if (usePrediction.getState().problem) usePrediction.setState({ problem: null });
}

/** Forgets what was of a design that was closed. */
export function forgetPrediction(): void {
  if (usePrediction.getState().asking) void stopPrediction();
  asked += 1;
  usePrediction.setState(NONE);
}
