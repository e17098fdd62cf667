import { useEffect } from "react";
import type { EditRequest } from "../../generated/requests";
import { Button } from "../../shared/controls/Button";
import { Mark } from "../../shared/lists/Mark";
import { useDesign } from "../../state/design/design";
import { askForOutcome, type OutcomeForm, useOutcomes } from "../../state/design/outcomes";
import { useMachines } from "../../state/machine/machines";

/** What a form would make with these figures; null without any, and until it is known: what is known of others is no answer. */
export function useOutcome(form: OutcomeForm, request: EditRequest | null) {
  const version = useDesign((store) => store.version);
  const changes = useMachines((store) => store.changes);
  const to = request && JSON.stringify([version, changes, request]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the request is in its name, and is made anew each time
  useEffect(() => {
    if (to && request) askForOutcome(form, to, request);
  }, [form, to]);
  const answer = useOutcomes((store) => store[form]);
  return answer && answer.to === to ? answer : null;
}

/** What the machine needs of a length, where it needs any. */
export const needs = (mm: number, length: (mm: number) => string): string =>
  mm > 0 ? `; the machine needs ${length(mm)}` : "";

/** What will come out of the figures of a form before it is done, and a figure that fits where it cannot be made. As high whatever it says. */
export function Outcome({
  fits,
  text,
  use,
}: {
  /** Whether the machine can make it; null where there is nothing to say. */
  readonly fits: boolean | null;
  readonly text: string;
  /** A figure that fits, and what takes it. */
  readonly use: { readonly label: string; readonly take: () => void } | null;
}) {
  return (
    <div className="outcome">
      <output className={fits === false ? "wrong" : "muted"}>
        {fits !== null && <Mark tone={fits ? "fine" : "error"} />}
        <span>{text}</span>
      </output>
      {use && (
        <Button small onClick={use.take}>
          {use.label}
        </Button>
      )}
    </div>
  );
}
