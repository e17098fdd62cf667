import { useEffect, useState } from "react";
import { Button } from "../../../shared/controls/Button";
import { Segmented } from "../../../shared/controls/inputs";
import { NumberField } from "../../../shared/controls/NumberField";
import { angle } from "../../../shared/figures/format";
import { useLengths } from "../../../shared/figures/unit";
import { Dialog } from "../../../shared/layers/Dialog";
import type { Answer, Axes, Doubt, PartOfStep } from "../../../state/machine/operator";
import { answer, useRun } from "../../../state/machine/run";

interface Measured {
  readonly feed_mm: number | null;
  readonly rotate_deg: number | null;
}

type Said = "made" | "not-made" | "as-counted" | "measured";

/** A second click of a double one is no answer to the question that comes next, ms. */
const READ = 700;
/** Less than this is nothing, mm and degrees. */
const NOTHING = 0.05;

/** How much of a step is in the wire: what the machine has counted, or what a person sees and measures. */
export function DoubtDialog({ id, doubt }: { readonly id: number; readonly doubt: Doubt }) {
  const ordering = useRun((run) => run.ordering);
  const [unread, setUnread] = useState(true);
  useEffect(() => {
    const timer = setTimeout(() => setUnread(false), READ);
    return () => clearTimeout(timer);
  }, []);
  const { told, before, counted } = doubt;
  const [said, setSaid] = useState<Said | null>(null);
  const [measured, setMeasured] = useState<Measured>(() => ({
    feed_mm: counted ? counted.feed_mm : nothing(told.feed_mm),
    rotate_deg: counted ? counted.rotate_deg : nothing(told.rotate_deg),
  }));
  /** What stands in a field while it is typed in, null where that is no number: it counts instead of what stood there before. */
  const [typed, setTyped] = useState<Partial<Measured>>({});
  const type = (axis: keyof Measured) => (value: number | null, isTyping: boolean) =>
    setTyped(({ [axis]: _, ...others }) => (isTyping ? { ...others, [axis]: value } : others));
  const { feed_mm, rotate_deg } = { ...measured, ...typed };
  const part: PartOfStep | null = feed_mm === null || rotate_deg === null ? null : { feed_mm, rotate_deg };
  const words: Answer | null = said === "measured" ? part && { part } : said;
  const why = ordering ? "The answer is on its way." : unread ? "Look at the wire first." : null;
  const unsaid = said === null ? "Say how much of it is in the wire." : "Type what you measure.";
  const within = (whole: number) => ({ min: Math.min(0, whole), max: Math.max(0, whole) });
  return (
    <Dialog
      title="Look at the wire"
      actions={
        <>
          <Button data-first why={why} onClick={() => void answer(id, "no")}>
            Not now
          </Button>
          <Button
            kind="primary"
            why={why ?? (words === null ? unsaid : null)}
            onClick={() => words !== null && void answer(id, words)}
          >
            Continue
          </Button>
        </>
      }
    >
      <Figures doubt={doubt} />
      <p className="question">How much of this step is in the wire?</p>
      <Segmented
        label="In the wire"
        // Nothing is chosen before a person has looked.
        value={said ?? ("" as Said)}
        onChoose={setSaid}
        choices={[
          { value: "made", label: "All of it" },
          { value: "not-made", label: before.feed_mm || before.rotate_deg ? "No more than before" : "None of it" },
          ...(counted ? [{ value: "as-counted" as const, label: "As counted" }] : []),
          { value: "measured", label: "Measured" },
        ]}
      />
      {said === "measured" && (
        <div className="row">
          {Math.abs(told.feed_mm) > NOTHING && (
            <NumberField
              label="Fed"
              prefix="Fed"
              value={measured.feed_mm}
              {...within(told.feed_mm)}
              onType={type("feed_mm")}
              onCommit={(mm) => setMeasured({ ...measured, feed_mm: mm })}
            />
          )}
          {Math.abs(told.rotate_deg) > NOTHING && (
            <NumberField
              label="Turned"
              prefix="Turned"
              kind="angle"
              value={measured.rotate_deg}
              {...within(told.rotate_deg)}
              onType={type("rotate_deg")}
              onCommit={(deg) => setMeasured({ ...measured, rotate_deg: deg })}
            />
          )}
        </div>
      )}
      <p className="muted what-follows" aria-live="polite">
        <Outcome
          doubt={doubt}
          said={said}
          part={said === "as-counted" ? counted : said === "measured" ? part : before}
        />
      </p>
      <details>
        <summary>How to check</summary>
        <ol className="how-to-tell small">
          {Math.abs(doubt.designed.bend_deg) > NOTHING && (
            <li>Count the bends. Where the bend of this step is among them, all of it is done.</li>
          )}
          <li>Measure how far the last bend is from where it was bent: that is what was fed of this step.</li>
          <li>See how far the head stands from where the step began: that is what was turned.</li>
          <li>If unsure, press Not now, cut the wire off and give it up. A wrong guess gives a wrong wire.</li>
        </ol>
      </details>
    </Dialog>
  );
}

/** What need not be measured, since there is none of it. */
const nothing = (whole: number): number | null => (Math.abs(whole) > NOTHING ? null : 0);

function Figures({ doubt }: { readonly doubt: Doubt }) {
  const { length } = useLengths();
  const { step, of, wire, designed, told, before, counted } = doubt;
  const motion = ({ feed_mm, rotate_deg, bend_deg }: Axes) =>
    `feed ${length(feed_mm)}, rotate ${angle(rotate_deg)}, bend ${angle(bend_deg)}`;
  const share = ({ feed_mm, rotate_deg }: PartOfStep) => `${length(feed_mm)} fed, ${angle(rotate_deg)} turned`;
  const rows: [string, string][] = [
    ["Step", `${step} of ${of}, wire ${wire + 1}`],
    ["As designed", motion(designed)],
    ["Command sent", motion(told)],
    ...(before.feed_mm || before.rotate_deg ? [["Done before", share(before)] as [string, string]] : []),
    ["Counted", counted ? share(counted) : "not counted by the machine"],
  ];
  return (
    <dl className="pairs">
      {rows.map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}

/** What the machine does then. */
function Outcome({
  doubt,
  said,
  part,
}: {
  readonly doubt: Doubt;
  readonly said: Said | null;
  readonly part: PartOfStep | null;
}) {
  const { length } = useLengths();
  const { step, of, told } = doubt;
  if (said === null) return "The rest of the step follows, with its bend from the beginning.";
  if (said === "made") return step < of ? `The wire resumes at step ${step + 1}.` : "The wire is finished.";
  if (part === null) return "The rest follows, with the bend from its beginning.";
  // Where the axis stops before zero its sign is not the side of the bend.
  const { bend_deg } = told.approach_deg ? doubt.designed : told;
  const rest = `feed ${length(told.feed_mm - part.feed_mm)}, rotate ${angle(told.rotate_deg - part.rotate_deg)}, bend ${angle(bend_deg)} from its beginning`;
  return `The machine will do: ${rest}.${said === "as-counted" ? " The axis that was on its way may have lost steps as it stopped: measure where that matters." : ""}`;
}
