/** How values of profiles and where they come from are said. */

import type { ValueReport } from "../../../generated/responses";
import { type DisplayUnit, short, unitName, unitSize } from "../../../shared/figures/format";
import { type FieldSpec, specOf } from "./fields";

/** Where a value comes from: "Measured: caliper", or the profile that sets it. */
export function sourceOf(value: ValueReport | null): string {
  if (!value) return "not set";
  if (value.source)
    return value.measured && !/measured/i.test(value.source) ? `Measured: ${value.source}` : value.source;
  return `set in ${value.set_by}, without a source`;
}

/** A plain value with its unit. */
function shown(spec: FieldSpec, value: unknown, unit: DisplayUnit): string {
  if (value === null || value === undefined) return spec.absent ?? "none";
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value !== "number") return typeof value === "string" ? value : "other pairs";
  if (spec.kind === "length") return `${short(value / unitSize(unit))} ${unitName(unit)}${spec.per ?? ""}`;
  const own = spec.kind === "number" ? (spec.unit ?? "") : spec.kind === "springback" ? "°" : "";
  return own === "" ? short(value) : `${short(value)}${own.startsWith("°") ? "" : " "}${own}`;
}

/** A value of a profile on a line: "1.5 mm", "23 pairs"; of what no form has a field for its key tells the unit. */
export function shownValue(key: string, value: unknown, unit: DisplayUnit): string {
  if (value === null || value === undefined) return "–";
  if (Array.isArray(value)) return `${value.length} pairs`;
  const plain = { key, label: key };
  const own: FieldSpec = key.endsWith("_mm")
    ? { ...plain, kind: "length" }
    : { ...plain, kind: "number", unit: key.endsWith("_deg") ? "°" : "" };
  return shown(specOf(key) ?? own, value, unit);
}

/** "was 20.4 mm · ", of a value that takes the place of another. */
export function beforeOf(spec: FieldSpec, value: ValueReport | null, unit: DisplayUnit): string {
  if (!value?.instead_of) return "";
  return `was ${shown(spec, value.instead_of.value, unit)} · `;
}
