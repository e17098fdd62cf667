import { useState } from "react";
import type { MachineViewResponse } from "../../../generated/responses";
import { platform } from "../../../platform";
import { Button } from "../../../shared/controls/Button";
import { Field } from "../../../shared/controls/Field";
import { TextInput } from "../../../shared/controls/inputs";
import { told } from "../../../state/asking/problems";
import { useDesign } from "../../../state/design/design";
import { profilesChanged, switchTo, useMachines } from "../../../state/machine/machines";
import { slugOf, slugProblem } from "./slug";

/** A profile of one's own that inherits from a machine; the design takes it. */
export function CopyMachine({ view, onDone }: { readonly view: MachineViewResponse; readonly onDone: () => void }) {
  const [name, setName] = useState(`My ${view.name}`);
  const [typed, setTyped] = useState<string | null>(null);
  const [busy, setBusy] = useState(false);
  const machines = useMachines((store) => store.machines);
  const material = useDesign((design) => design.state?.material ?? null);
  const id = typed ?? slugOf(name);
  const wrong = slugProblem(
    id,
    (machines ?? []).map((machine) => machine.id),
  );
  const make = async () => {
    setBusy(true);
    const made = await told(platform.ask("copy-machine", { machine: view.id, id, name: name.trim() }));
    setBusy(false);
    if (!made) return;
    profilesChanged(null);
    // It has the same figures, so that there is nothing to compare.
    await switchTo(made.id, material);
    onDone();
  };
  const why = name.trim() === "" ? "Enter a name." : (wrong ?? (busy ? "The file is being written." : null));
  return (
    <form
      className="inset stack"
      onSubmit={(event) => {
        event.preventDefault();
        if (!why) void make();
      }}
    >
      <Field label="Name">
        {(ids) => (
          <TextInput
            {...ids}
            value={name}
            autoFocus
            onFocus={(event) => event.currentTarget.select()}
            onChange={(event) => setName(event.currentTarget.value)}
          />
        )}
      </Field>
      <Field label="Id" hint="Also the name of its file." error={wrong}>
        {(ids) => <TextInput {...ids} value={id} onChange={(event) => setTyped(event.currentTarget.value)} />}
      </Field>
      <p className="muted small">
        It has all figures of {view.name}, and those that you change. The design takes it as its machine.
      </p>
      <div className="row end">
        <Button onClick={onDone}>Cancel</Button>
        <Button kind="primary" type="submit" why={why}>
          Copy
        </Button>
      </div>
    </form>
  );
}
