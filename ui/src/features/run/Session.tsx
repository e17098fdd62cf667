import { Button } from "../../shared/Button";
import { Line } from "../../shared/Line";
import { useLengths } from "../../shared/unit";
import { useDesign } from "../../state/design";
import { useMachines } from "../../state/machines";
import { order } from "../../state/run";
import type { MachineState } from "../../state/operator";
import { worded } from "../../state/wording";
import { buttons, doingPhrase } from "./buttons";
import { useProspect } from "./prospect";

/** Who is connected, how it stands, homing, and parting. */
export function Session({ state }: { readonly state: MachineState }) {
  const designed = useDesign((design) => design.state?.machine ?? null);
  const machines = useMachines((store) => store.machines);
  const { said } = useLengths();
  const all = buttons(state, useProspect());
  const name = (id: string | null) => machines?.find((machine) => machine.id === id)?.name ?? id ?? "none";
  const other = designed !== state.machine;
  return (
    <div className="stack">
      <div className="run-state" role="status">
        <span className={`run-phase ${state.phase}`}>{doingPhrase(state)}</span>
        <span className="muted">
          {name(state.machine)} · {state.simulated ? "simulated" : (state.port ?? "")}
        </span>
        {state.identity && <span className="muted small">{state.identity}</span>}
      </div>
      {state.problem && (
        <div role="alert">
          <ul>
            <Line tone="error" what={state.phase === "failed" ? "The machine failed" : "That did not work"} sub={<span className="lines">{said(worded(state.problem))}</span>} />
          </ul>
        </div>
      )}
      {other && (
        <ul>
          <Line tone="warning" what={`The design is for ${name(designed)}`} sub={`${name(state.machine)} is connected. Disconnect it to connect the other one.`} />
        </ul>
      )}
      <div className="row">
        <Button className="grow" icon="home" kind={all.next === "home" ? "primary" : "plain"} why={all.home} onClick={() => void order({ order: "home" })}>
          Home
        </Button>
        <Button className="grow" why={all.disconnect} onClick={() => void order({ order: "disconnect" })}>
          Disconnect
        </Button>
      </div>
    </div>
  );
}
