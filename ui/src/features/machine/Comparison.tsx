import { useEffect, useRef } from "react";
import { Button } from "../../shared/Button";
import { Bar } from "../../shared/inputs";
import { Line } from "../../shared/Line";
import { useUnit } from "../../shared/unit";
import { stopComparing, switchTo, useMachines } from "../../state/machines";
import { differences, figures } from "./differences";

/** What another machine changes for the design, and switching to it. */
export function Comparison() {
  const { compared, machines, materials } = useMachines();
  const unit = useUnit();
  const box = useRef<HTMLDivElement>(null);
  const answered = Boolean(compared?.to ?? compared?.problem);
  useEffect(() => {
    // Newer engines return a promise, which is nothing to end an effect with.
    void box.current?.scrollIntoView({ block: "nearest" });
  }, [answered]);
  if (!compared) return null;
  const { machine, from, to, problem } = compared;
  const entry = machines?.find(({ id }) => id === machine);
  const name = entry?.name ?? machine;
  const wire = materials?.find(({ id }) => id === (to?.material ?? from?.material));
  const ownWire = materials?.find(({ id }) => id === entry?.default_material);
  const fits = !wire || !entry || (wire.diameter_mm >= entry.diameter_mm[0] && wire.diameter_mm <= entry.diameter_mm[1]);
  return (
    <div ref={box} className="comparison" role="region" aria-label={`With ${name}`} aria-live="polite">
      {!to && !problem && (
        <>
          <p className="muted">Planning the design for {name}…</p>
          <Bar done={0} of={0} label="Comparing" />
        </>
      )}
      {problem && (
        <ul>
          <Line tone="error" what="It cannot be compared" sub={problem} />
        </ul>
      )}
      {from && to && (
        <>
          <ul>
            {differences(from, to).map((one) => (
              <Line key={one.what} tone={one.tone} what={one.what} sub={one.sub} />
            ))}
          </ul>
          <dl className="comparison-figures">
            {figures(from, to, unit).map(([title, phrase]) => (
              <div key={title}>
                <dt>{title}</dt>
                <dd>{phrase}</dd>
              </div>
            ))}
          </dl>
          {!fits && wire && (
            <p className="muted small">
              {wire.name} does not fit it. With its own wire, {ownWire?.name ?? entry?.default_material}, the figures are others.
            </p>
          )}
        </>
      )}
      <div className="row end wrap">
        <Button onClick={stopComparing}>Keep</Button>
        {!fits && (
          <Button kind="primary" onClick={() => void switchTo(machine, null)}>
            Switch, with its own wire
          </Button>
        )}
        <Button kind={fits ? "primary" : "plain"} why={!to && !problem ? "The comparison is being made." : null} onClick={() => void switchTo(machine, to?.material ?? null)}>
          Switch
        </Button>
      </div>
    </div>
  );
}
