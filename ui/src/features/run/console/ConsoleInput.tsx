import { type KeyboardEvent, useEffect, useState } from "react";
import { Button } from "../../../shared/controls/Button";
import { TextInput } from "../../../shared/controls/inputs";
import { type Recalled, recall } from "../../../state/machine/console";
import { isOpen, sendLine, useRun } from "../../../state/machine/run";
import { buttons } from "../buttons";
import { useProspect } from "../prospect";

/** A line of the driver's protocol may be as long. */
const LONGEST = 256;

/** A line for the machine, in its own words: Enter sends it, the arrows recall those before. */
export function ConsoleInput() {
  const { state, ordering, typed, refusedLine } = useRun();
  const prospect = useProspect();
  const [line, setLine] = useState("");
  const [recalled, setRecalled] = useState<Recalled | null>(null);
  // What was not taken stays to be corrected, unless the next one is being typed.
  useEffect(() => {
    if (refusedLine !== null) setLine((next) => (next === "" ? refusedLine : next));
  }, [refusedLine]);
  const now = isOpen(state) ? state : null;
  const why = buttons(now, prospect).console ?? (ordering ? "An order is on its way." : null);
  // While a line is answered the next one can be typed; what takes the field away takes the keys away.
  const off = why !== null && !ordering && !(now?.busy ?? false);
  const send = async () => {
    const text = line.trim();
    if (text === "" || why !== null) return;
    if (!(await sendLine(text))) return;
    // The driver may have refused it by now.
    setLine(useRun.getState().refusedLine ?? "");
    setRecalled(null);
  };
  const onKeyDown = (event: KeyboardEvent<HTMLInputElement>) => {
    if (event.key === "Enter") {
      event.preventDefault();
      void send();
    }
    const way = event.key === "ArrowUp" ? -1 : event.key === "ArrowDown" ? 1 : 0;
    if (way === 0) return;
    event.preventDefault();
    const found = recall(typed, recalled ?? { at: typed.length, draft: line }, way);
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
        }}
        onKeyDown={onKeyDown}
      />
      <Button small why={why ?? (line.trim() === "" ? "Type a line first." : null)} onClick={() => void send()}>
        Send
      </Button>
    </div>
  );
}
