import { errorText } from "../../platform/error_text";
import { Button } from "../../shared/controls/Button";
import { Line } from "../../shared/lists/Line";
import type { MachineState } from "../../state/machine/operator";
import { actsOf } from "./acts";
import { useArming } from "./arming";

/** What went wrong with the machine, and what can be done: a button each, with what follows from it. */
export function Fault({ state }: { readonly state: MachineState }) {
  const { problem, phase } = state;
  const arming = useArming(state);
  if (!problem) return null;
  const { acts, others } = actsOf(problem.remedies ?? [], state, arming.all, arming);
  return (
    <div role="alert" className="stack">
      <ul>
        <Line
          tone="error"
          what={phase === "failed" ? "The machine failed" : "That did not work"}
          sub={<span className="lines">{errorText({ message: problem.message, remedies: others })}</span>}
        />
      </ul>
      {acts.map(({ label, consequence, why, run }) => (
        <div key={label} className="row act">
          <Button small why={why} onClick={run}>
            {label}
          </Button>
          <span className="grow muted small">{consequence}</span>
        </div>
      ))}
    </div>
  );
}
