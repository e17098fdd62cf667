import { create } from "zustand";
import { store, stored } from "./ui";

const KEY = "wirebend.hints";

/** The hints of the first start: `step` is the one that is shown; null once they are dismissed. */
export const useHints = create<{ readonly step: number | null }>()(() => ({ step: stored(KEY) === "seen" ? null : 0 }));

export function dismissHints(): void {
  useHints.setState({ step: null });
  store(KEY, "seen");
}

export function goToHint(step: number): void {
  useHints.setState({ step });
}

/** Shows them again from the first. */
export function showHints(): void {
  useHints.setState({ step: 0 });
}
