import { Button } from "../../shared/Button";
import { Line } from "../../shared/Line";
import { useDesign } from "../../state/design";
import { makeProgram, useProgram, useStale } from "../../state/program";
import { useUi } from "../../state/ui";

/** Whether the program is that of the design, and how it is made. */
export function Generate() {
  const { program, asking, problem } = useProgram();
  const stale = useStale();
  const empty = useDesign((design) => design.edges.size === 0);
  const showSection = useUi((ui) => ui.showSection);
  const made = program !== null && program.wires.length > 0;
  const toCheck = (
    <Button kind="link" onClick={() => showSection("check")}>
      Check
    </Button>
  );
  if (!made && !asking && (problem || program)) {
    return (
      <ul>
        <Line tone="error" what="There is no program for this design" sub={problem ?? "No wire can be made of it as it is: Check says why."} action={toCheck} />
      </ul>
    );
  }
  const partly = made && (!program.feasible || program.without > 0);
  if (made && !stale && !partly) return null;
  return (
    <div className="stack">
      {(!made || stale) && (
        <div className="row">
          <span className="grow muted">{made ? "The design has changed since." : "From the design to the steps of the machine."}</span>
          <Button kind="primary" why={empty ? "Draw or open something first." : asking ? "The program is being made." : null} onClick={() => void makeProgram()}>
            {made ? "Update" : "Generate"}
          </Button>
        </div>
      )}
      {partly && (
        <ul>
          <Line
            tone="warning"
            what="Shown as far as it goes"
            sub={program.without > 0 ? "Some wires have no program." : "The machine cannot make all of it."}
            action={toCheck}
          />
        </ul>
      )}
    </div>
  );
}
