import { createContext, use, useMemo } from "react";
import { type DisplayUnit, length, lengthNumber, longLength, unitName } from "./format";

/** What lengths are shown in: set by the part that knows what the person has chosen. */
export const ShownUnit = createContext<DisplayUnit>("mm");

export function useUnit(): DisplayUnit {
  return use(ShownUnit);
}

export type Lengths = ReturnType<typeof useLengths>;

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
      /** "601.4". */
      bare: (mm: number) => lengthNumber(mm, unit),
    }),
    [unit],
  );
}
