import { useState } from "react";
import { Button } from "../../../shared/controls/Button";
import { Field } from "../../../shared/controls/Field";
import { NumberField } from "../../../shared/controls/NumberField";
import { angle, sentence } from "../../../shared/figures/format";
import { Dialog } from "../../../shared/layers/Dialog";
import type { Question } from "../../../state/machine/operator";
import { answer, useRun } from "../../../state/machine/run";
import { DoubtDialog } from "./DoubtDialog";

/** Title, and what no and yes are called. No comes first and has the focus: it is what changes nothing. */
const WORDS: Readonly<Record<Exclude<Question["kind"], "doubt">, readonly [string, string, string]>> = {
  move: ["The machine is about to move", "Do not move", "Move"],
  arm: ["Arm the machine", "Do not arm", "Arm"],
  piece: ["The next piece", "End here", "Bend it"],
  "go-on": ["The wire is about to resume", "Do not resume", "Resume"],
  pause: ["Pause point", "Stop the wire", "Resume"],
  said: ["Confirm your earlier answer", "It is different", "It is right"],
  settings: ["The machine's settings are about to be written", "Do not write", "Write"],
  console: ["The line may move or change the machine", "Do not send", "Send"],
  head: ["Look at the head", "I do not know", "It stands there"],
};

/** What the operator asks before anything moves. Esc does nothing: it has to be answered. */
export function QuestionDialog() {
  const { question, ordering, state } = useRun();
  // What was said to a question before is no answer to this one.
  const [seen, setSeen] = useState<{ readonly question: number; readonly deg: number } | null>(null);
  const [missing, setMissing] = useState<number | null>(null);
  const stands = seen?.question === question?.id ? (seen?.deg ?? null) : (question?.head?.left_at_deg ?? null);
  if (!question) return null;
  const { id, kind, doubt } = question;
  if (doubt) return <DoubtDialog key={id} id={id} doubt={doubt} />;
  const [named, no, yes] = WORDS[kind === "doubt" ? "go-on" : kind];
  // Of several wires of one piece each is asked about, too.
  const title = kind === "piece" && !state?.wire?.piece ? "The next wire" : named;
  const why = ordering ? "The answer is on its way." : null;
  return (
    <Dialog
      key={id}
      title={title}
      actions={
        <>
          <Button data-first why={why} onClick={() => void answer(id, "no")}>
            {no}
          </Button>
          {kind === "head" ? (
            // It can be pressed with the field still being typed in: leaving that is what counts.
            <Button
              kind="primary"
              why={why}
              onClick={() => (stands === null ? setMissing(id) : void answer(id, { head: stands }))}
            >
              {yes}
            </Button>
          ) : (
            <Button kind="primary" why={why} onClick={() => void answer(id, "yes")}>
              {yes}
            </Button>
          )}
        </>
      }
    >
      {question.lines.length > 0 && (
        <ul className="question-lines selectable">
          {question.lines.map((line, index) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: the lines of a question do not change
            <li key={index}>{sentence(line)}</li>
          ))}
        </ul>
      )}
      <p className="question">{question.question}</p>
      {question.head && (
        <HeadField
          range={question.head.range_deg}
          stands={stands}
          missing={missing === id && stands === null}
          onCommit={(deg) => setSeen({ question: id, deg })}
        />
      )}
    </Dialog>
  );
}

/** Where the head stands, as far as its cable allows. Empty until a person has looked. */
function HeadField({
  range: [least, most],
  stands,
  missing,
  onCommit,
}: {
  readonly range: readonly [number, number];
  readonly stands: number | null;
  /** It was to be said without a number. */
  readonly missing: boolean;
  readonly onCommit: (deg: number) => void;
}) {
  const within = `from ${angle(least)} to ${angle(most)}`;
  return (
    <Field
      label="It stands at"
      hint={sentence(within)}
      error={missing ? `Enter an angle ${within}, or choose I do not know.` : null}
    >
      {(ids) => (
        <NumberField
          {...ids}
          kind="angle"
          label="It stands at"
          value={stands}
          min={least}
          max={most}
          onCommit={onCommit}
        />
      )}
    </Field>
  );
}
