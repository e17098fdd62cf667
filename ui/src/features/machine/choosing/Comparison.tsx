import { useEffect, useRef } from "react";
import type { OtherSide } from "../../../generated/responses";
import { Button } from "../../../shared/controls/Button";
import { Bar } from "../../../shared/controls/inputs";
import { useUnit } from "../../../shared/figures/unit";
import { Line } from "../../../shared/lists/Line";
import { stopComparing, switchTo, useMachines } from "../../../state/machine/machines";
import { differences, figures } from "./differences";

/** What another machine changes for the design, and switching to it. */
export function Comparison() {
  const { compared, machines, materials } = useMachines();
  const unit = useUnit();
  const box = useRef<HTMLElement>(null);
  const answered = Boolean(compared?.to ?? compared?.problem);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the answer makes it longer
  useEffect(() => {
    // Newer engines return a promise, which is nothing to end an effect with.
    void box.current?.scrollIntoView({ block: "nearest" });
  }, [answered]);
  if (!compared) return null;
  const { machine, from, to, problem } = compared;
  const own = to?.own_wire ?? null;
  const misfit = to !== null && !to.fits;
  const name = machines?.find(({ id }) => id === machine)?.name ?? machine;
  const wireOf = (side: OtherSide) => materials?.find(({ id }) => id === side.material)?.name ?? side.material;
  // What is recommended is what is shown.
  const side = own ?? to;
  return (
    <section ref={box} className="comparison" aria-label={`With ${name}`} aria-live="polite">
      {!to && !problem && (
        <>
          <p className="muted">Planning the design for {name}…</p>
          <Bar done={0} of={0} label="Comparing" />
        </>
      )}
      {problem && (
        <ul>
          <Line tone="error" what="Cannot compare" sub={problem} />
        </ul>
      )}
      {from && to && side && (
        <>
          {own && (
            <>
              <ul>
                {misfit ? (
                  <Line tone="error" what={`${wireOf(to)} does not fit it`} sub={null} />
                ) : (
                  <Line
                    tone="info"
                    what={`It has a wire of its own: ${wireOf(own)}`}
                    sub={`It is based on ${wireOf(to)}.`}
                  />
                )}
              </ul>
              <p className="comparison-wire">With its own wire, {wireOf(own)}</p>
            </>
          )}
          <ul>
            {differences(from, side).map((one) => (
              <Line key={`${one.what} ${one.sub}`} tone={one.tone} what={one.what} sub={one.sub} />
            ))}
          </ul>
          <dl className="comparison-figures">
            {figures(from, side, unit).map(([title, phrase]) => (
              <div key={title}>
                <dt>{title}</dt>
                <dd>{phrase}</dd>
              </div>
            ))}
          </dl>
        </>
      )}
      <div className="row end wrap">
        <Button onClick={stopComparing}>Cancel</Button>
        {own && (
          <Button kind="primary" onClick={() => void switchTo(machine, own.material)}>
            Switch, with its own wire
          </Button>
        )}
        <Button
          kind={own ? "plain" : "primary"}
          why={!to && !problem ? "Comparing…" : null}
          onClick={() => void switchTo(machine, to?.material ?? null)}
        >
          {own ? "Switch, with this wire" : "Switch"}
        </Button>
      </div>
    </section>
  );
}
