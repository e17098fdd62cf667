/** Whether a wire fits a machine, and what is known of it. */

import type { MachineEntry, MachineViewResponse, MaterialEntry } from "../../../generated/responses";
import { type DisplayUnit, length, money, number, roundedUp } from "../../../shared/figures/format";

/** Why a wire does not fit a machine; null where it does, or where no machine is chosen. */
export function misfit(material: MaterialEntry, machine: MachineEntry | null, unit: DisplayUnit): string | null {
  if (!machine) return null;
  const [thin, thick] = machine.diameter_mm;
  if (material.diameter_mm < thin) return `thinner than ${machine.name} takes (${length(thin, unit)})`;
  return material.diameter_mm > thick ? `thicker than ${machine.name} takes (${length(thick, unit)})` : null;
}

/** A figure of a wire: what it is, and its value. */
export type Figure = readonly [what: string, value: string];

/** What is known of a wire, the most asked for first: "diameter" "3.0 mm". */
export function figures(material: MaterialEntry, unit: DisplayUnit): readonly Figure[] {
  const { price_per_mm: price, currency, diameter_mm: across, springback_deg: lost } = material;
  const cost =
    price === null
      ? "not known"
      : unit === "inch"
        ? `${money(price * 304.8, currency)} a foot`
        : `${money(price * 1000, currency)} a metre`;
  const thick = length(across, unit, unit === "inch" || Number.isInteger(across * 10) ? 0 : 2);
  const [least, most] = lost.map((deg) => number(deg)) as [string, string];
  return [
    ["diameter", thick],
    ["price", cost],
    ["k factor", number(material.k_factor, 2)],
    ["yield", `${number(material.yield_strength_mpa, 0)} MPa`],
    [
      "springback",
      `${least === most ? least : `${least}° to ${most}`}°, ${material.springback_measured ? "measured" : "estimated"}`,
    ],
  ];
}

/** A length that an edge needs at least, rounded up in the unit that is shown: an edge of what is named has to do. */
export const leastLength = (mm: number, unit: DisplayUnit): string => length(roundedUp(mm, unit), unit);

/** " (25.0 mm beside a bend of 90°)", where that is more: the bend takes its part of the edge, and the feed has a limit too. */
export function besideBend(
  view: Pick<MachineViewResponse, "min_edge_mm" | "min_edge_between_mm"> | null,
  unit: DisplayUnit,
): string {
  const mm = view?.min_edge_between_mm ?? null;
  const shown = mm === null ? null : leastLength(mm, unit);
  return view === null || shown === null || shown === leastLength(view.min_edge_mm, unit)
    ? ""
    : ` (${shown} beside a bend of 90°)`;
}
