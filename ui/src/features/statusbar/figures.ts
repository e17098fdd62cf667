/** The figures of all wires together, as the status bar shows them. */

import type { LiveCheck, RunFileReport, RunFileWire, WireFigures } from "../../generated/responses";
import { errorText } from "../../platform/error_text";
import { count, type DisplayUnit, length, longLength, money, number, time } from "../../shared/figures/format";
import type { Known } from "../../state/design/collisions";
import type { DesignState } from "../../state/design/design";

export interface Figure {
  readonly name: string;
  readonly value: string;
  /** What the name stands for, for those who ask. */
  readonly title: string;
}

/** Null where some wire does not have it: a sum of the others would be a wrong figure. */
function sum(wires: readonly WireFigures[], of: (wire: WireFigures) => number | null): number | null {
  let all = 0;
  for (const wire of wires) {
    const value = of(wire);
    if (value === null) return null;
    all += value;
  }
  return wires.length > 0 ? all : null;
}

/** `drawn`: the length of all edges, mm, each counted once. */
export function figures(check: LiveCheck | null, drawn: number, unit: DisplayUnit): readonly Figure[] {
  const wires = check?.wires ?? [];
  const currencies = new Set(wires.map(({ currency }) => currency));
  const shown = (value: number | null, how: (value: number) => string): string => (value === null ? "–" : how(value));
  const cost = currencies.size === 1 ? sum(wires, (wire) => wire.cost) : null;
  const stockCost = currencies.size === 1 ? sum(wires, (wire) => wire.stock_cost) : null;
  const routed = sum(wires, (wire) => wire.length_mm);
  const several = wires.length > 1 ? ` of all ${wires.length} wires` : "";
  return [
    routed === null && drawn > 0
      ? {
          name: "Wire",
          value: `≥ ${length(drawn, unit)}`,
          title: "Every edge once. Doubled edges are added once there is a wire",
        }
      : {
          name: "Wire",
          value: shown(routed, (mm) => length(mm, unit)),
          title: `Designed length${several}, doubled edges counted twice`,
        },
    {
      name: "Stock",
      value: shown(
        sum(wires, (wire) => wire.stock_mm),
        (mm) => longLength(mm, unit),
      ),
      title: `Wire to load${several}: all feeds and the unusable tail`,
    },
    {
      name: "Bends",
      value: shown(
        sum(wires, (wire) => wire.bends),
        (many) => number(many, 0),
      ),
      title: `Bends${several}`,
    },
    {
      name: "Time",
      value: shown(
        sum(wires, (wire) => wire.time_s),
        time,
      ),
      title: `Estimated time on the machine${several}`,
    },
    {
      name: "Cost",
      // What a person pays for, as in the fixes and the comparison of machines.
      value: shown(stockCost, (value) => money(value, wires[0]?.currency ?? null)),
      title: `Price of the stock to load${several}, with the unusable tail. Wire in the part: ${shown(cost, (value) => money(value, wires[0]?.currency ?? null))}`,
    },
  ];
}

/** The same of a file that is run instead of the design, as far as it is known of it. */
export function figuresOfFile(
  { wires, kind }: Pick<RunFileReport, "wires" | "kind">,
  unit: DisplayUnit,
): readonly Figure[] {
  const all = (of: (wire: RunFileWire) => number) => wires.reduce((sum, wire) => sum + of(wire), 0);
  const length_mm = all((wire) => wire.length_mm);
  const figure = (name: string, value: string, title: string): Figure => ({ name, value, title });
  return [
    figure("Wire", length(length_mm, unit), "Wire that the file feeds"),
    // How much is loaded for recorded moves is not said in them.
    ...(kind === "moves"
      ? []
      : [
          figure(
            "Stock",
            longLength(
              all(({ stock_mm }) => stock_mm),
              unit,
            ),
            "Wire to load: all feeds and the unusable tail",
          ),
          figure("Time", time(all(({ time_s }) => time_s)), "Estimated time on the machine"),
        ]),
  ];
}

/** What the checks say of that file. */
export function checksOfFile({
  findings,
  notes,
  feasible,
  kind,
}: Pick<RunFileReport, "findings" | "notes" | "feasible" | "kind">): ReturnType<typeof checksPhrase> {
  if (kind === "moves") return null;
  const of = (wanted: string) => findings.filter(({ severity }) => severity === wanted).length;
  const [errors, warnings] = [of("error"), of("warning") + notes.length];
  if (errors > 0) return { text: `${count(errors, "error")} in the file`, tone: "error" };
  if (!feasible) return { text: "not feasible", tone: "error" };
  if (warnings > 0) return { text: count(warnings, "warning"), tone: "warning" };
  // What a job hits is looked for when it is armed.
  return { text: kind === "program" ? FINE.checked : FINE.unchecked, tone: "fine" };
}

/** Whether everything is kept in a file; a warning where even what is not saved cannot be kept safe. */
export function savedPhrase(state: DesignState | null): { readonly text: string; readonly warning: string | null } {
  if (!state) return { text: "", warning: null };
  const text = state.changed ? "unsaved changes" : state.file === null ? "not saved yet" : "saved";
  return { text, warning: state.unkept ? errorText(state.unkept) : null };
}

/** Of a design that is within the machine's limits. As short as a warning is: the place of it is as wide for all. */
const FINE: Readonly<Record<Known, string>> = {
  checked: "no collision found",
  checking: "checking collisions",
  unchecked: "collisions not checked",
};

/** "3 to fix", "2 warnings", "no collision found"; null before the first answer. */
export function checksPhrase(
  check: LiveCheck | null,
  collisions: Known,
): { readonly text: string; readonly tone: "error" | "warning" | "fine" } | null {
  if (!check) return null;
  const of = (severity: string) => check.diagnostics.filter((diagnostic) => diagnostic.severity === severity).length;
  const [errors, warnings] = [of("error"), of("warning")];
  if (errors > 0) return { text: `${errors} to fix`, tone: "error" };
  if (!check.feasible) return { text: "not feasible", tone: "error" };
  if (warnings > 0) return { text: `${count(warnings, "warning")}`, tone: "warning" };
  return { text: FINE[collisions], tone: "fine" };
}

/** What long work is called, by what was asked for. */
const ASKS: Readonly<Record<string, string>> = {
  program: "Generating the program",
  made: "Bending on the simulated machine",
  compare: "Comparing machines",
  exports: "Listing export formats",
  export: "Preparing the file",
  "save-wireframe": "Writing the wireframe",
  "save-job": "Writing the job",
  open: "Opening",
  look: "Reading",
  "open-example": "Opening",
  "put-stencil": "Reading the stencil",
  "put-wireframe": "Reading the wireframe",
  drivers: "Loading drivers",
  "machine-view": "Loading the driver",
  fixes: "Searching for fixes",
  collisions: "Checking for collisions",
  "avoid-collisions": "Searching for an order of the bends",
  ports: "Looking for ports",
  order: "Reading the machine",
  connect: "Connecting",
};

export const workPhrase = (ask: string, stage: string): string => ASKS[ask] ?? (stage === "" ? ask : stage);
