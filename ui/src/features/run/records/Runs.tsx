import { useEffect } from "react";
import { Fold } from "../../../shared/controls/Fold";
import { count } from "../../../shared/figures/format";
import { useUnit } from "../../../shared/figures/unit";
import { Line } from "../../../shared/lists/Line";
import { loadRuns, useRun } from "../../../state/machine/run";
import { bentNow, madePhrase } from "./records";

/** More are of no interest at a machine. */
const MAX = 30;

/** What was bent before, from the journals of the wires. */
export function Runs() {
  const runs = useRun((run) => run.runs);
  const ended = useRun((run) => run.ended);
  const phase = useRun((run) => run.state?.phase ?? null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: a wire that was begun, interrupted, finished or given up is another record
  useEffect(() => void loadRuns(), [ended, phase]);
  return (
    <Fold title="Runs" phrase={runs === null ? "" : runs.length === 0 ? "none yet" : count(runs.length, "wire")}>
      <List />
    </Fold>
  );
}

function List() {
  const runs = useRun((run) => run.runs);
  const state = useRun((run) => run.state);
  const now = bentNow(runs, state);
  const unit = useUnit();
  if (!runs || runs.length === 0)
    return (
      <p className="muted">
        Each wire that is begun on a machine is kept here, with how far it came out from the design.
      </p>
    );
  return (
    <ul>
      {runs.slice(0, MAX).map((run) => (
        <Line key={run.id} {...madePhrase(run, unit, run === now ? state : null, runs)} title={run.id} />
      ))}
      {runs.length > MAX && <li className="muted small">and {runs.length - MAX} before them</li>}
    </ul>
  );
}
