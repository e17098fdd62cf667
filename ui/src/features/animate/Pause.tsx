import { type FormEvent, useState } from "react";
import type { ProgramResponse } from "../../generated/responses";
import { Button } from "../../shared/controls/Button";
import { TextInput } from "../../shared/controls/inputs";
import { Line } from "../../shared/lists/Line";
import { edit } from "../../state/design/design";
import { stepOf } from "../../state/program/clock";
import { pause, usePlayback, useProgram, useStale } from "../../state/program/program";
import { useRunFile } from "../../state/program/run_file";

/** What a person does after the step that is shown, before the machine goes on. */
export function Pause() {
  const { program, wire } = useProgram();
  const file = useRunFile((run) => run.file);
  const steps = program?.wires[wire]?.steps ?? [];
  const current = usePlayback(({ played, step }) => (played ? stepOf(steps.length, step) : -1));
  const step = steps[current];
  // What a file says of its pauses is in its rows.
  if (!program || file) return null;
  return (
    <>
      <PauseForm key={`${wire}/${current}`} number={step ? current + 1 : null} step={step ?? null} />
      <LeftOut pauses={program.left_out} />
    </>
  );
}

type Step = ProgramResponse["wires"][number]["steps"][number];

function PauseForm({ number, step }: { readonly number: number | null; readonly step: Step | null }) {
  const note = step?.pause ?? "";
  const place = step?.place ?? null;
  // What was typed before the note became another one is no more.
  const [typed, setTyped] = useState({ of: note, text: note });
  const text = typed.of === note ? typed.text : note;
  const stale = useStale();
  const nowhere = step === null ? "Select a step first." : place ? null : "Nothing is bent after the last step.";
  const why = nowhere ?? (stale ? "The design or its machine was changed: update the program first." : null);
  const label = number === null ? "Pause after a step" : `Pause after step ${number}`;
  const unsaid = text.trim() === "" ? "Type what is to be done there." : text.trim() === note ? "It is set." : null;
  const set = (said: string | null) => place && void edit({ edit: "pause", ...place, note: said });
  const submit = (event: FormEvent) => {
    event.preventDefault();
    if (why === null && unsaid === null) set(text);
  };
  return (
    <form className="row" onSubmit={submit}>
      <TextInput
        className="grow"
        aria-label={label}
        placeholder={number === null ? label : "Pause: turn the part"}
        value={text}
        disabled={nowhere !== null}
        // The step that it is about would go on to the next one.
        onFocus={pause}
        title={why ?? undefined}
        onChange={(event) => setTyped({ of: note, text: event.currentTarget.value })}
      />
      <Button small type="submit" why={why ?? unsaid}>
        Set
      </Button>
      <Button small why={why ?? (note === "" ? "There is no pause." : null)} onClick={() => set(null)}>
        Remove
      </Button>
    </form>
  );
}

/** Pause points of the design that no wire comes to. */
function LeftOut({ pauses }: { readonly pauses: ProgramResponse["left_out"] }) {
  if (pauses.length === 0) return null;
  return (
    <ul>
      {pauses.map(({ vertex, pass, note, why }) => (
        <Line
          key={`${vertex}/${pass}`}
          tone="warning"
          what={`Pause left out: ${note}`}
          sub={`Vertex ${vertex}: ${why}.`}
          action={
            <Button kind="link" onClick={() => void edit({ edit: "pause", vertex, pass, note: null })}>
              Remove
            </Button>
          }
        />
      ))}
    </ul>
  );
}
