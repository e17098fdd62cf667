import { useState } from "react";
import { Button } from "../../shared/controls/Button";
import { Bar, Checkbox, Select } from "../../shared/controls/inputs";
import { useLengths } from "../../shared/figures/unit";
import { useDesign } from "../../state/design/design";
import { isInWire, type MachineState } from "../../state/machine/operator";
import { setPieces, setStock, useRow } from "../../state/machine/row";
import { order } from "../../state/machine/run";
import { useOtherWire } from "../../state/program/program";
import { useRunFile } from "../../state/program/run_file";
import { Anyway } from "../check/Anyway";
import { Part } from "../panel/Section";
import { buttons } from "./buttons";
import { Differing } from "./Differing";
import { Pieces } from "./Pieces";
import { leftPhrase, progressPhrase } from "./phrases";
import { useProspect } from "./prospect";
import { Ended } from "./records/Ended";
import { Speed } from "./Speed";
import { UnfinishedCard } from "./UnfinishedCard";

/** Arming, starting, pausing a wire of the design. */
export function Wire({ state }: { readonly state: MachineState }) {
  const check = useDesign((design) => design.check);
  const { length, long } = useLengths();
  const [chosen, setChosen] = useState(0);
  const [accept, setAccept] = useState(false);
  const version = useDesign((design) => design.version);
  const [wanted, setWanted] = useState<{ readonly version: number; readonly file: unknown } | null>(null);
  const { pieces, stockMm, row } = useRow();
  const [cut, setCut] = useState(true);
  const otherWire = useOtherWire();
  const prospect = useProspect();
  const all = buttons(state, prospect);
  const file = useRunFile((run) => run.file);
  // What a person wants all the same is this design, not what it becomes.
  const anyway = wanted !== null && wanted.version === version && wanted.file === file;
  const setAnyway = (on: boolean) => setWanted(on ? { version, file } : null);
  const wires = file ? file.wires : (check?.wires ?? []);
  const wire = Math.min(chosen, Math.max(wires.length - 1, 0));
  const needsAccept =
    state.settings.some(({ matters }) => matters) && !accept
      ? "The machine is set otherwise than its profile says: see below."
      : null;
  // What the machine cannot make is armed where a person wants it all the same.
  const refused = prospect.program && !prospect.feasible && (file ? file.kind === "program" : wires.length > 0);
  const despite = refused && all.arm === all.noWire && anyway;
  const whyNot = (despite ? null : all.arm) ?? needsAccept;
  const under = isInWire(state.phase);
  const busy = under ? "A wire is being bent." : null;
  const stock = wires[wire]?.stock_mm;
  return (
    <Part
      // Both are in sight, the file here and the design behind it: this says which of them is bent.
      title={file ? `Wire of ${file.name}` : "Wire of the design"}
      aside={
        typeof stock === "number" && !under ? (
          <span className="muted small">load {long(stock)} of wire</span>
        ) : undefined
      }
    >
      {wires.length > 1 && (
        <Select
          aria-label="Wire to bend"
          value={String(wire)}
          onChoose={(index) => setChosen(Number(index))}
          choices={wires.map((each, index) => ({
            value: String(index),
            label: `Wire ${index + 1}${each.length_mm === null ? "" : ` · ${length(each.length_mm)}`}`,
          }))}
        />
      )}
      {state.unfinished && !under && <UnfinishedCard unfinished={state.unfinished} all={all} accept={accept} />}
      {state.settings.length > 0 && (
        <Differing settings={state.settings} why={all.writeSettings} accept={accept} onAccept={setAccept} />
      )}
      {refused &&
        (file ? (
          <Checkbox checked={anyway} onChange={setAnyway} why={busy}>
            Bend it anyway, although the machine cannot make it
          </Checkbox>
        ) : (
          <Anyway checked={anyway} onChange={setAnyway} why={busy}>
            Bend it anyway
          </Anyway>
        ))}
      {/* What is set before a wire stays, and what comes with it is below: Pause stands where Start stood. */}
      <Pieces pieces={pieces} stock={stockMm} why={busy} onPieces={setPieces} onStock={setStock} />
      {state.cutter_mm !== null && (
        <Checkbox checked={cut} onChange={setCut} why={busy}>
          Cut each piece off
        </Checkbox>
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
            why={whyNot}
            onClick={() =>
              void order({
                order: "arm",
                wire,
                accept_settings: accept,
                despite_errors: despite,
                repeat: { pieces, stock_mm: stockMm, cut: cut && state.cutter_mm !== null },
              })
            }
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
            {all.pause.order === "pause" ? "Pause" : "Resume"}
          </Button>
        ) : (
          <Button
            className="grow"
            icon="play"
            kind={all.next === "start" ? "primary" : "plain"}
            why={all.start}
            onClick={() => void order({ order: "start" })}
          >
            Start
          </Button>
        )}
      </div>
      {row && !under && <p className="muted small">{leftPhrase(row, state.unfinished !== null)}</p>}
      {state.wire && under && (
        <div className="stack">
          <Bar done={state.wire.made} of={state.wire.of} label="Wire" />
          <span>{progressPhrase(state.wire)}</span>
          {state.wire.stock_left_mm !== null && (
            <span className="muted small">{long(state.wire.stock_left_mm)} of wire before this piece</span>
          )}
          {otherWire && <p className="muted small">{otherWire}</p>}
          {state.speed_percent !== null && <Speed percent={state.speed_percent} why={all.speed} />}
        </div>
      )}
      {!under && (
        <Button
          why={(despite && all.dryRun === all.noWire ? null : all.dryRun) ?? needsAccept}
          title="Every move of the wire at a quarter of its speed, without wire and with the peg in"
          onClick={() => void order({ order: "dry-run", wire, accept_settings: accept, despite_errors: despite })}
        >
          Dry run…
        </Button>
      )}
      {all.noWire && !(refused && !file) && (state.phase === "ready" || state.phase === "moving") && (
        <p className="muted small">{all.noWire}</p>
      )}
      {!under && <Ended />}
    </Part>
  );
}
