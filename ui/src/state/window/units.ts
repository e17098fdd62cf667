import { create } from "zustand";

/** What lengths are shown in; inside and everywhere else they are mm. */
export type DisplayUnit = "mm" | "inch";

interface UnitStore {
  /** As the person has chosen, else as the design says. */
  readonly unit: DisplayUnit;
  /** Names that lengths may stand in, as of wires: they stay as they are. */
  readonly names: readonly string[];
}

export const useUnits = create<UnitStore>()(() => ({ unit: "mm", names: [] }));
