/** What is said of ports, wires and moves. */

import type { SimulatedAs } from "../../generated/requests";
import type { PortEntry } from "../../generated/responses";
import { errorText } from "../../platform/error_text";
import { angle, type DisplayUnit, deviation, length, time } from "../../shared/figures/format";
import type { Tone } from "../../shared/lists/Mark";
import type { MachineState, Move, Unfinished, WireRun, WireState } from "../../state/machine/operator";
import type { Row } from "../../state/machine/row";
import type { EndedAs } from "../../state/machine/run";
import type { Arming } from "./arming";

/** "/dev/ttyACM0 · Arduino Uno · probably this one". */
export function portPhrase({ name, description, usb, likely_for, simulated }: PortEntry): string {
  const what = simulated ? description || "simulated machine" : description || (usb?.product ?? "");
  const parts = [name, what, likely_for.length > 0 && !simulated ? "probably this one" : ""];
  return parts.filter((part) => part !== "").join(" · ");
}

/** "WireBend-kit · simulated · firmware 1.13": what is connected, where, and what it says of itself beyond its name. */
export function machinePhrase(
  name: string,
  { simulated, port, identity }: Pick<MachineState, "simulated" | "port" | "identity">,
): string {
  const said = identity?.startsWith(`${name}, `) ? identity.slice(name.length + 2) : identity;
  return [name, simulated ? "simulated" : port, said].filter(Boolean).join(" · ");
}

/** The port that is tried unless a person says another: a likely one, else the simulated machine; an unlikely one never. */
export function guess(ports: readonly PortEntry[]): string | null {
  const likely = ports.find(({ likely_for, simulated }) => !simulated && likely_for.length > 0);
  return (likely ?? ports.find(({ simulated }) => simulated))?.name ?? null;
}

/** "Piece 2 of 5 · "; nothing where there is only one. */
function ofPiece(piece: WireState["piece"]): string {
  return piece ? `Piece ${piece.number} of ${piece.of} · ` : "";
}

/** "14 of 31 steps done · 2:10, 1:05 left"; by the clock where the machine does not report what it has done. */
export function progressPhrase({ made, done_by, of, elapsed_s, remaining_s, piece }: WireState): string {
  return `${ofPiece(piece)}${made} of ${of} steps ${done_by === "machine" ? "done" : "by the clock"} · ${time(elapsed_s)}, ${time(remaining_s)} left`;
}

/** "load 1 240 mm"; of several wires the longest counts, since a person is asked before each. */
export function loadPhrase(
  { wires, wire, beyondMm }: Pick<Arming, "wires" | "wire" | "beyondMm">,
  long: (mm: number) => string,
): string {
  const stocks = (wire === null ? wires : wires.slice(wire, wire + 1)).map(({ stock_mm }) => stock_mm ?? null);
  if (stocks.length === 0 || stocks.includes(null)) return "";
  const most = Math.max(...stocks.filter((mm) => mm !== null));
  return `load ${wire === null ? "up to " : ""}${long(most + beyondMm)}`;
}

/** "Wires 2 and 3 of the piece remain: wire 2 is armed next." */
export function restPhrase(rest: readonly number[], interrupted: boolean): string {
  const names = rest.map((wire) => wire + 1);
  const [first] = names;
  const several = names.length > 1;
  const which = several ? `Wires ${names.slice(0, -1).join(", ")} and ${names.at(-1)}` : `Wire ${first}`;
  const next = interrupted ? "the interrupted one comes first" : `wire ${first} is armed next`;
  return `${which} of the piece ${several ? "remain" : "remains"}${several || interrupted ? `: ${next}` : ""}.`;
}

/** "2 of 5 pieces are finished: 3 remain, with the one that was interrupted." */
export function leftPhrase({ of, left }: Row, interrupted: boolean): string {
  const made = of - left;
  const finished = `${made === 0 ? "None" : made} of ${of} pieces ${made > 1 ? "are" : "is"} finished`;
  return `${finished}: ${left} ${left === 1 ? "remains" : "remain"}${interrupted ? ", with the one that was interrupted" : ""}.`;
}

