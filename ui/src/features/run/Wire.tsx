import { useState } from "react";
import { Button } from "../../shared/Button";
import { Bar, Checkbox, Select } from "../../shared/inputs";
import { Line } from "../../shared/Line";
import { Part } from "../../shared/Section";
import { useLengths } from "../../shared/unit";
import { useDesign } from "../../state/design";
import { order } from "../../state/run";
import type { MachineState } from "../../state/operator";
import { buttons } from "./buttons";
import { Ended } from "./Ended";
import { progressPhrase } from "./phrases";
import { useProspect } from "./prospect";
import { UnfinishedCard } from "./UnfinishedCard";

/** Arming, starting, pausing a wire of the design. */
export function Wire({ state }: { readonly state: MachineState }) {
  const check = useDesign((design) => design.check);
  const { long } = useLengths();
  const [chosen, setChosen] = useState(0);
  const [accept, setAccept] = useState(false);
  const all = buttons(state, useProspect());
  const wires = check?.wires ?? [];
  const wire = Math.min(chosen, Math.max(wires.length - 1, 0));
  const differing = state.settings.filter(({ matters }) => matters);
  const needsAccept = differing.length > 0 && !accept ? "The machine is set otherwise than its profile says: see below." : null;
  const under = state.phase === "making" || state.phase === "holding";
  const stock = wires[wire]?.stock_mm;
  return (
    <Part title="Wire" aside={typeof stock === "number" && !under ? <span className="muted small">load {long(stock)} of wire</span> : undefined}>
      {wires.length > 1 && (
        <Select
          aria-label="Wire to make"
          value={String(wire)}
          onChoose={(index) => setChosen(Number(index))}
          choices={wires.map((each, index) => ({ value: String(index), label: `Wire ${index}${each.length_mm === null ? "" : ` · ${long(each.length_mm)}`}` }))}
        />
      )}
      {state.unfinished && !under && <UnfinishedCard unfinished={state.unfinished} all={all} accept={accept} />}
      {differing.length > 0 && (
        <div className="inset stack">
          <ul>
            {differing.map((one) => (
              <Line key={one.name} tone="warning" what={one.name} sub={`The machine has ${one.machine}, the profile says ${one.expected}.`} />
            ))}
          </ul>
          <Checkbox checked={accept} onChange={setAccept}>
            Make wires all the same: they may come out wrong
          </Checkbox>
        </div>
      )}
      {state.wire && under && (
        <div className="stack">
          <Bar done={state.wire.made} of={state.wire.of} label="Wire" />
          <span>{progressPhrase(state.wire)}</span>
        </div>
      )}
      <div className="row">
        {state.phase === "armed" ? (
          <Button className="grow" why={all.disarm} onClick={() => void order({ order: "disarm" })}>
            Disarm
          </Button>
        ) : (
          <Button
            className="grow"
            kind={all.next === "arm" ? "primary" : "plain"}
            why={all.arm ?? needsAccept}
            onClick={() => void order({ order: "arm", wire, accept_settings: accept })}
          >
            Arm…
          </Button>
        )}
        {under ? (
          <Button
            className="grow"
            icon={all.pause.order === "pause" ? "pause" : "play"}
            kind="primary"
            why={all.pause.why}
            onClick={() => void order({ order: all.pause.order })}
          >
            {all.pause.order === "pause" ? "Pause" : "Go on"}
          </Button>
        ) : (
          <Button className="grow" icon="play" kind={all.next === "start" ? "primary" : "plain"} why={all.start} onClick={() => void order({ order: "start" })}>
            Start
          </Button>
        )}
      </div>
      {!under && <Ended />}
    </Part>
  );
}
