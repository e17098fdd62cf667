import { Button } from "../../shared/controls/Button";
import { Bar, Checkbox, Select } from "../../shared/controls/inputs";
import { useLengths } from "../../shared/figures/unit";
import { Line } from "../../shared/lists/Line";
import type { MachineState } from "../../state/machine/operator";
import { setCut, setPieces, setStock, setWire, useRow } from "../../state/machine/row";
import { isBending, order, PAUSE_BUTTON, useRun } from "../../state/machine/run";
import { useOtherWire } from "../../state/program/program";
import { useRunFile } from "../../state/program/run_file";
import { Anyway } from "../check/Anyway";
import { Part } from "../panel/Section";
import { useArming } from "./arming";
import { Differing } from "./Differing";
import { Pieces } from "./Pieces";
import { leftPhrase, loadPhrase, progressPhrase, restPhrase } from "./phrases";
import { Ended } from "./records/Ended";
import { Speed } from "./Speed";
import { UnfinishedCard } from "./UnfinishedCard";

const ALL = "all";
/** Its driver has no cutter, or the profile does not say where it is. */
const NO_CUTTER = "This machine has no cutter that the program knows of: cut each piece off by hand.";

/** Arming, starting, pausing the wires of the design. */
export function Wire({ state }: { readonly state: MachineState }) {
  const { length, long } = useLengths();
  const { pieces, stockMm, rest, row } = useRow();
  const arming = useArming(state);
  const { all, wires, wire, cuts, refused, anyway, setAnyway, accept } = arming;
  const armed = state.phase === "armed";
  const otherWire = useOtherWire(armed);
  const file = useRunFile((run) => run.file);
  const under = useRun(isBending);
  // What is set is for the next wire that is armed.
  const busy = under ? "A wire is being bent." : armed ? "The machine is armed. Disarm it to change this." : null;
  const [one, several] = file
    ? [`Wire of ${file.name}`, `Wires of ${file.name}`]
    : ["Wire of the design", "Wires of the design"];
  return (
    <Part
      // Both are in sight, the file here and the design behind it: this says which of them is bent.
      title={armed && otherWire ? "The wire that is armed" : wires.length > 1 ? several : one}
      aside={under || otherWire ? undefined : <span className="muted small">{loadPhrase(arming, long)}</span>}
    >
      {wires.length > 1 && (
        <Select
          aria-label="Wire to bend"
          disabled={busy !== null}
          value={wire === null ? ALL : String(wire)}
          onChoose={(index) => setWire(index === ALL ? null : Number(index))}
          choices={[
            { value: ALL, label: `All ${wires.length} wires, one after the other` },
            ...wires.map((each, index) => ({
              value: String(index),
              label: `Wire ${index + 1}${each.length_mm === null ? "" : ` · ${length(each.length_mm)}`}`,
            })),
          ]}
        />
      )}
      {state.unfinished && !under && <UnfinishedCard unfinished={state.unfinished} all={all} accept={accept} />}
      {state.settings.length > 0 && (
        <Differing settings={state.settings} why={all.writeSettings} accept={accept} onAccept={arming.setAccept} />
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
      <Pieces
        pieces={under && row ? row.of : pieces}
        stock={stockMm}
        why={busy}
        onPieces={setPieces}
        onStock={setStock}
      />
      <Checkbox checked={cuts} onChange={setCut} why={busy ?? (state.cutter_mm === null ? NO_CUTTER : null)}>
        Cut each piece off
      </Checkbox>
      <div className="row run-main">
        {armed ? (
          <Button className="grow" why={all.disarm} onClick={() => void order({ order: "disarm" })}>
            Disarm
          </Button>
        ) : (
          <Button
            className="grow"
            kind={all.next === "arm" ? "primary" : "plain"}
            why={arming.why}
            onClick={arming.arm}
          >
            Arm…
          </Button>
        )}
        {under ? (
          <Button
            id={PAUSE_BUTTON}
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
      {armed && otherWire && (
        <ul aria-live="polite">
          <Line tone="warning" what={otherWire} />
        </ul>
      )}
      {rest.length > 0 && !under && <p className="muted small">{restPhrase(rest, state.unfinished !== null)}</p>}
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
          why={arming.whyNotDry}
          title="Every move of the wire at a quarter of its speed, without wire and with the peg in"
          onClick={arming.dryRun}
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
