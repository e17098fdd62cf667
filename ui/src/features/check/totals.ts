import type { Fix, LiveCheck, WireFigures } from "../../generated/responses";
import { count, LIMITS_ONLY } from "../../shared/figures/format";

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
    cost: sum((wire) => wire.stock_cost),
    bends: sum((wire) => wire.bends),
    currency: wires[0]?.currency ?? null,
  };
}

/** Without a route there are no figures, and what is wrong along it is not known before there is one. */
export const isFirst = ({ length_mm, stock_mm, time_s, cost }: Fix["change"]): boolean =>
  length_mm === null && stock_mm === null && time_s === null && cost === null;

/** What is hit after a fix, or comes near; null where it was not tried with a check for collisions. */
export function metOf({ collisions, near }: Pick<Fix["after"], "collisions" | "near">): string | null {
  if (collisions === null) return null;
  const hits = collisions === 0 ? "no collision found" : count(collisions, "collision");
  return near === null || near === 0 ? hits : `${hits}, and ${count(near, "place")} nearer than the clearance`;
}

/** `before`: how many errors there are. */
export function afterwards({ change, after, errors_after: errors }: Fix, before: number): string {
  const { wires } = after;
  const left = metOf(after);
  if (errors === 0) return `then ${left ?? LIMITS_ONLY}`;
  const made = wires > 1 ? `${wires} wires` : "a wire";
  const found = isFirst(change) ? `gives ${made} with ${count(errors, "error")}` : `then ${count(errors, "error")}`;
  // Without a route no bend can be checked: what the fix brings to light is not its doing.
  return errors > before ? `${found}, of which at least ${errors - before} could not be checked before` : found;
}
