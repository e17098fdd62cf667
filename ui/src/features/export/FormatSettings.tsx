import type { FormatEntry } from "../../generated/responses";
import { Button } from "../../shared/controls/Button";
import { Fold } from "../../shared/controls/Fold";
import { count } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { useDesign } from "../../state/design/design";
import { asSet, setSettings, settingsOf, useExports } from "../../state/files/exports";
import { useMachines } from "../../state/machine/machines";
import { SettingsForm } from "../machine/settings/SettingsForm";
import { changedKeys } from "../machine/settings/values";

/** What can be set for this one export, over what the machine's profile says. */
export function FormatSettings({ format }: { readonly format: FormatEntry }) {
  const settings = useExports((store) => store.settings);
  const unit = useUnit();
  const machine = useDesign((design) => design.state?.machine ?? null);
  const driver = useMachines((machines) => machines.machines?.find(({ id }) => id === machine)?.driver ?? null);
  // The generated type does not say that some formats have nothing to set.
  const schema = format.settings_schema as { readonly properties?: object } | null;
  const fields = Object.keys(schema?.properties ?? {}).length;
  if (!schema || fields === 0) return null;
  const values = settingsOf(format, settings, unit);
  const unset = settingsOf(format, new Map(), unit);
  const own = settings.has(format.id);
  const changed = own ? changedKeys(withDefaults(schema, unset), withDefaults(schema, values)).length : 0;
  // The driver of the machine has one set for everything: it does not say which of them are about the text.
  const ofMachine = format.driver !== null && format.driver === driver;
  const title = ofMachine ? `All settings of the driver (${fields})` : "Settings of this export";
  const changes = count(changed, "change");
  const phrase = ofMachine
    ? changed > 0
      ? changes
      : ""
    : changed > 0
      ? `${changes} from the profile`
      : count(fields, "setting");
  return (
    <Fold key={format.id} title={title} phrase={phrase}>
      {ofMachine && (
        <p className="muted small">
          These values come from the machine's profile. Changes here apply to this file only.
        </p>
      )}
      <SettingsForm
        idPrefix={`export-${format.id}`}
        schema={schema}
        values={values}
        onChange={(changedTo) => setSettings(format.id, asSet(format, changedTo, unit))}
      />
      {changed > 0 && (
        <div className="row end">
          <Button onClick={() => setSettings(format.id, format.settings)}>Reset to profile</Button>
        </div>
      )}
    </Fold>
  );
}

/** What is not set has the default of the schema. */
function withDefaults(
  schema: { readonly properties?: object },
  values: Readonly<Record<string, unknown>>,
): Readonly<Record<string, unknown>> {
  const all = Object.entries(schema.properties ?? {}).flatMap(([key, property]: [string, unknown]) => {
    const given =
      typeof property === "object" && property !== null && "default" in property ? property.default : undefined;
    return given === undefined ? [] : [[key, given] as const];
  });
  return { ...Object.fromEntries(all), ...values };
}
