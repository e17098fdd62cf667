import { useState } from "react";
import { platform } from "../../../platform";
import { Button } from "../../../shared/controls/Button";
import { Field } from "../../../shared/controls/Field";
import { TextInput } from "../../../shared/controls/inputs";
import { told } from "../../../state/asking/problems";
import { useDesign } from "../../../state/design/design";
import { chooseMaterial, profilesChanged, switchTo, useMachines } from "../../../state/machine/machines";
import type { ProfileKind } from "../../../state/machine/profile";
import { slugOf, slugProblem } from "./slug";

/** A profile of one's own that inherits from another; the design takes it. */
export function CopyProfile({
  kind,
  from,
  fromName,
  onDone,
}: {
  readonly kind: ProfileKind;
  readonly from: string;
  readonly fromName: string;
  /** With the id of the new one; null where the person has changed their mind. */
  readonly onDone: (made: string | null) => void;
}) {
  const [name, setName] = useState(`My ${fromName}`);
  const [typed, setTyped] = useState<string | null>(null);
  const [busy, setBusy] = useState(false);
  const known = useMachines((store) => (kind === "machine" ? store.machines : store.materials));
  const state = useDesign((design) => design.state);
  const id = typed ?? slugOf(name);
  const wrong = slugProblem(
    id,
    (known ?? []).map((entry) => entry.id),
  );
  const make = async () => {
    setBusy(true);
    const made = await told(platform.ask("copy-profile", { kind, from, id, name: name.trim() }));
    setBusy(false);
    if (!made) return;
    profilesChanged(null);
    // It has the same figures, so that there is nothing to compare.
    if (kind === "machine") await switchTo(made.id, state?.material ?? null);
    else await chooseMaterial(made.id);
    onDone(made.id);
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
        It has all figures of {fromName}, and those that you change. The design takes it as its{" "}
        {kind === "machine" ? "machine" : "wire"}.
      </p>
      <div className="row end">
        <Button onClick={() => onDone(null)}>Cancel</Button>
        <Button kind="primary" type="submit" why={why}>
          Copy
        </Button>
      </div>
    </form>
  );
}
