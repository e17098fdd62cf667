import { type KeyboardEvent, useEffect, useId, useRef } from "react";
import { useLengths } from "../../shared/figures/unit";
import { Rows, type RowsHandle } from "../../shared/lists/Rows";
import { useDesign } from "../../state/design/design";
import { stepOf } from "../../state/program/clock";
import { type PlayedContact, useContacts } from "../../state/program/contacts";
import { goTo, usePlayback, useProgram } from "../../state/program/program";
import { useRunFindings } from "../../state/program/run_file";
import { hitOf } from "./hits";
import { namedSteps, spoken, stepRow } from "./steps";

/** px. */
const ROW = 38;
const HEIGHT = ROW * 7;

/** Every step: as designed, and under it what is sent to the machine. */
export function StepTable() {
  const { program, wire } = useProgram();
  const { unit, name, length } = useLengths();
  const check = useDesign((design) => design.check);
  const { contacts } = useContacts();
  const file = useRunFindings();
  const rows = useRef<RowsHandle>(null);
  const id = useId();
  const one = program?.wires[wire];
  const total = one?.steps.length ?? 0;
  // Not the place within it: that is another one at every picture.
  const current = usePlayback(({ played, step }) => (played ? stepOf(total, step) : -1));
  useEffect(() => {
    if (current >= 0) rows.current?.reveal(current);
  }, [current]);
  if (!program || !one) return null;
  const hitsOf = (index: number) => contacts.filter(({ step }) => step === index);
  const named = new Set(namedSteps((file ?? check)?.diagnostics ?? [], program.wires.length));
  const keys = (event: KeyboardEvent) => {
    const moves: Partial<Record<string, number>> = {
      ArrowDown: current + 1,
      ArrowUp: current - 1,
      PageDown: current + 6,
      PageUp: current - 6,
      Home: 0,
      End: total - 1,
    };
    const to = moves[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    void goTo(Math.min(Math.max(to, 0), total - 1));
  };
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the keys are those of the list in it, which has the focus
    <div className="step-table" onKeyDown={keys}>
      <div className="step-row step-head" aria-hidden="true">
        <span>Step</span>
        <span>Edge</span>
        <span>Feed, {name}</span>
        <span>Rotate, °</span>
        <span>Bend, °</span>
      </div>
      <Rows
        ref={rows}
        role="listbox"
        aria-label="Steps"
        aria-activedescendant={current >= 0 ? `${id}-${current}` : undefined}
        count={total}
        rowHeight={ROW}
        height={HEIGHT}
        render={(index) => {
          const row = stepRow(one, index, unit);
          if (!row) return null;
          return (
            // biome-ignore lint/a11y/useFocusableInteractive: the list has the focus, and names the option by aria-activedescendant
            // biome-ignore lint/a11y/useKeyWithClickEvents: the list hears the keys
            <div
              key={index}
              id={`${id}-${index}`}
              role="option"
              aria-selected={index === current}
              className={`step-row${named.has(index) ? " named" : ""}`}
              onClick={() => void goTo(index)}
            >
              <span className="step-number" aria-hidden="true">
                {row.number}
                {one.steps[index]?.pause && <span className="step-pause" title={`Pause: ${one.steps[index]?.pause}`} />}
                <StepHits hits={hitsOf(index)} />
              </span>
              <span className="step-edge" title={row.edges.all} aria-hidden="true">
                {row.edges.short}
              </span>
              {row.designed.map((figure, part) => (
                // biome-ignore lint/suspicious/noArrayIndexKey: feed, rotate, bend: always these three
                <span key={part} className="step-figure" aria-hidden="true">
                  {figure}
                  <small>{row.told?.[part] ?? ""}</small>
                </span>
              ))}
              <span className="visually-hidden">
                {[spoken(one, index, length), ...hitsOf(index).map(hitOf)].join("; ")}
              </span>
            </div>
          );
        }}
      />
      <p className="muted small">As designed; in grey what is sent to the machine.</p>
    </div>
  );
}

/** A diamond, as on the timeline, where the wire hits something in a step. */
function StepHits({ hits }: { readonly hits: readonly PlayedContact[] }) {
  if (hits.length === 0) return null;
  const error = hits.some(({ finding }) => finding.severity === "error");
  return <span className={`step-hit ${error ? "error" : "warning"}`} title={hits.map(hitOf).join("; ")} />;
}
