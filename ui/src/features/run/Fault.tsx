import type { ProblemReport } from "../../generated/responses";
import { errorText } from "../../platform/error_text";
import { Button } from "../../shared/controls/Button";
import { Line } from "../../shared/lists/Line";
import type { MachineState } from "../../state/machine/operator";
import { useRun } from "../../state/machine/run";
import { actsOf } from "./acts";
import { useArming } from "./arming";

/** What is to be said: first why the connection has failed, then what was ordered of it since and did not work. */
function problemsOf({ phase, problem }: MachineState, cause: ProblemReport | null): readonly ProblemReport[] {
  if (phase !== "failed" || !cause) return problem ? [problem] : [];
  const same = !problem || JSON.stringify(problem) === JSON.stringify(cause);
  // That its driver was ended follows from the failure, and says nothing more.
  return same || problem.code === "driver-ended" ? [cause] : [cause, problem];
}

/** What went wrong with the machine, and what can be done: a button each, with what follows from it. */
export function Fault({ state }: { readonly state: MachineState }) {
  const cause = useRun((run) => run.cause);
  const arming = useArming(state);
  const problems = problemsOf(state, cause);
  if (problems.length === 0) return null;
  const remedies = problems.map((problem) => actsOf(problem.remedies ?? [], state, arming.all, arming));
  const acts = new Map(remedies.flatMap((each) => each.acts.map((act) => [act.label, act] as const)));
  return (
    <div role="alert" className="stack">
      <ul>
        {problems.map(({ message }, index) => (
          <Line
            // biome-ignore lint/suspicious/noArrayIndexKey: the first cause, and what came of it
            key={index}
            tone="error"
            what={state.phase === "failed" && index === 0 ? "The machine failed" : "That did not work"}
            sub={<span className="lines">{errorText({ message, remedies: remedies[index]?.others ?? [] })}</span>}
          />
        ))}
      </ul>
      {[...acts.values()].map(({ label, consequence, why, run }) => (
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
