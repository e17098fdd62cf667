/** The search for an order of the bends that hits nothing, as a person asks for it. */

import { create } from "zustand";
import type { SearchSettings } from "../../../generated/requests";
import type { AvoidedCollisions, Collisions } from "../../../generated/responses";
import { platform } from "../../../platform";
import { tell, told } from "../../asking/problems";
import { asking } from "../../asking/work";
import { useDesign } from "../design";
import { applyFix, makesMoreWires } from "./fixes";

interface Avoiding {
  /** The collisions that are to be avoided: of another design it is over. */
  readonly of: Collisions;
  /** How many wires it was allowed. */
  readonly wires: SearchSettings["wires"];
  /** Whether it is to end with the best that it has. */
  readonly ending: boolean;
  /** What came of it; null while it is under way. */
  readonly outcome: AvoidedCollisions | null;
}

export const useAvoiding = create<{ readonly avoiding: Avoiding | null }>()(() => ({ avoiding: null }));

/** What is left out is as on the command line. */
export const SEARCH_DEFAULTS = { effort: 20_000, seed: 1, weights: { wire: 1000, doubled_mm: 1, second: 5 } } as const;

/** How it is searched, until the program ends. */
export const useSearchSettings = create<SearchSettings>()(() => ({
  effort: null,
  seed: null,
  weights: null,
  wires: null,
}));

export function setSearch(changed: Partial<SearchSettings>): void {
  useSearchSettings.setState(changed);
}

/** Whether no weight counts: then no order is better than another. */
export const weighsNothing = ({ weights }: SearchSettings): boolean =>
  Boolean(weights) && Object.values(weights ?? {}).every((weight) => weight === 0);

const current = (): Collisions | null => useDesign.getState().collisions?.found ?? null;

/** Takes walks with which the wire hits nothing, once the search for them is over, if it finds some without more wires. */
export async function avoidCollisions(): Promise<void> {
  const found = current();
  const before = useAvoiding.getState().avoiding;
  if (!found || (before?.of === found && !before.outcome)) return;
  const settings = useSearchSettings.getState();
  const asked = { of: found, wires: settings.wires, ending: false };
  useAvoiding.setState({ avoiding: { ...asked, outcome: null } });
  // Of another design nobody waits for it.
  const watch = useDesign.subscribe(() => {
    if (current() === found) return;
    watch();
    stop();
  });
  const outcome = await told(asking("avoid-collisions", { settings }));
  watch();
  if (useAvoiding.getState().avoiding?.of !== found) return;
  if (current() !== found || !outcome) return useAvoiding.setState({ avoiding: null });
  const { best } = outcome;
  useAvoiding.setState({ avoiding: { ...asked, outcome } });
  if (!best || !outcome.found || makesMoreWires(best)) return;
  if ((await applyFix(best)) && outcome.ended)
    tell(
      "info",
      "The search was ended. The best order of the bends until then hits nothing and is taken. Undo takes it back.",
    );
}

/** Ends that search with the best that it has. */
export function endAvoiding(): void {
  const { avoiding } = useAvoiding.getState();
  if (!avoiding || avoiding.outcome) return;
  useAvoiding.setState({ avoiding: { ...avoiding, ending: true } });
  stop();
}

function stop(): void {
  void platform.ask("stop-avoiding", {}).catch(() => {});
}
