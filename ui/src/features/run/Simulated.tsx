import type { SimulatedAs } from "../../generated/requests";
import { Field } from "../../shared/controls/Field";
import { Fold } from "../../shared/controls/Fold";
import { Select } from "../../shared/controls/inputs";
import { useMachines } from "../../state/machine/machines";

/** What the simulated machine has instead of what its profile says: no real machine is exactly as its profile says either. */
export function Simulated({
  machine,
  as,
  onChoose,
}: {
  readonly machine: string;
  readonly as: SimulatedAs;
  readonly onChoose: (as: SimulatedAs) => void;
}) {
  const { machines, materials } = useMachines();
  const others = (machines ?? []).filter(({ id, has_peg }) => has_peg && id !== machine);
  const own = { value: "", label: "as in the profile" };
  const changed = [as.machine, as.material].filter(Boolean).length;
  return (
    <Fold title="Simulate another bender" phrase={changed > 0 ? "not as in the profile" : ""}>
      <p className="muted small">
        To try a calibration: the program is still planned for the machine and wire of the design.
      </p>
      <Field label="Bend head" hint="Its dimensions are those of another profile.">
        {(ids) => (
          <Select
            {...ids}
            value={as.machine ?? ""}
            choices={[own, ...others.map(({ id, name }) => ({ value: id, label: name }))]}
            onChoose={(id) => onChoose({ ...as, machine: id || null })}
          />
        )}
      </Field>
      <Field label="Wire" hint="Diameter, strength and K-factor. It springs back as its strength says.">
        {(ids) => (
          <Select
            {...ids}
            value={as.material ?? ""}
            choices={[own, ...(materials ?? []).map(({ id, name }) => ({ value: id, label: name }))]}
            onChoose={(id) => onChoose({ ...as, material: id || null })}
          />
        )}
      </Field>
    </Fold>
  );
}