function doubtful(steps: readonly [number, number] | null | undefined): string {
  if (!steps) return "";
  const [first, last] = steps;
  const sent = first === last ? `Step ${first} was sent` : `Steps ${first} to ${last} were sent`;
  return ` ${sent}: before the wire resumes, the machine or you say what became of ${first === last ? "it" : "them"}.`;
}

/** "Step 14 of 31 is done. Step 15 was sent: before the wire resumes, the machine or you say what became of it." */
export function unfinishedPhrase({ made, of, in_doubt, resumable, piece }: Unfinished): string {
  if (!resumable) return "Its record is damaged, so that it is not known how far it came: it cannot be resumed.";
  return `${piece ? `It is piece ${piece.number} of ${piece.of}. ` : ""}${made === 0 ? "No step" : `Step ${made}`} of ${of} is done.${doubtful(in_doubt)}`;
}

/** What became of a wire. */
export function endedPhrase(
  run: WireRun,
  unit: DisplayUnit,
  { of, several }: EndedAs = { of: null, several: false },
): { readonly tone: Tone; readonly what: string; readonly sub: string | null } {
  const { outcome, made, steps, elapsed_s, problem, deviations_mm, standstill, piece, wire: index } = run;
  const which = piece ? `Piece ${piece.number} of ${piece.of}` : several ? `Wire ${index + 1}` : "The wire";
  const whose = of === null ? "" : ` of ${of || "a design without a name"}`;
  const wire = `${which}${whose}`;
  // Where it is another design's than what is open, that comes first.
  const says = (what: string) => (of === null ? what : `${wire}: ${what[0]?.toLowerCase()}${what.slice(1)}`);
  const sub = problem ? errorText(problem) : null;
  if (standstill && standstill !== "confirmed") {
    const what = says(`Not confirmed that the machine stands, after step ${made} of ${steps}`);
    return { tone: "error", what, sub: "Cut the power of the machine, then look at it and at the wire." };
  }
  switch (outcome) {
    case "made": {
      const worst = deviations_mm ? Math.max(0, ...deviations_mm) : null;
      const off =
        worst === null ? null : `Worst vertex ${deviation(worst, unit)} from ${of === null ? "the" : "its"} design.`;
      return { tone: "fine", what: `${wire} is finished, in ${time(elapsed_s)}`, sub: sub ?? off };
    }
    case "made-before":
      return { tone: "fine", what: `The wire${whose} was finished before`, sub };
    case "sent":
      return {
        tone: "warning",
        what: says(`All ${steps} steps are sent`),
        sub: sub ?? "The machine does not report whether it ran them: look at the wire.",
      };
    case "stopped":
      return {
        tone: "warning",
        what: says(`Stopped after step ${made} of ${steps}`),
        sub: sub ?? "Home the machine, then resume the wire or give it up.",
      };
    case "failed":
      return { tone: "error", what: says(`Failed after step ${made} of ${steps}`), sub };
    case "abandoned":
      return { tone: "info", what: says(`Given up after step ${made} of ${steps}`), sub };
  }
}

/** "Feed 10.0 mm". */
export function movePhrase(move: Move, unit: DisplayUnit): string {
  switch (move.move) {
    case "home":
      return "Home";
    case "feed":
      return `Feed ${length(move.mm, unit)}`;
    case "rotate":
      return `Rotate ${angle(move.deg)}`;
    case "bend":
      return `Bend ${angle(move.deg)}`;
  }
}

/** What is simulated, where that is not what the profile says; null where it is. */
export function simulatedPhrase({ machine, material }: SimulatedAs, name: (id: string) => string): string | null {
  const of = [machine ? `the bend head of ${name(machine)}` : null, material ? `the wire ${material}` : null];
  const others = of.filter((each) => each !== null);
  return others.length > 0 ? `simulated with ${others.join(" and ")}` : null;
}
