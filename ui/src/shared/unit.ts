import { useMemo } from "react";
import { create } from "zustand";
import { asShown, type DisplayUnit, length, lengthNumber, longLength, unitName } from "./format";

/** What lengths are shown in: as the person has chosen, else as the design says. It is set from there. */
export const useUnitStore = create<{ unit: DisplayUnit }>()(() => ({ unit: "mm" }));

export function useUnit(): DisplayUnit {
  return useUnitStore(({ unit }) => unit);
}

/** The formats of lengths in the unit that is shown. */
export function useLengths() {
  const unit = useUnit();
  return useMemo(
    () => ({
      unit,
      name: unitName(unit),
      /** "601.4 mm". */
      length: (mm: number) => length(mm, unit),
      /** "12.22 m". */
      long: (mm: number) => longLength(mm, unit),
      /** A sentence that was made elsewhere. */
      said: (text: string) => asShown(text, unit),
      /** "601.4". */
      bare: (mm: number) => lengthNumber(mm, unit),
    }),
    [unit],
  );
}
