/** What is armed next, and why it cannot be. */

import { useDesign } from "../../state/design/design";
import type { MachineState } from "../../state/machine/operator";
import { setAccepted, setWanted, useRow } from "../../state/machine/row";
import { order, saidOf } from "../../state/machine/run";
import { useRunFile } from "../../state/program/run_file";
import { buttons, type RunButtons } from "./buttons";
import { useProspect } from "./prospect";

interface NextWire {
  readonly length_mm: number | null;
  readonly stock_mm?: number | null;
}

export interface Arming {
  readonly all: RunButtons;
  readonly wires: readonly NextWire[];
  /** The one that is armed next; null for all, one after the other. */
  readonly wire: number | null;
  /** Whether the machine cuts each piece off. */
  readonly cuts: boolean;
  /** How much farther the wire is fed for that, to a cutter outside of the machine, mm. */
  readonly beyondMm: number;
  /** The machine cannot make it, which a person may accept. */
  readonly refused: boolean;
  /** A person has accepted that. */
  readonly anyway: boolean;
  readonly setAnyway: (on: boolean) => void;
  /** A person has accepted that the machine is set otherwise than its profile says. */
  readonly accept: boolean;
  readonly setAccept: (on: boolean) => void;
  /** Why it cannot be armed. */
  readonly why: string | null;
  readonly arm: () => void;
  /** Why there can be no dry run. */
  readonly whyNotDry: string | null;
  readonly dryRun: () => void;
}

const NONE: readonly NextWire[] = [];

/** The wires of the design, or of the file that is run. */
export function useArming(state: MachineState): Arming {
  const designed = useDesign((design) => design.check?.wires ?? NONE);
  const version = useDesign((design) => design.version);
  const file = useRunFile((run) => run.file);
  const { wire: chosen, rest, pieces, stockMm, cut, accepted, wanted } = useRow();
  const prospect = useProspect();
  const all = buttons(state, prospect);
  const wires = file ? file.wires : designed;
  const asked = rest[0] ?? chosen;
  const wire = wires.length > 1 ? (asked !== null && asked < wires.length ? asked : null) : 0;
  const said = saidOf(state);
  const accept = accepted !== null && accepted === said;
  const needsAccept =
    state.settings.some(({ matters }) => matters) && !accept
      ? "The machine is set otherwise than its profile says: see below."
      : null;
  // What a person wants all the same is this design, not what it becomes.
  const anyway = wanted !== null && wanted.version === version && wanted.file === file;
  // What the machine cannot make is armed where a person wants it all the same.
  const refused = prospect.program && !prospect.feasible && (file ? file.kind === "program" : wires.length > 0);
  const despite = (why: string | null) => refused && anyway && why === all.noWire;
  const why = (order: string | null) => (despite(order) ? null : order) ?? needsAccept;
  const cuts = cut && state.cutter_mm !== null;
  return {
    all,
    wires,
    wire,
    cuts,
    beyondMm: cuts ? Math.max(state.cutter_mm ?? 0, 0) : 0,
    refused,
    anyway,
    setAnyway: (on) => setWanted(on ? { version, file } : null),
    accept,
    setAccept: (on) => setAccepted(on ? said : null),
    why: why(all.arm),
    arm: () =>
      void order({
        order: "arm",
        wire,
        accept_settings: accept,
        despite_errors: despite(all.arm),
        repeat: {
          // The rest of a piece is bent once.
          pieces: rest.length > 0 ? 1 : pieces,
          stock_mm: stockMm,
          cut: cuts,
        },
      }),
    whyNotDry: why(all.dryRun) ?? (wire === null ? "Choose one of the wires." : null),
    dryRun: () =>
      void order({
        order: "dry-run",
        wire: wire ?? 0,
        accept_settings: accept,
        despite_errors: despite(all.dryRun),
      }),
  };
}
