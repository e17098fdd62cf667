import { useCallback, useEffect, useRef, useState } from "react";
import { Icon } from "../../shared/icons";
import { Popover } from "../../shared/Popover";
import { useUnit } from "../../shared/unit";
import { useDesign } from "../../state/design";
import { needMachines, useMachines } from "../../state/machines";
import { misfit } from "./fit";
import { Materials } from "./Materials";
import "./machine.css";

/** The wire in the machine, always in sight; opens the list of all. */
export function MaterialPicker() {
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const unit = useUnit();
  const state = useDesign((design) => design.state);
  const { machines, materials } = useMachines();
  useEffect(needMachines, []);
  const close = useCallback(() => setOpen(false), []);
  const material = materials?.find(({ id }) => id === state?.material);
  const wrong = material ? misfit(material, machines?.find(({ id }) => id === state?.machine) ?? null, unit) : null;
  const name = material?.name ?? state?.material ?? "no wire";
  return (
    <>
      <button ref={button} type="button" className="picker" aria-haspopup="dialog" aria-expanded={open} title={wrong ? `${name}: ${wrong}` : `Wire: ${name}`} onClick={() => setOpen(!open)}>
        {wrong && (
          <span className="choice-wrong">
            <Icon name="warning" />
          </span>
        )}
        <span className="ellipsis">{name}</span>
        <Icon name="down" size={12} />
      </button>
      {open && (
        <Popover anchor={button} label="Wire" onClose={close} width={360}>
          <Materials onDone={close} />
        </Popover>
      )}
    </>
  );
}
