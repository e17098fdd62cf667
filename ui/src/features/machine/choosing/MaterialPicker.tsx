import { useEffect, useState } from "react";
import { Icon } from "../../../shared/controls/icons";
import { useUnit } from "../../../shared/figures/unit";
import { Popover } from "../../../shared/layers/Popover";
import { useDesign } from "../../../state/design/design";
import { needMachines, useMachines } from "../../../state/machine/machines";
import { misfit } from "./fit";
import { Materials } from "./Materials";
import "../machine.css";

/** The wire in the machine, always in sight; opens the list of all. */
export function MaterialPicker() {
  const [open, setOpen] = useState(false);
  const unit = useUnit();
  const state = useDesign((design) => design.state);
  const { machines, materials } = useMachines();
  useEffect(needMachines, []);
  const material = materials?.find(({ id }) => id === state?.material);
  const wrong = material ? misfit(material, machines?.find(({ id }) => id === state?.machine) ?? null, unit) : null;
  const name = material?.name ?? state?.material ?? "no wire";
  return (
    <Popover
      label="Wire"
      width={360}
      open={open}
      onOpenChange={setOpen}
      button={
        <button type="button" className="picker" title={wrong ? `${name}: ${wrong}` : `Wire: ${name}`}>
          {wrong && (
            <span className="choice-wrong">
              <Icon name="warning" />
            </span>
          )}
          <span className="ellipsis">{name}</span>
          <Icon name="down" size={12} />
        </button>
      }
    >
      <Materials onDone={() => setOpen(false)} />
    </Popover>
  );
}
