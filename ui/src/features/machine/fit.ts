/** Whether a wire fits a machine, and what is known of it. */

import type { MachineEntry, MaterialEntry } from "../../generated/responses";
import { type DisplayUnit, length, money, number } from "../../shared/format";

/** Why a wire does not fit a machine; null where it does, or where no machine is chosen. */
export function misfit(material: MaterialEntry, machine: MachineEntry | null, unit: DisplayUnit): string | null {
  if (!machine) return null;
  const [thin, thick] = machine.diameter_mm;
  if (material.diameter_mm < thin) return `thinner than ${machine.name} takes (${length(thin, unit)})`;
  return material.diameter_mm > thick ? `thicker than ${machine.name} takes (${length(thick, unit)})` : null;
}

/** "3.0 mm · $1.99 a metre · springback measured". */
export function known(material: MaterialEntry, unit: DisplayUnit): string {
  const { price_per_mm: price, currency } = material;
  const cost = price === null ? "price not known" : unit === "inch" ? `${money(price * 304.8, currency)} a foot` : `${money(price * 1000, currency)} a metre`;
  const across = unit === "inch" ? `${number(material.diameter_mm / 25.4, 3)} in` : `${number(material.diameter_mm, Number.isInteger(material.diameter_mm * 10) ? 1 : 3)} mm`;
  return [across, cost, `springback ${material.springback_measured ? "measured" : "estimated"}`].join(" · ");
}
