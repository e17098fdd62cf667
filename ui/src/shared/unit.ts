import { useMemo } from "react";
import { create } from "zustand";
import { asShown, type DisplayUnit, length, lengthNumber, longLength, unitName } from "./format";

interface UnitStore {
  /** What lengths are shown in: as the person has chosen, else as the design says. It is set from there. */
  readonly unit: DisplayUnit;
  /** Names that lengths may stand in, as of wires: they stay as they are. Set by whoever knows them. */
  readonly names: readonly string[];
}

export const useUnitStore = create<UnitStore>()(() => ({ unit: "mm", names: [] }));

export function useUnit(): DisplayUnit {
  return useUnitStore(({ unit }) => unit);
}

/** The formats of lengths in the unit that is shown. */
export function useLengths() {
  const { unit, names } = useUnitStore();
  return useMemo(
    () => ({
      unit,
      name: unitName(unit),
      /** "601.4 mm". */
      length: (mm: number) => length(mm, unit),
      /** "12.22 m". */
      long: (mm: number) => longLength(mm, unit),
      /** A sentence that was made elsewhere. */
      said: (text: string) => asShown(text, unit, names),
      /** "601.4". */
      bare: (mm: number) => lengthNumber(mm, unit),
    }),
    [unit, names],
  );
}
