import { useEffect, useMemo, useRef, useState } from "react";
import { Button } from "../../../shared/controls/Button";
import { Fold } from "../../../shared/controls/Fold";
import { TextInput } from "../../../shared/controls/inputs";
import { count } from "../../../shared/figures/format";
import { told } from "../../../state/asking/problems";
import { asText, clockOf, filtered } from "../../../state/machine/console";
import { clearConsole, useRun } from "../../../state/machine/run";
import { ConsoleInput } from "./ConsoleInput";

/** px from the end at which new lines still scroll along. */
const NEAR_END = 24;

const WAYS = {
  true: { name: "to the machine", sign: "›" },
  false: { name: "from the machine", sign: "‹" },
  null: { name: "of this program", sign: "·" },
} as const;

/** Lines to and from the machine. */
export function Console() {
  const many = useRun((run) => run.console.length);
  return (
    <Fold title="Console" phrase={many === 0 ? "empty" : count(many, "line")}>
      <Lines />
    </Fold>
  );
}

function Lines() {
  const lines = useRun((run) => run.console);
  const [filter, setFilter] = useState("");
  const [copied, setCopied] = useState(false);
  const box = useRef<HTMLDivElement>(null);
  const atEnd = useRef(true);
  const shown = useMemo(() => filtered(lines, filter), [lines, filter]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: new lines make it longer
  useEffect(() => {
    if (atEnd.current && box.current) box.current.scrollTop = box.current.scrollHeight;
  }, [shown]);
  const copy = async () => {
    const done = await told(navigator.clipboard.writeText(asText(shown)).then(() => true));
    if (!done) return;
    setCopied(true);
    window.setTimeout(() => setCopied(false), 1500);
  };
  const none = shown.length === 0 ? "There is nothing to copy." : null;
  return (
    <div className="stack">
      <div className="row">
        <TextInput
          aria-label="Filter lines"
          placeholder="Filter"
          value={filter}
          onChange={(event) => setFilter(event.currentTarget.value)}
        />
        <Button small icon="copy" why={none} onClick={() => void copy()}>
          {copied ? "Copied" : "Copy"}
        </Button>
        <Button small why={lines.length === 0 ? "It is empty." : null} onClick={clearConsole}>
          Clear
        </Button>
      </div>
      <div
        ref={box}
        className="console selectable"
        role="log"
        aria-label="Lines to and from the machine"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, also by keys
        tabIndex={0}
        onScroll={(event) => {
          const { scrollTop, scrollHeight, clientHeight } = event.currentTarget;
          atEnd.current = scrollHeight - scrollTop - clientHeight < NEAR_END;
        }}
      >
        {shown.map((line) => (
          <div key={line.id} className={line.toMachine ? "to-machine" : undefined}>
            <time className="console-time">{clockOf(line.at)}</time>{" "}
            <span className="console-way" aria-label={WAYS[`${line.toMachine}`].name} role="img">
              {WAYS[`${line.toMachine}`].sign}
            </span>
            {line.text}
          </div>
        ))}
        {shown.length === 0 && (
          <div className="muted">{lines.length === 0 ? "No messages yet." : "No line fits the filter."}</div>
        )}
      </div>
      <ConsoleInput />
    </div>
  );
}
