/** The unit that lengths are shown in, where the view writes them itself. */

export type Units = "mm" | "inch";

export const MM_PER_INCH = 25.4;

export const unitName = (units: Units): string => (units === "inch" ? "in" : "mm");

/** mm in one of the unit. */
export const unitSize = (units: Units): number => (units === "inch" ? MM_PER_INCH : 1);

/** mm as a number of the unit, without its name, with the digits that a machine can make. */
export function lengthNumber(mm: number, units: Units): string {
  return (mm / unitSize(units)).toFixed(units === "inch" ? 3 : 1).replace("-", "−");
}
