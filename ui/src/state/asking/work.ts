import { create } from "zustand";
import type { Requests } from "../../generated/requests";
import type { Responses, Work } from "../../generated/responses";
import { type AskName, platform } from "../../platform";

interface Underway extends Work {
  /** How many wait for an answer. */
  readonly waiting: number;
}

interface WorkStore {
  /** By what was asked for. */
  readonly works: ReadonlyMap<string, Underway>;
}

export const useWork = create<WorkStore>()(() => ({ works: new Map() }));

function change(ask: string, to: (before: Underway | undefined) => Underway | null): void {
  useWork.setState(({ works }) => {
    const changed = new Map(works);
    const work = to(works.get(ask));
    if (work) changed.set(ask, work);
    else changed.delete(ask);
    return { works: changed };
  });
}

/** Asks for something that may take long: what is heard of it is shown until the answer is there. */
export async function asking<K extends AskName>(ask: K, request: Requests[K]): Promise<Responses[K]> {
  const begin = { ask, stage: "", done: 0, of: 0, found: null, waiting: 0 };
  change(ask, (before = begin) => ({ ...before, waiting: before.waiting + 1 }));
  try {
    return await platform.ask(ask, request);
  } finally {
    change(ask, (before) => (before && before.waiting > 1 ? { ...before, waiting: before.waiting - 1 } : null));
  }
}

/** Hears how far something is. What is reported after the answer, or without a caller that waits, is over or too short to be shown. */
export function hearWork(work: Work): void {
  if (useWork.getState().works.has(work.ask))
    change(work.ask, (before) => (before ? { ...work, waiting: before.waiting } : null));
}
