/** The order in which a machine builds the struts of the open design: looking for one, changing it, and playing it. */

import { create } from "zustand";
import type { GroupBy, OrderedStep } from "../../generated/requests";
import type { DrawnSequence } from "../../generated/responses";
import { platform } from "../../platform";
import { asking } from "../asking/work";
import { type Basis, designNow, isSame } from "../design/content";
import { useDesign } from "../design/design";
import { showFrame } from "../frame/shape";
import { hideByHand } from "../machine/by_hand";
import { useMachines } from "../machine/machines";
import { showDesignAgain, usePlayback } from "../program/program";

interface SequenceStore {
  /** The machine that builds; null before the list is known. */
  readonly machine: string | null;
  /** How far a joint may be off, mm; null: what the head still meets. */
  readonly epsilon: number | null;
  /** What is placed at once: a strut, or all of a wire. */
  readonly groupBy: GroupBy;
  /** What was found; null before, and where a search failed. */
  readonly found: DrawnSequence | null;
  /** The same in an order that a person has changed, as it was checked. */
  readonly changed: DrawnSequence | null;
  /** What it is of. */
  readonly basis: Basis | null;
  readonly asking: boolean;
  readonly checking: boolean;
  /** A file is being written, of what was shown then, whatever is by now. */
  readonly saving: boolean;
  /** A person has ended the last search: what was found before is shown on. */
  readonly cancelled: boolean;
  /** Why there is no answer, and to what. */
  readonly problem: string | null;
  readonly tried: "search" | "check";
  /** Whether the view shows it. */
  readonly shown: boolean;
  /** How many steps are built, with the part of the one that is under way. */
  readonly at: number;
  readonly playing: boolean;
  /** Whether struts have the colours of their layers. */
  readonly layers: boolean;
}

const NONE = {
  found: null,
  changed: null,
  basis: null,
  asking: false,
  checking: false,
  cancelled: false,
  problem: null,
  tried: "search",
  shown: false,
  at: 0,
  playing: false,
} as const;

export const useSequence = create<SequenceStore>()(() => ({
  machine: null,
  epsilon: null,
  groupBy: "edge",
  layers: false,
  saving: false,
  ...NONE,
}));

/** What is shown: what a person has made of the order, else what was found. */
export const shownSequence = ({ found, changed }: Pick<SequenceStore, "found" | "changed">): DrawnSequence | null =>
  changed ?? found;

export function chooseBuilder(machine: string): void {
  useSequence.setState({ machine });
}

export function chooseEpsilon(epsilon: number | null): void {
  useSequence.setState({ epsilon });
}

export function chooseGroups(groupBy: GroupBy): void {
  useSequence.setState({ groupBy });
}

export function showLayers(layers: boolean): void {
  useSequence.setState({ layers });
}

function basisOf({ machine, epsilon, groupBy }: Pick<SequenceStore, "machine" | "epsilon" | "groupBy">): Basis {
  const { state } = useDesign.getState();
  // The walks of the wires say what is placed at once.
  const walks = groupBy === "wire" ? state?.walks : null;
  return designNow(useMachines.getState().changes, machine, epsilon, groupBy, state?.material, walks);
}

/** Whether anything was changed since it was found. */
export function isSequenceStale(): boolean {
  const sequence = useSequence.getState();
  const { found, basis } = sequence;
  return found !== null && (basis === null || !isSame(basis, basisOf(sequence), ["joint", "support", "ceiling"]));
}

export function useSequenceStale(): boolean {
  useDesign();
  useSequence();
  useMachines(({ changes }) => changes);
  return isSequenceStale();
}

/** What is under way, which another question would end; null where nothing is. */
export function underWay({
  asking,
  checking,
  saving,
}: Pick<SequenceStore, "asking" | "checking" | "saving">): string | null {
  if (asking) return "A sequence is being looked for.";
  if (checking) return "The sequence is being checked.";
  return saving ? "The sequence is being saved." : null;
}

const wordsOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** Of several questions only the last one's answer counts. */
let asked = 0;

