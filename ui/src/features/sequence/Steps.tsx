import { type DragEvent, type KeyboardEvent, useEffect, useId, useRef, useState } from "react";
import type { DrawnSequence } from "../../generated/responses";
import { Button } from "../../shared/controls/Button";
import { NumberField } from "../../shared/controls/NumberField";
import { unitName } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { Rows, type RowsHandle } from "../../shared/lists/Rows";
import { moveStep, slideTo, stepAt, underWay, useSequence } from "../../state/sequence/sequence";
import { displacementNumber } from "../frame/words";
import { KINDS, SHORT_KINDS } from "./words";

const ROW = 28;
const HEIGHT = 8 * ROW;

/** All steps, in their order; a step is dragged to another place, or moved there with the buttons below. */
export function Steps({ drawn }: { readonly drawn: DrawnSequence }) {
  const sequence = useSequence();
  const { at } = sequence;
  // Of a sequence that was checked only the directions that it gives were tried.
  const checked = drawn.sequence.min_free_directions === null;
  const unit = useUnit();
  const rows = useRef<RowsHandle>(null);
  const [over, setOver] = useState<number | null>(null);
  const dragged = useRef<number | null>(null);
  const id = useId();
  const { steps } = drawn.sequence;
  const now = stepAt(at, steps.length);
  useEffect(() => rows.current?.reveal(now), [now]);
  const named = new Set(
    drawn.sequence.diagnostics.flatMap(({ step }) => (step === null || step === undefined ? [] : [step])),
  );
  const keys = (event: KeyboardEvent) => {
    const moves: Partial<Record<string, number>> = {
      ArrowDown: now + 1,
      ArrowUp: now - 1,
      PageDown: now + 6,
      PageUp: now - 6,
      Home: 0,
      End: steps.length - 1,
    };
    const to = moves[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    slideTo(Math.min(Math.max(to, 0), steps.length - 1) + 1);
  };
  const drop = (event: DragEvent, to: number) => {
    event.preventDefault();
    setOver(null);
    if (dragged.current !== null) void moveStep(dragged.current, to);
    dragged.current = null;
  };
  const why = underWay(sequence);
  const move = (to: number) => void moveStep(now, Math.min(Math.max(to, 0), steps.length - 1));
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the keys are those of the list in it, which has the focus
    <div className="build-steps" onKeyDown={keys}>
      <div className="build-row build-head" aria-hidden="true">
        <span>Step</span>
        <span>Edge</span>
        <span>What</span>
        <span>Free</span>
        <span>Sag, {unitName(unit)}</span>
      </div>
      <Rows
        ref={rows}
        role="listbox"
        aria-label="Steps of building"
        aria-activedescendant={`${id}-${now}`}
        count={steps.length}
        rowHeight={ROW}
        height={HEIGHT}
        render={(index) => {
          const step = steps[index];
          if (!step) return null;
          const sag = step.max_displacement_mm;
          const others = (step.edges?.length ?? 1) - 1;
          return (
            // biome-ignore lint/a11y/useFocusableInteractive: the list has the focus, and names the option by aria-activedescendant
            // biome-ignore lint/a11y/useKeyWithClickEvents: the list hears the keys
            <div
              key={index}
              id={`${id}-${index}`}
              role="option"
              aria-selected={index === now}
              className={`build-row${named.has(index) ? " named" : ""}${over === index ? " over" : ""}`}
              draggable={why === null}
              onDragStart={() => {
                dragged.current = index;
              }}
              onDragOver={(event) => {
                if (dragged.current === null) return;
                event.preventDefault();
                setOver(index);
              }}
              onDragEnd={() => {
                dragged.current = null;
                setOver(null);
              }}
              onDrop={(event) => drop(event, index)}
              onClick={() => slideTo(index + 1)}
            >
              <span>{index + 1}</span>
              <span title={others > 0 ? `Edges ${step.edges?.join(", ")}` : undefined}>
                {others > 0 ? `${step.edge} +${others}` : step.edge}
              </span>
              <span className="ellipsis" title={KINDS[step.type]}>
                {SHORT_KINDS[step.type]}
              </span>
              <span
                title={
                  checked
                    ? "Whether the head can stand. In a sequence that is checked other directions are not tried."
                    : undefined
                }
              >
                {checked ? (step.free_directions > 0 ? "yes" : "no") : step.free_directions}
              </span>
              <span>{sag == null ? "–" : displacementNumber(sag, unit)}</span>
            </div>
          );
        }}
      />
      <div className="row">
        <Button small why={why ?? (now === 0 ? "It is the first step." : null)} icon="up" onClick={() => move(now - 1)}>
          Earlier
        </Button>
        <Button
          small
          why={why ?? (now === steps.length - 1 ? "It is the last step." : null)}
          icon="down"
          onClick={() => move(now + 1)}
        >
          Later
        </Button>
        <span className="grow" />
        <span className="muted small nowrap">To step</span>
        <span className="build-to">
          <NumberField
            label="Move to step"
            kind="whole"
            value={now + 1}
            min={1}
            max={steps.length}
            why={why}
            onCommit={(value) => move(value - 1)}
          />
        </span>
      </div>
    </div>
  );
}
