/** What can be written, by what it is for. */

import type { FormatEntry } from "../../generated/responses";
import { number } from "../../shared/figures/format";

export interface Group {
  readonly title: string;
  readonly formats: readonly FormatEntry[];
}

const GROUPS = ["This machine", "Templates and sheets", "Pictures and models", "Tables and programs"] as const;

function groupOf(format: FormatEntry, driver: string | null): (typeof GROUPS)[number] {
  if (format.driver !== null && format.driver === driver) return "This machine";
  if (format.id.startsWith("template-") || format.id === "job-sheet") return "Templates and sheets";
  if (format.driver === null) return "Pictures and models";
  return "Tables and programs";
}

/** Whether it is pages that a person prints, which can be looked at before. */
export const isPrinted = ({ driver, extension }: FormatEntry): boolean => driver === null && extension === "pdf";

/** Groups that have something in them; the formats stay in their order. `driver`: that of the machine. */
export function grouped(formats: readonly FormatEntry[], driver: string | null): readonly Group[] {
  const of = (title: string) => formats.filter((format) => groupOf(format, driver) === title);
  return GROUPS.map((title) => ({ title, formats: of(title) })).filter(({ formats: some }) => some.length > 0);
}

/** A file name for a design in a format: "bunny.wirebend" as "gcode" is "bunny.gcode". */
export function fileName(design: string, { id, extension }: Pick<FormatEntry, "id" | "extension">): string {
  // Papers of one design lie beside each other.
  const paper = id === "job-sheet" ? "-sheet" : id.startsWith("template-") ? "-template" : "";
  const stem = design
    .replace(/\.(wirebend|wbjob)$/i, "")
    .trim()
    .replace(/[/\\:*?"<>|]+/g, "-");
  return `${stem === "" ? "design" : stem}${paper}.${extension}`;
}

/** Another file in the folder of a path: of the path that a design was saved at. Both kinds of separators are known. */
export function beside(path: string | null, name: string): string {
  const end = path === null ? -1 : Math.max(path.lastIndexOf("/"), path.lastIndexOf("\\"));
  return path === null || end < 0 ? name : path.slice(0, end + 1) + name;
}

/** "12 B", "3.4 kB", "1.2 MB". */
export function bytes(many: number): string {
  if (many < 1000) return `${many} B`;
  return many < 1e6 ? `${number(many / 1e3)} kB` : `${number(many / 1e6)} MB`;
}
