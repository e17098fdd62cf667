import { useEffect } from "react";
import { Button } from "../../shared/controls/Button";
import { Fold } from "../../shared/controls/Fold";
import { count } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { useDesign } from "../../state/design/design";
import { needMachines, useMachines } from "../../state/machine/machines";
import { openProfile } from "../../state/machine/profile";
import { Section } from "../panel/Section";
import { CalibrationDialog } from "./calibrate/CalibrationDialog";
import { misfit } from "./choosing/fit";
import { MachineList } from "./choosing/MachineList";
import { Materials } from "./choosing/Materials";
import { Drivers, waits } from "./drivers/Drivers";
import { ImportProfile } from "./profile/ImportProfile";
import { ThisMachine } from "./profile/ThisMachine";
import "./machine.css";

/** Machine, wire, settings, drivers. */
export function MachineSection() {
  const { machine, material } = useDesign((design) => design.state) ?? { machine: null, material: null };
  const { machines, materials, views, drivers } = useMachines();
  const waiting = drivers?.drivers.filter(waits).length ?? 0;
  const unit = useUnit();
  useEffect(needMachines, []);
  const entry = machines?.find(({ id }) => id === machine) ?? null;
  const wire = materials?.find(({ id }) => id === material) ?? null;
  const name = entry?.name ?? machine ?? "none chosen";
  const wrong = wire ? misfit(wire, entry, unit) : null;
  const problem = machine ? (views.get(machine)?.driver_problem ?? null) : null;
  return (
    <Section
      id="machine"
      title="Machine"
      phrase={problem ? `${name}: driver cannot be used` : wrong ? `${name}: wire does not fit` : name}
      tone={problem ? "error" : wrong ? "warning" : null}
    >
      <Fold title="Machines" phrase={machines ? `${machines.length} to choose from` : ""} start>
        <MachineList place="panel" />
        <ImportProfile />
      </Fold>
      {machine && (
        <Fold title="This machine" phrase={name}>
          <ThisMachine id={machine} />
        </Fold>
      )}
      <Fold title="Wire" phrase={wire?.name ?? material ?? "none chosen"}>
        <Materials />
        {material && (
          <div className="row wrap">
            <Button onClick={() => void openProfile("material", material)}>
              {wire?.shipped === false ? "Edit this wire…" : "Values of this wire…"}
            </Button>
          </div>
        )}
      </Fold>
      <Fold
        title="Drivers"
        phrase={waiting > 0 ? `${waiting} not accepted` : drivers ? count(drivers.drivers.length, "driver") : ""}
      >
        <Drivers />
      </Fold>
      <CalibrationDialog />
    </Section>
  );
}
