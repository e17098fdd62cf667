import { create } from "zustand";

/** What lengths are shown in; inside and everywhere else they are mm. */
export type DisplayUnit = "mm" | "inch";

interface UnitStore {
  /** As the person has chosen, else as the design says. */
  readonly unit: DisplayUnit;
}

export const useUnits = create<UnitStore>()(() => ({ unit: "mm" }));