/** Looks for a sequence, or checks that of a file, and shows it. `material`: what the machine builds with. */
export async function findSequence(material: string | null, file: string | null = null): Promise<void> {
  const { machine, epsilon, groupBy } = useSequence.getState();
  if (machine === null || underWay(useSequence.getState())) return;
  const basis = basisOf({ machine, epsilon, groupBy });
  asked += 1;
  const question = asked;
  useSequence.setState({ asking: file === null, checking: file !== null, cancelled: false });
  let answer: Pick<SequenceStore, "found" | "problem">;
  let kept = false;
  try {
    const from = file === null ? {} : { file };
    const found = await asking("sequence", { machine, material, epsilon_mm: epsilon, group_by: groupBy, ...from });
    answer = { found, problem: null };
  } catch (error) {
    answer = { found: null, problem: wordsOf(error) };
    kept = file !== null;
  }
  if (question !== asked) return;
  if (kept) {
    // A file without a sequence takes nothing away.
    useSequence.setState({ problem: answer.problem, tried: "check", checking: false });
    return;
  }
  useSequence.setState({
    ...answer,
    tried: "search",
    changed: null,
    basis,
    asking: false,
    checking: false,
    at: 0,
    playing: false,
  });
  const steps = answer.found?.sequence.steps.length ?? 0;
  // A view of the design as it was does not take the place of the one that is being changed.
  if (steps > 0 && !isSequenceStale()) goToStep(steps);
  else hideSequence();
}

/** A person has had enough of a search: what was found before stays. */
export function cancelSequence(): void {
  if (!useSequence.getState().asking) return;
  asked += 1;
  useSequence.setState({ asking: false, cancelled: true });
  // What cannot be stopped is answered some time, and nobody hears it.
  void platform.ask("stop-sequence", {}).catch(() => {});
}

/** Shows so many steps as built. What else the view may show gives way. */
function goToStep(at: number): void {
  const sequence = shownSequence(useSequence.getState());
  const steps = sequence?.sequence.steps.length ?? 0;
  // A machine that bends a wire is seen.
  if (steps === 0 || usePlayback.getState().live) return;
  if (!useSequence.getState().shown) {
    showDesignAgain();
    hideByHand();
    showFrame(null);
  }
  useSequence.setState({ shown: true, at: Math.min(Math.max(at, 0), steps) });
}

/** The same by hand: it does not play on. */
export function slideTo(at: number): void {
  useSequence.setState({ playing: false });
  goToStep(at);
}

/** The view shows the design again. */
export function hideSequence(): void {
  if (useSequence.getState().shown) useSequence.setState({ shown: false, playing: false });
}

/** Forgets why there was no answer. */
export function forgetSequenceProblem(): void {
  if (useSequence.getState().problem) useSequence.setState({ problem: null });
}

/** The step that is under way, from 0, or was built last. */
export const stepAt = (at: number, steps: number): number => Math.min(Math.max(Math.ceil(at) - 1, 0), steps - 1);

export function togglePlaySequence(): void {
  const state = useSequence.getState();
  const steps = shownSequence(state)?.sequence.steps.length ?? 0;
  if (state.playing) {
    useSequence.setState({ playing: false });
    return;
  }
  goToStep(state.at >= steps ? 0 : state.at);
  useSequence.setState({ playing: useSequence.getState().shown });
}

/** Steps as an order that can be checked. */
export const orderOf = (steps: DrawnSequence["sequence"]["steps"]): OrderedStep[] =>
  steps.map((step) => ({
    edge: step.edge,
    // A wire is fastened anew wherever it meets what stands.
    edges: step.edges ?? [],
    from_vertex: step.from_vertex ?? null,
    direction: step.direction ?? null,
  }));

/** Moves a step to another place, both from 0, and checks at once whether it can be built so. */
export async function moveStep(from: number, to: number): Promise<void> {
  const { machine, epsilon, groupBy, found } = useSequence.getState();
  if (underWay(useSequence.getState())) return;
  const sequence = shownSequence(useSequence.getState());
  const steps = sequence?.sequence.steps ?? [];
  const moved = steps[from];
  if (machine === null || !found || !sequence || !moved || from === to || !steps[to]) return;
  const others = steps.filter((_, index) => index !== from);
  const order = orderOf([...others.slice(0, to), moved, ...others.slice(to)]).map(
    // The head of the moved step stands as it can; that of the others as it does, where it still can.
    (step): OrderedStep => (step.edge === moved.edge ? { ...step, direction: null } : step),
  );
  asked += 1;
  const question = asked;
  useSequence.setState({ checking: true });
  let answer: Partial<SequenceStore>;
  try {
    const material = found.sequence.material;
    const changed = await asking("sequence", { machine, material, epsilon_mm: epsilon, group_by: groupBy, order });
    answer = { changed, problem: null };
  } catch (error) {
    answer = { problem: wordsOf(error), tried: "check" };
  }
  if (question !== asked) return;
  useSequence.setState({ ...answer, checking: false });
  if (!isSequenceStale()) slideTo(to + 1);
}

/** The order is again as it was found. */
export function takeBackMoves(): void {
  useSequence.setState({ changed: null });
}

/** Forgets what was of a design that was closed. */
export function forgetSequence(): void {
  cancelSequence();
  asked += 1;
  useSequence.setState(NONE);
}
