/** What is said of a file that is run. */

import type { RunFileReport } from "../../../generated/responses";
import { errorText } from "../../../platform/error_text";
import { sentence } from "../../../shared/figures/format";
import type { Tone } from "../../../shared/lists/Mark";

type Kind = RunFileReport["kind"];

/** How it is run. */
export const HOW: Readonly<Record<Kind, { readonly what: string; readonly sub: string }>> = {
  job: { what: "Runs as it was planned", sub: "The design behind it is not used." },
  program: { what: "Runs as it stands", sub: "Nothing of it is compensated. The view shows the shape that it leaves." },
  moves: { what: "Is replayed move by move", sub: "The machine homes first. The view shows the wire as ordered." },
};

/** "job for WireBend-kit". */
export function kindPhrase(kind: Kind, machine: string): string {
  return `${{ job: "job for", program: "program for", moves: "recorded on" }[kind]} ${machine}`;
}

/** So many findings are listed. */
const LISTED = 3;

interface Finding {
  readonly tone: Tone;
  readonly what: string;
  readonly sub: string | null;
}

/** What the checks say of it, errors first; that they have nothing to say is said, too. Moves are held against limits as they run. */
export function findingsOf({ kind, findings, notes, feasible }: RunFileReport): readonly Finding[] {
  if (kind === "moves") return [];
  const said = findings
    .filter(({ severity }) => severity !== "info")
    .map(
      ({ severity, message, limit_source }): Finding => ({
        tone: severity === "error" ? "error" : "warning",
        what: sentence(message),
        sub: limit_source ? `Limit from ${limit_source}` : null,
      }),
    );
  const noted = notes.map((note): Finding => ({ tone: "warning", what: sentence(errorText(note)), sub: null }));
  // What a program was not searched for counts as much as what was found.
  const searched = !notes.some(({ code }) => code === "collisions-not-searched");
  const within: Finding = { tone: "fine", what: "Within the machine's limits", sub: null };
  const all = [...(feasible && searched ? [within] : []), ...(searched ? [...said, ...noted] : [...noted, ...said])];
  const more = all.length - LISTED;
  if (more <= 0) return all;
  return [...all.slice(0, LISTED), { tone: "info", what: `And ${more} more`, sub: null }];
}
