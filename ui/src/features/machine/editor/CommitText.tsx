import { useState } from "react";
import { TextInput } from "../../../shared/controls/inputs";

/** A line of text that is taken with Enter or by leaving it. */
export function CommitText({
  label,
  value,
  placeholder,
  why,
  onCommit,
}: {
  readonly label: string;
  readonly value: string;
  readonly placeholder?: string;
  readonly why?: string | null;
  readonly onCommit: (text: string) => void;
}) {
  const [typed, setTyped] = useState<string | null>(null);
  const commit = () => {
    if (typed !== null && typed.trim() !== value) onCommit(typed.trim());
    setTyped(null);
  };
  return (
    <TextInput
      aria-label={label}
      value={typed ?? value}
      placeholder={placeholder}
      readOnly={Boolean(why)}
      aria-disabled={why ? true : undefined}
      title={why ?? undefined}
      onChange={(event) => setTyped(event.currentTarget.value)}
      onBlur={commit}
      onKeyDown={(event) => {
        if (event.key === "Enter") commit();
        else if (event.key === "Escape" && typed !== null) {
          event.preventDefault();
          event.stopPropagation();
          setTyped(null);
        }
      }}
    />
  );
}
