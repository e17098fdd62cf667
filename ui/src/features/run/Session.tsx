import { Button } from "../../shared/controls/Button";
import { Bar } from "../../shared/controls/inputs";
import { Line } from "../../shared/lists/Line";
import { useMachines } from "../../state/machine/machines";
import type { MachineState } from "../../state/machine/operator";
import { isBending, order, useRun } from "../../state/machine/run";
import { useRunFile, useRunMachine } from "../../state/program/run_file";
import { buttons, doingPhrase } from "./buttons";
import { Fault } from "./Fault";
import { machinePhrase, simulatedPhrase } from "./phrases";
import { useProspect } from "./prospect";

/** It takes as long as the slowest axis needs for its way, which no machine tells beforehand. */
const HOMING = "Axes move to find zero. STOP ends it.";

/** Which machine is connected, how it stands, homing, and disconnecting. */
export function Session({ state }: { readonly state: MachineState }) {
  const designed = useRunMachine();
  const file = useRunFile((run) => run.file);
  const machines = useMachines((store) => store.machines);
  const all = buttons(state, useProspect());
  const bending = useRun(isBending);
  const name = (id: string | null) => machines?.find((machine) => machine.id === id)?.name ?? id ?? "none";
  const simulated = simulatedPhrase(state.simulated_as, name);
  const other = designed !== state.machine;
  const homing = state.phase === "homing" && !state.question;
  const who = machinePhrase(name(state.machine), state);
  return (
    <div className="stack">
      <div className="run-state" role="status">
        <span className={`run-phase ${state.phase}`}>{doingPhrase(state)}</span>
        <span className="small">{homing && HOMING}</span>
        <span className="muted small" title={state.identity ?? undefined}>
          {who}
        </span>
        {homing && <Bar label="Homing" done={0} of={0} />}
        {simulated && <span className="muted small">{simulated}</span>}
      </div>
      <Fault state={state} />
      {other && (
        <ul>
          <Line
            tone="warning"
            what={`${file ? file.name : "The design"} is for ${name(designed)}`}
            sub={
              all.disconnect === null
                ? `${name(state.machine)} is connected. Disconnect it to connect the other one.`
                : bending
                  ? `${name(state.machine)} is connected and at work. Finish the wire or stop it first, then disconnect to connect the other one.`
                  : `${name(state.machine)} is connected. Disconnect it once it is done, to connect the other one.`
            }
          />
        </ul>
      )}
      <div className="row">
        <Button
          className="grow"
          icon="home"
          kind={all.next === "home" ? "primary" : "plain"}
          why={all.home}
          onClick={() => void order({ order: "home" })}
        >
          Home
        </Button>
        <Button className="grow" why={all.disconnect} onClick={() => void order({ order: "disconnect" })}>
          Disconnect
        </Button>
      </div>
      {state.phase === "stopped" && all.home === null && (
        <p className="muted small">Home moves the axes at once, until their place is known.</p>
      )}
    </div>
  );
}
