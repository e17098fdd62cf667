import { useEffect, useState } from "react";
import type { SimulatedAs } from "../../generated/requests";
import { errorText } from "../../platform/error_text";
import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Select } from "../../shared/controls/inputs";
import { useUnit } from "../../shared/figures/unit";
import { Line } from "../../shared/lists/Line";
import { useMachines } from "../../state/machine/machines";
import { choosePort, connect, isOpen, loadPorts, useRun } from "../../state/machine/run";
import { useRunMachine } from "../../state/program/run_file";
import { guess, portPhrase } from "./phrases";
import { Ended } from "./records/Ended";
import { interruptedPhrase } from "./records/records";
import { Simulated } from "./Simulated";

/** Choosing a port, and connecting: the first time, or again after the machine has failed. */
export function Connect() {
  const machine = useRunMachine();
  const { ports, portProblem, chosenPorts, ordering, state, runs } = useRun();
  const unit = useUnit();
  const interrupted = interruptedPhrase(runs, unit);
  const chosen = machine ? (chosenPorts.get(machine) ?? null) : null;
  const [as, setAs] = useState<SimulatedAs>({});
  useEffect(() => {
    if (machine) void loadPorts();
    setAs({});
  }, [machine]);
  const known = ports ?? [];
  const port = known.find(({ name }) => name === chosen)?.name ?? guess(known);
  const why = !machine
    ? "Choose a machine first."
    : ordering
      ? "The machine is being connected."
      : known.length === 0
        ? (portProblem ?? "There is no port.")
        : port === null
          ? "Choose a port."
          : null;
  const hasPeg = useMachines(({ machines }) => machines?.find(({ id }) => id === machine)?.has_peg ?? false);
  const simulated = known.find(({ name }) => name === port)?.simulated ?? false;
  // Of a session that has failed what went wrong, and what became of its wire, is shown elsewhere in the section.
  const again = isOpen(state);
  return (
    <div className="stack">
      {!again && state?.problem && (
        <div role="alert">
          <ul>
            <Line
              tone="error"
              what="The machine failed"
              sub={<span className="lines">{errorText(state.problem)}</span>}
            />
          </ul>
        </div>
      )}
      {!again && <Ended />}
      {state === null && interrupted && (
        <ul>
          <Line tone="warning" {...interrupted} />
        </ul>
      )}
      <Field label="Port" stacked hint={simulated ? "Simulation: no motors move." : null}>
        {(ids) => (
          <span className="row">
            <Select
              {...ids}
              value={port ?? ""}
              onChoose={(name) => machine && choosePort(machine, name)}
              choices={[
                ...(port === null
                  ? [{ value: "", label: ports === null ? "looking…" : known.length === 0 ? "none" : "choose" }]
                  : []),
                ...known.map((each) => ({ value: each.name, label: portPhrase(each) })),
              ]}
            />
            <Button
              icon="reset"
              aria-label="Look for ports again"
              title="Look for ports again"
              why={machine ? null : "Choose a machine first."}
              onClick={() => void loadPorts()}
            />
          </span>
        )}
      </Field>
      {simulated && machine && hasPeg && <Simulated machine={machine} as={as} onChoose={setAs} />}
      {portProblem && (
        <ul>
          <Line
            tone={known.length > 0 ? "warning" : "info"}
            what={known.length > 0 ? "A driver could not be asked" : "There is no port for this machine"}
            sub={portProblem}
          />
        </ul>
      )}
      <div className="row end">
        <Button kind="primary" why={why} onClick={() => void connect(port, simulated && hasPeg ? as : {})}>
          {again ? "Connect again" : "Connect"}
        </Button>
      </div>
      {again && <p className="muted small">Closes the failed connection. Connecting moves nothing.</p>}
    </div>
  );
}
