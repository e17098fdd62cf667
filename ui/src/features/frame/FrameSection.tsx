import { Button } from "../../shared/controls/Button";
import { Bar } from "../../shared/controls/inputs";
import { sentence } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { Line } from "../../shared/lists/Line";
import { useWork } from "../../state/asking/work";
import { useDesign } from "../../state/design/design";
import { cancelFrame, computeFrame, useFrame, useFrameStale } from "../../state/frame/frame";
import { Section } from "../panel/Section";
import { Closed } from "./Closed";
import { Files } from "./Files";
import { Results } from "./Results";
import { ClosingSetup, Setup } from "./Setup";
import { Shown } from "./Shown";
import { Tolerance } from "./Tolerance";
import { phraseOf } from "./words";
import "./frame.css";

/** The design as a structure: what it carries, how it vibrates, and how accurate it is once its joints are closed. */
export function FrameSection() {
  const { answer, asking, problem } = useFrame();
  const stale = useFrameStale();
  const unit = useUnit();
  const empty = useDesign((design) => design.edges.size === 0);
  const wrong = answer ? !answer.value.result.holds : problem !== null;
  const phrase = asking
    ? "computing…"
    : stale
      ? "changed since"
      : answer
        ? phraseOf(answer.value, unit)
        : problem
          ? "not computed"
          : "not computed yet";
  return (
    <Section
      id="frame"
      title="Frame"
      phrase={phrase}
      tone={asking ? null : wrong ? "error" : stale ? "warning" : answer ? "fine" : null}
    >
      {empty ? (
        <div className="stack">
          <p className="muted">Draw or open a design. Its edges are then computed as struts that are rigidly joined.</p>
          <Tolerance />
        </div>
      ) : (
        <div className="stack">
          <Setup />
          <ClosingSetup />
          <Compute />
          <div className="stack frame-below">
            {problem && (
              <ul>
                <Line tone="error" what="The frame was not computed" sub={problem} />
              </ul>
            )}
            {answer && (
              <>
                <Results shown={answer.value} />
                <Shown />
                <Closed shown={answer.value} faces={answer.faces} />
                <Files />
              </>
            )}
            <Tolerance />
          </div>
        </div>
      )}
    </Section>
  );
}

function Compute() {
  const { asking, cancelled } = useFrame();
  const stale = useFrameStale();
  const work = useWork(({ works }) => works.get("frame"));
  return (
    <>
      <div className="row">
        <span className="grow muted small" role="status">
          {asking
            ? `${sentence(work?.stage || "computing")}…`
            : cancelled
              ? "Cancelled."
              : stale
                ? "Changed since it was computed."
                : ""}
        </span>
        {asking ? (
          <Button className="frame-go" onClick={cancelFrame}>
            Cancel
          </Button>
        ) : (
          <Button kind="primary" className="frame-go" onClick={() => void computeFrame()}>
            Compute
          </Button>
        )}
      </div>
      <div className="frame-bar">{asking && <Bar done={work?.done ?? 0} of={work?.of ?? 0} label="Computing" />}</div>
    </>
  );
}
