import { useState } from "react";
import { TextInput } from "../../shared/controls/inputs";

/** What something is called: taken with Enter, or when the field is left; Esc gives it up. */
export function Name({
  id,
  label,
  name,
  usual,
  why,
  onCommit,
}: {
  readonly id: string;
  readonly label: string;
  readonly name: string;
  /** What it is called without a name. */
  readonly usual: string;
  readonly why: string | null;
  readonly onCommit: (name: string) => void;
}) {
  const [typed, setTyped] = useState<string | null>(null);
  const commit = () => {
    if (typed !== null && typed.trim() !== name) onCommit(typed);
    setTyped(null);
  };
  return (
    <TextInput
      id={id}
      aria-label={label}
      value={typed ?? name}
      placeholder={usual}
      disabled={why !== null}
      title={why ?? undefined}
      onChange={(event) => setTyped(event.currentTarget.value)}
      onBlur={commit}
      onKeyDown={(event) => {
        if (event.key === "Enter") commit();
        if (event.key === "Escape" && typed !== null) {
          event.stopPropagation();
          setTyped(null);
        }
      }}
    />
  );
}
