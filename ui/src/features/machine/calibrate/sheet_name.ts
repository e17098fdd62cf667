import { useMachines } from "../../../state/machine/machines";

/** What the coupons of a sheet are bent on, and of which wire. */
export interface SheetOf {
  readonly machine: string;
  readonly material: string;
}

/** "WireBend-kit with Steel 1 mm". */
export function useSheetName({ machine, material }: SheetOf): string {
  const { machines, materials } = useMachines();
  const name = (all: readonly { readonly id: string; readonly name: string }[] | null, id: string) =>
    all?.find((entry) => entry.id === id)?.name ?? id;
  return `${name(machines, machine)} with ${name(materials, material)}`;
}
