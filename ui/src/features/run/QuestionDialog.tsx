import { useEffect, useState } from "react";
import { Button } from "../../shared/Button";
import { Dialog } from "../../shared/Dialog";
import { angle, sentence } from "../../shared/format";
import { useLengths } from "../../shared/unit";
import { answer, useRun } from "../../state/run";
import type { Axes, Doubt, Question } from "../../state/operator";

/** Title, and what no and yes are called. No comes first and has the focus: it is what changes nothing. */
const WORDS: Readonly<Record<Question["kind"], readonly [string, string, string]>> = {
  move: ["The machine is about to move", "Do not move", "Move"],
  arm: ["Arm the wire", "Do not arm", "Arm"],
  "go-on": ["The wire is about to go on", "Do not go on", "Go on"],
  settings: ["The machine's settings are about to be written", "Do not write", "Write"],
  doubt: ["Look at the wire", "I do not know", "It was made"],
};

/** A second click of a double one is no answer to the question that comes next, ms. */
const READ = 700;

/** Whether a question has only just come. */
function useUnread(question: number | null): boolean {
  const [read, setRead] = useState<number | null>(null);
  useEffect(() => {
    const timer = setTimeout(() => setRead(question), READ);
    return () => clearTimeout(timer);
  }, [question]);
  return read !== question;
}

/** What the operator asks before anything moves. Esc does nothing: it has to be answered. */
export function QuestionDialog() {
  const { question, ordering } = useRun();
  const unread = useUnread(question?.id ?? null);
  const { said } = useLengths();
  if (!question) return null;
  const { id, kind } = question;
  const [title, no, yes] = WORDS[kind];
  const why = ordering ? "The answer is on its way." : kind === "doubt" && unread ? "Look at the wire first." : null;
  return (
    <Dialog
      key={id}
      title={title}
      actions={
        <>
          <Button data-first why={why} onClick={() => void answer(id, "no")}>
            {no}
          </Button>
          {kind === "doubt" && (
            <Button why={why} onClick={() => void answer(id, "not-made")}>
              It was not made
            </Button>
          )}
          <Button kind={kind === "doubt" ? "plain" : "primary"} why={why} onClick={() => void answer(id, kind === "doubt" ? "made" : "yes")}>
            {yes}
          </Button>
        </>
      }
    >
      {/* Of a step in doubt they say the same as its figures. */}
      {question.lines.length > 0 && !question.doubt && (
        <ul className="question-lines selectable">
          {question.lines.map((line, index) => (
            <li key={index}>{sentence(said(line))}</li>
          ))}
        </ul>
      )}
      {question.doubt && <Doubtful doubt={question.doubt} />}
      <p className="question">{said(question.question)}</p>
    </Dialog>
  );
}

/** The step of which nobody knows. */
function Doubtful({ doubt }: { readonly doubt: Doubt }) {
  const { length } = useLengths();
  const motion = ({ feed_mm, rotate_deg, bend_deg }: Axes) => `feed ${length(feed_mm)}, rotate ${angle(rotate_deg)}, bend ${angle(bend_deg)}`;
  return (
    <dl className="pairs">
      <div>
        <dt>Step</dt>
        <dd>
          {doubt.step} of {doubt.of}, wire {doubt.wire + 1}
        </dd>
      </div>
      <div>
        <dt>As designed</dt>
        <dd>{motion(doubt.designed)}</dd>
      </div>
      <div>
        <dt>As told</dt>
        <dd>{motion(doubt.told)}</dd>
      </div>
    </dl>
  );
}
