import { Button } from "../../shared/controls/Button";
import { Either } from "../../shared/controls/Either";
import { Line } from "../../shared/lists/Line";
import { useDesign } from "../../state/design/design";
import { makeProgram, useProgram, useStale } from "../../state/program/program";
import { useUi } from "../../state/window/ui";

/** Whether the program is that of the design, and how it is made. */
export function Generate() {
  const { program, asking, problem } = useProgram();
  const stale = useStale();
  const empty = useDesign((design) => design.edges.size === 0);
  const showSection = useUi((ui) => ui.showSection);
  const made = program !== null && program.wires.length > 0;
  const toCheck = (
    <Button kind="link" aria-controls="section-check" onClick={() => showSection("check")}>
      Check
    </Button>
  );
  if (!made && !asking && (problem || program)) {
    return (
      <ul>
        <Line
          tone="error"
          what="No program for this design"
          sub={problem ?? "It cannot be bent as it is. Check shows why."}
          action={toCheck}
        />
      </ul>
    );
  }
  const partly = made && (!program.feasible || program.without > 0);
  if (made && !stale && !partly) return null;
  return (
    <div className="stack">
      {(!made || stale) && (
        <div className="row">
          <span className="grow muted">
            {made ? "The design or its machine was changed since." : "Generates the machine's steps from the design."}
          </span>
          <Button
            kind="primary"
            why={empty ? "Draw or open a design first." : asking ? "The program is being generated." : null}
            onClick={() => void makeProgram()}
          >
            {made ? <Either shown="Update" other="Generate" /> : <Either shown="Generate" other="Update" />}
          </Button>
        </div>
      )}
      {partly && (
        <ul>
          <Line
            tone="warning"
            what="Partial program"
            sub={program.without > 0 ? "Some wires have no program." : "The machine cannot bend all of it."}
            action={toCheck}
          />
        </ul>
      )}
    </div>
  );
}
