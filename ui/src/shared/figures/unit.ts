import { createContext, use, useMemo } from "react";
import { asShown, type DisplayUnit, length, lengthNumber, longLength, unitName } from "./format";

/** How lengths are shown: set by the part that knows what the person has chosen. */
export const ShownLengths = createContext<{
  readonly unit: DisplayUnit;
  /** Names that lengths may stand in, as of wires: they stay as they are. */
  readonly names: readonly string[];
}>({ unit: "mm", names: [] });

export function useUnit(): DisplayUnit {
  return use(ShownLengths).unit;
}

/** The formats of lengths in the unit that is shown. */
export function useLengths() {
  const { unit, names } = use(ShownLengths);
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
