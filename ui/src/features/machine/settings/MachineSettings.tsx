import { useMemo, useState } from "react";
import type { MachineViewResponse } from "../../../generated/responses";
import { platform } from "../../../platform";
import { Button } from "../../../shared/controls/Button";
import { count } from "../../../shared/figures/format";
import { Line } from "../../../shared/lists/Line";
import { profilesChanged } from "../../../state/machine/machines";
import { SettingsForm } from "./SettingsForm";
import { changedKeys, ownKeys, sourceOf, sourcePhrase, toWrite, type Values, valuesOf } from "./values";

/** The settings of a machine's driver. Those of a profile that comes with the program are only shown. */
export function MachineSettings({ view }: { readonly view: MachineViewResponse }) {
  const before = useMemo(() => valuesOf(view.settings), [view]);
  const own = useMemo(() => ownKeys(view.settings, view.id), [view]);
  const [edited, setEdited] = useState<Values | null>(null);
  const [busy, setBusy] = useState(false);
  const [problem, setProblem] = useState<string | null>(null);
  const after = edited ?? before;
  const changed = new Set(changedKeys(before, after));
  // The generated type does not say that a driver that cannot be asked has none.
  const schema = view.settings_schema as object | null;
  if (!schema) return <p className="muted">The driver does not list its settings.</p>;
  const write = async (settings: Values) => {
    setBusy(true);
    setProblem(null);
    try {
      const { machine } = await platform.ask("change-settings", { machine: view.id, settings: { ...settings } });
      setEdited(null);
      profilesChanged(machine);
    } catch (error) {
      setProblem(error instanceof Error ? error.message : String(error));
    } finally {
      setBusy(false);
    }
  };
  const belowOf = (key: string) => ({
    phrase: changed.has(key) ? "changed, not saved" : sourcePhrase(sourceOf(view.settings, key), view.id),
    changed: changed.has(key),
    back: own.has(key) && !changed.has(key) && !busy && !view.shipped,
  });
  const below = Object.fromEntries(Object.keys(after).map((key) => [key, belowOf(key)]));
  const busyWhy = busy ? "The profile is being written." : null;
  return (
    <div className="stack">
      {view.shipped && (
        <p className="muted">
          This profile comes with the program and is read-only. Copy it to your profiles to adapt it to your machine.
        </p>
      )}
      <SettingsForm
        idPrefix={`machine-${view.id}`}
        schema={schema}
        values={after}
        onChange={setEdited}
        why={view.shipped ? "This profile comes with the program. Copy it to your profiles first." : null}
        below={below}
        onBack={(key) => void write(toWrite(before, before, own, key))}
      />
      {!view.shipped && (
        <div className="settings-save stack">
          {problem && (
            // biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, also by keys
            <div role="alert" className="settings-problem" tabIndex={0}>
              <ul>
                <Line tone="error" what="The settings were not saved" sub={problem} />
              </ul>
            </div>
          )}
          <div className="row end">
            <span className="grow muted" aria-live="polite">
              {changed.size > 0 ? `${count(changed.size, "change")} not saved` : ""}
            </span>
            <Button
              why={busyWhy ?? (changed.size === 0 ? "Nothing changed." : null)}
              onClick={() => {
                setEdited(null);
                setProblem(null);
              }}
            >
              Revert
            </Button>
            <Button
              kind="primary"
              why={busyWhy ?? (changed.size === 0 ? "Nothing changed." : null)}
              onClick={() => void write(toWrite(before, after, own))}
            >
              Save
            </Button>
          </div>
        </div>
      )}
    </div>
  );
}
