import type { SagReport } from "../../generated/responses";
import { Field } from "../../shared/controls/Field";
import { Fold } from "../../shared/controls/Fold";
import { Checkbox } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { type DisplayUnit, length } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { editAsItIs, useDesign } from "../../state/design/design";
import { useRunFile } from "../../state/program/run_file";

/** How collisions are looked for. */
export function CollisionSettings() {
  const unit = useUnit();
  const state = useDesign((design) => design.state);
  const check = useDesign((design) => design.check);
  // A file that is run has its own.
  const file = useRunFile((run) => run.file);
  if (!state || file) return null;
  const { clearance_mm, sag } = state.collisions;
  // Those with a program, as the player counts them.
  const wires = check?.wires.filter(({ bends }) => bends !== null) ?? [];
  const clear = clearance_mm > 0 ? length(clearance_mm, unit) : null;
  const phrase = [clear && `${clear} clear`, sag && "with sag"].filter(Boolean).join(", ") || "no clearance";
  // A clearance that was typed just before the other is chosen is not there yet.
  const set = (change: { readonly clearance_mm?: number; readonly sag?: boolean }) =>
    void editAsItIs((design) => design.state && { edit: "collisions", ...design.state.collisions, ...change });
  return (
    <Fold title="Collision settings" phrase={phrase}>
      <Field label="Clearance" hint="What comes nearer than this without hitting is named too">
        {(ids) => (
          <NumberField
            {...ids}
            label="Clearance"
            value={clearance_mm}
            min={0}
            onCommit={(mm) => set({ clearance_mm: mm })}
          />
        )}
      </Field>
      <Checkbox checked={sag} onChange={(on) => set({ sag: on })}>
        Let the part sag under its own weight
      </Checkbox>
      {wires.map(({ sag: found }, index) => {
        const name = wires.length > 1 ? `Wire ${index + 1}: its` : "Its";
        // biome-ignore lint/suspicious/noArrayIndexKey: wires have no other name
        return found && <p key={index} className="muted small">{`${name} ${sagOf(found, unit)}`}</p>;
      })}
    </Fold>
  );
}

/** How far a part sags, steps counted from 1. */
function sagOf({ deflection_mm, step, joint }: SagReport, unit: DisplayUnit): string {
  const most = `free end sags by up to ${length(deflection_mm, unit)}, in step ${step + 1}.`;
  if (!joint) return most;
  return `${most} It is ${length(joint.off_mm, unit)} off where step ${joint.step + 1} comes back to vertex ${joint.vertex}.`;
}
