import type { Fix, LiveCheck, WireFigures } from "../../generated/responses";

type Sums = { readonly [K in "length_mm" | "stock_mm" | "time_s" | "cost" | "bends"]: number | null } & {
  readonly currency: string | null;
};

/** Sums over all wires; null where one is not known, or where there is none. */
export function totals(check: LiveCheck | null): Sums {
  const wires = check?.wires ?? [];
  const sum = (of: (wire: WireFigures) => number | null) =>
    wires.length === 0
      ? null
      : wires.reduce<number | null>((all, wire) => {
          const value = of(wire);
          return all === null || value === null ? null : all + value;
        }, 0);
  return {
    length_mm: sum((wire) => wire.length_mm),
    stock_mm: sum((wire) => wire.stock_mm),
    time_s: sum((wire) => wire.time_s),
    cost: sum((wire) => wire.cost),
    bends: sum((wire) => wire.bends),
    currency: wires[0]?.currency ?? null,
  };
}

/** Without a route there are no figures, and what is wrong along it is not known before there is one. */
export const isFirst = ({ length_mm, stock_mm, time_s, cost }: Fix["change"]): boolean =>
  length_mm === null && stock_mm === null && time_s === null && cost === null;
