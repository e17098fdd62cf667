import { type KeyboardEvent, useEffect, useState } from "react";
import { Button } from "../../../shared/controls/Button";
import { Either } from "../../../shared/controls/Either";
import { TextInput } from "../../../shared/controls/inputs";
import { type Recalled, recall } from "../../../state/machine/console";
import type { Because } from "../../../state/machine/operator";
import { isOpen, sendLine, useRun } from "../../../state/machine/run";
import { buttons } from "../buttons";
import { useProspect } from "../prospect";

/** A line of the driver's protocol may be as long. */
const LONGEST = 256;

/** What a line that Enter was pressed for waits for. */
const SOON_OVER: ReadonlySet<Because> = new Set(["busy", "homing", "moving"]);

/** A line for the machine, in its own words: Enter sends it, the arrows recall those before. */
export function ConsoleInput() {
  const { state, ordering, typed, refusedLine } = useRun();
  const prospect = useProspect();
  const [line, setLine] = useState("");
  const [recalled, setRecalled] = useState<Recalled | null>(null);
  /** Enter was pressed while something else was under way. */
  const [waiting, setWaiting] = useState(false);
  // What was not taken stays to be corrected, unless the next one is being typed.
  useEffect(() => {
    if (refusedLine !== null) setLine((next) => (next === "" ? refusedLine : next));
  }, [refusedLine]);
  const now = isOpen(state) ? state : null;
  const why = buttons(now, prospect).console ?? (ordering ? "An order is on its way." : null);
  const because = now?.cannot.find((refused) => refused.order === "console")?.because;
  // While something else is answered the next one can be typed; what takes the field away takes the keys away.
  const off = !now || (because !== undefined && !SOON_OVER.has(because));
  const send = async () => {
    const text = line.trim();
    if (text === "" || off) return;
    setWaiting(why !== null);
    if (why !== null) return;
    // The next one can be typed while this one is on its way.
    setLine("");
    setRecalled(null);
    if (!(await sendLine(text))) setLine((next) => (next === "" ? text : next));
  };
  // biome-ignore lint/correctness/useExhaustiveDependencies: what is typed in the meantime is not what was to be sent
  useEffect(() => {
    if (off) setWaiting(false);
    else if (waiting && why === null) void send();
  }, [waiting, why, off]);
  const onKeyDown = (event: KeyboardEvent<HTMLInputElement>) => {
    if (event.key === "Enter") {
      event.preventDefault();
      void send();
    }
    if (event.key === "Escape" && waiting) {
      event.preventDefault();
      setWaiting(false);
    }
    const way = event.key === "ArrowUp" ? -1 : event.key === "ArrowDown" ? 1 : 0;
    if (way === 0) return;
    event.preventDefault();
    const found = recall(typed, recalled ?? { at: typed.length, draft: line }, way);
    setWaiting(false);
    setRecalled(found);
    setLine(typed[found.at] ?? found.draft);
  };
  return (
    <div className="row">
      <TextInput
        className="console-input"
        aria-label="Line to the machine"
        placeholder={off ? (why ?? undefined) : "Type a line for the machine"}
        title={off ? (why ?? undefined) : undefined}
        readOnly={off}
        aria-disabled={off}
        value={line}
        maxLength={LONGEST}
        spellCheck={false}
        autoComplete="off"
        onChange={(event) => {
          setLine(event.currentTarget.value);
          setRecalled(null);
          setWaiting(false);
        }}
        onKeyDown={onKeyDown}
      />
      <Button
        small
        why={
          waiting
            ? "It is sent once the machine is done. Esc gives it up."
            : (why ?? (line.trim() === "" ? "Type a line first." : null))
        }
        onClick={() => void send()}
      >
        <Either shown={waiting ? "Waiting" : "Send"} other={waiting ? "Send" : "Waiting"} />
      </Button>
    </div>
  );
}
