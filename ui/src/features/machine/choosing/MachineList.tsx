import { useEffect } from "react";
import type { MachineEntry } from "../../../generated/responses";
import { errorText } from "../../../platform/error_text";
import { Icon } from "../../../shared/controls/icons";
import { number } from "../../../shared/figures/format";
import { useLengths } from "../../../shared/figures/unit";
import { useDesign } from "../../../state/design/design";
import { type ComparedIn, compareWith, stopComparing, useMachines, viewOf } from "../../../state/machine/machines";
import { MachinePicture } from "../picture/MachinePicture";
import { Comparison } from "./Comparison";
import { besideBend, leastLength } from "./fit";

/** "±155°" where both sides are the same. */
export function range([low, high]: readonly [number, number]): string {
  const one = (deg: number) => number(deg, Number.isInteger(deg) ? 0 : 1);
  return low === -high ? `±${one(high)}°` : `${one(low)}° to ${one(high)}°`;
}

/** The profiles as cards; choosing one shows what it would change. */
export function MachineList({ place }: { readonly place: ComparedIn }) {
  const machines = useMachines((store) => store.machines);
  const compared = useMachines((store) => (store.compared?.asked === place ? store.compared.machine : null));
  const own = useDesign((design) => design.state?.machine ?? null);
  if (!machines) return <p className="muted">Loading machines…</p>;
  return (
    <ul className="machine-list">
      {machines.map((machine) => (
        <li key={machine.id}>
          <MachineCard machine={machine} place={place} own={machine.id === own} compared={machine.id === compared} />
          {machine.id === compared && <Comparison />}
        </li>
      ))}
    </ul>
  );
}

function MachineCard({
  machine,
  place,
  own,
  compared,
}: {
  readonly machine: MachineEntry;
  readonly place: ComparedIn;
  readonly own: boolean;
  readonly compared: boolean;
}) {
  const view = useMachines((store) => store.views.get(machine.id) ?? null);
  const { bare, name, unit } = useLengths();
  // biome-ignore lint/correctness/useExhaustiveDependencies: what was known of it is dropped when profiles change
  useEffect(() => {
    // A driver that cannot be asked is reported with the machine itself.
    viewOf(machine.id).catch(() => {});
  }, [machine, view]);
  const [thin, thick] = machine.diameter_mm;
  return (
    <button
      type="button"
      className={own ? "machine-card own" : "machine-card"}
      aria-pressed={own}
      aria-expanded={own ? undefined : compared}
      onClick={() => (compared ? stopComparing() : void compareWith(machine.id, place))}
    >
      <MachinePicture shapes={view?.shapes ?? null} name={machine.name} />
      <span className="machine-card-text">
        <span className="machine-card-name">{machine.name}</span>
        <span className="muted small">
          bend {range(machine.bend_deg)} · edge ≥ {leastLength(machine.min_edge_mm, unit)}
          {besideBend(view, unit)}
        </span>
        <span className="muted small">
          wire {bare(thin)} to {bare(thick)} {name}
          {machine.shipped ? "" : " · yours"}
        </span>
        {own && (
          <span className="machine-card-own small">
            <Icon name="check" size={12} /> this machine
          </span>
        )}
        {view?.driver_problem && (
          <span className="machine-card-problem small">
            <Icon name="warning" size={12} /> {errorText(view.driver_problem)}
          </span>
        )}
      </span>
    </button>
  );
}
