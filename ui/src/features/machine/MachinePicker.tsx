import { useCallback, useEffect, useRef, useState } from "react";
import { Icon } from "../../shared/icons";
import { Popover } from "../../shared/Popover";
import { useDesign } from "../../state/design";
import { needMachines, stopComparing, useMachines } from "../../state/machines";
import { MachineList } from "./MachineList";
import "./machine.css";

/** The machine of the design, always in sight; opens the list of all. */
export function MachinePicker() {
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const id = useDesign((design) => design.state?.machine ?? null);
  const machines = useMachines((store) => store.machines);
  useEffect(needMachines, []);
  useEffect(() => setOpen(false), [id]);
  const close = useCallback(() => {
    setOpen(false);
    stopComparing();
  }, []);
  const name = machines?.find((machine) => machine.id === id)?.name ?? id ?? "none";
  return (
    <>
      <button ref={button} type="button" className="picker" aria-haspopup="dialog" aria-expanded={open} title={`Machine: ${name}`} onClick={() => (open ? close() : setOpen(true))}>
        <span className="muted">Machine:</span>
        <span className="ellipsis">{name}</span>
        <Icon name="down" size={12} />
      </button>
      {open && (
        <Popover anchor={button} label="Machine" onClose={close} width={400}>
          <MachineList place="bar" />
        </Popover>
      )}
    </>
  );
}
