import { Button } from "../../shared/Button";
import { Dialog } from "../../shared/Dialog";
import { sentence } from "../../shared/format";
import { useLengths } from "../../shared/unit";
import { answer, useRun } from "../../state/run";
import type { Question } from "../../state/operator";
import { DoubtDialog } from "./DoubtDialog";

/** Title, and what no and yes are called. No comes first and has the focus: it is what changes nothing. */
const WORDS: Readonly<Record<Exclude<Question["kind"], "doubt">, readonly [string, string, string]>> = {
  move: ["The machine is about to move", "Do not move", "Move"],
  arm: ["Arm the wire", "Do not arm", "Arm"],
  "go-on": ["The wire is about to go on", "Do not go on", "Go on"],
  settings: ["The machine's settings are about to be written", "Do not write", "Write"],
};

/** What the operator asks before anything moves. Esc does nothing: it has to be answered. */
export function QuestionDialog() {
  const { question, ordering } = useRun();
  const { said } = useLengths();
  if (!question) return null;
  const { id, kind, doubt } = question;
  if (doubt) return <DoubtDialog key={id} id={id} doubt={doubt} />;
  const [title, no, yes] = WORDS[kind === "doubt" ? "go-on" : kind];
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
          <Button kind="primary" why={why} onClick={() => void answer(id, "yes")}>
            {yes}
          </Button>
        </>
      }
    >
      {question.lines.length > 0 && (
        <ul className="question-lines selectable">
          {question.lines.map((line, index) => (
            <li key={index}>{sentence(said(line))}</li>
          ))}
        </ul>
      )}
      <p className="question">{said(question.question)}</p>
    </Dialog>
  );
}
