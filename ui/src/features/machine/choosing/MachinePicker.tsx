import { useEffect } from "react";
import { Icon } from "../../../shared/controls/icons";
import { Popover } from "../../../shared/layers/Popover";
import { useDesign } from "../../../state/design/design";
import { needMachines, stopComparing, useMachines } from "../../../state/machine/machines";
import { useUi } from "../../../state/window/ui";
import { MachineList } from "./MachineList";
import "../machine.css";

/** The machine of the design, always in sight; opens the list of all. */
export function MachinePicker() {
  // *Export* opens it too.
  const open = useUi((ui) => ui.choosingMachine);
  const setOpen = useUi((ui) => ui.chooseMachine);
  const id = useDesign((design) => design.state?.machine ?? null);
  const machines = useMachines((store) => store.machines);
  useEffect(needMachines, []);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the machine that was chosen closes the list
  useEffect(() => setOpen(false), [id]);
  const change = (opens: boolean) => {
    setOpen(opens);
    if (!opens) stopComparing();
  };
  const name = machines?.find((machine) => machine.id === id)?.name ?? id ?? "none";
  return (
    <Popover
      label="Machine"
      width={400}
      open={open}
      onOpenChange={change}
      button={
        <button type="button" className="picker" title={`Machine: ${name}`}>
          <span className="muted">Machine:</span>
          <span className="ellipsis">{name}</span>
          <Icon name="down" size={12} />
        </button>
      }
    >
      <MachineList place="bar" />
    </Popover>
  );
}
