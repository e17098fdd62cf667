import { create } from "zustand";
import type {
  CompareResponse,
  DriversResponse,
  MachineEntry,
  MachineViewResponse,
  MaterialEntry,
  OtherSide,
} from "../../generated/responses";
import { platform } from "../../platform";
import { told } from "../asking/problems";
import { asking } from "../asking/work";
import { checkDesign, edit, useDesign } from "../design/design";

interface MachinesStore {
  /** Null before they are known. */
  readonly machines: readonly MachineEntry[] | null;
  readonly materials: readonly MaterialEntry[] | null;
  readonly drivers: DriversResponse | null;
  /** What is known of single machines, by id. */
  readonly views: ReadonlyMap<string, MachineViewResponse>;
  /** The machine that the person looks at, which need not be that of the design. */
  readonly compared: Compared | null;
  /** How often profiles or drivers have changed while the window was open. */
  readonly changes: number;
}

/** Where machines are compared: in the panel, or in the list of the top bar. */
export type ComparedIn = "panel" | "bar";

/** Another machine for the design. */
export interface Compared {
  /** Its id. */
  readonly machine: string;
  /** Where the person has asked: there the answer is shown. */
  readonly asked: ComparedIn;
  /** Null while the answer is on its way, and where it cannot be had: see `problem`. */
  readonly from: CompareResponse["from"] | null;
  readonly to: OtherSide | null;
  readonly problem: string | null;
}

export const useMachines = create<MachinesStore>()(() => ({
  machines: null,
  materials: null,
  drivers: null,
  views: new Map(),
  compared: null,
  changes: 0,
}));

/** Asks for machines and materials; both are few. */
async function loadMachines(): Promise<void> {
  const [machines, materials] = await Promise.all([
    told(platform.ask("machines", {})),
    told(platform.ask("materials", {})),
  ]);
  if (machines) useMachines.setState({ machines: machines.machines });
  if (materials) useMachines.setState({ materials: materials.materials });
}

let needed: Promise<void> | null = null;

/** The same, once: many parts of the window need them. */
export function needMachines(): void {
  const { machines, materials } = useMachines.getState();
  if (machines && materials) return;
  needed ??= loadMachines().finally(() => (needed = null));
}

/** Of a wire, mm; null where it is not known. */
export function diameterOf(material: string | null | undefined): number | null {
  return useMachines.getState().materials?.find(({ id }) => id === material)?.diameter_mm ?? null;
}

export async function loadDrivers(): Promise<void> {
  const drivers = await told(asking("drivers", {}));
  if (drivers) useMachines.setState({ drivers });
}

/** What is known of a machine. Rejects as `platform.ask` does. */
export async function viewOf(machine: string): Promise<MachineViewResponse> {
  const known = useMachines.getState().views.get(machine);
  if (known) return known;
  const { changes } = useMachines.getState();
  const view = await asking("machine-view", { machine });
  // What was asked before a profile changed is not kept.
  if (useMachines.getState().changes === changes) keepView(view);
  return view;
}

function keepView(view: MachineViewResponse): void {
  useMachines.setState(({ views }) => ({ views: new Map(views).set(view.id, view) }));
}

/** Profiles or drivers have changed: what is known of them is asked anew. */
export function profilesChanged(view: MachineViewResponse | null): void {
  useMachines.setState(({ changes }) => ({ changes: changes + 1, views: new Map(view ? [[view.id, view]] : []) }));
  void loadMachines();
  checkDesign();
}

/** Whether there is anything that another machine could make otherwise. */
const isDesigned = (): boolean => useDesign.getState().edges.size > 0;

/** Of several comparisons only the last one's answer counts. */
let comparisons = 0;

/**
 * Looks at another machine: what becomes feasible with the design, and what does not any more. An empty design has nothing to
 * compare and takes the machine at once.
 */
export async function compareWith(machine: string, asked: ComparedIn): Promise<void> {
  const { state } = useDesign.getState();
  if (machine === state?.machine) return stopComparing();
  if (!isDesigned() || !state?.machine) {
    await switchTo(machine, null);
    return;
  }
  let compared: Compared = { machine, asked, from: null, to: null, problem: null };
  comparisons += 1;
  const comparison = comparisons;
  useMachines.setState({ compared });
  try {
    const { from, to } = await asking("compare", { against: [machine] });
    compared = { ...compared, from, to: to[0] ?? null };
  } catch (error) {
    compared = { ...compared, problem: error instanceof Error ? error.message : String(error) };
  }
  if (comparison === comparisons) useMachines.setState({ compared });
}

export function stopComparing(): void {
  comparisons += 1;
  if (useMachines.getState().compared) useMachines.setState({ compared: null });
}

/** Gives the design another machine: one change, which can be undone. `material` null: the machine's own. */
export async function switchTo(machine: string, material: string | null): Promise<boolean> {
  const change = await edit({ edit: "machine", machine, material });
  if (change) stopComparing();
  return change !== null;
}

/** Gives the design another wire. */
export async function chooseMaterial(material: string): Promise<void> {
  const machine = useDesign.getState().state?.machine;
  if (machine) await switchTo(machine, material);
}
