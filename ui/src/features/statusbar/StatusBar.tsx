import { useMemo } from "react";
import { Icon } from "../../shared/controls/icons";
import { Bar } from "../../shared/controls/inputs";
import { count } from "../../shared/figures/format";
import { useUnit } from "../../shared/figures/unit";
import { Mark } from "../../shared/lists/Mark";
import { useProblems } from "../../state/asking/problems";
import { useWork } from "../../state/asking/work";
import { useKnown } from "../../state/design/collisions";
import { useDesign } from "../../state/design/design";
import { lengthOf } from "../../state/design/geometry";
import { useRunFile } from "../../state/program/run_file";
import { useUi } from "../../state/window/ui";
import { checksOfFile, checksPhrase, figures, figuresOfFile, savedPhrase, workPhrase } from "./figures";
import "./statusbar.css";

/** Figures of the design, and how things stand. */
export function StatusBar() {
  const { check, state, vertices, edges } = useDesign();
  const unit = useUnit();
  const messages = useProblems((problems) => problems.problems.length);
  const showSection = useUi((ui) => ui.showSection);
  const file = useRunFile((run) => run.file);
  const known = useKnown();
  const checks = file ? checksOfFile(file) : checksPhrase(check, known);
  const saved = savedPhrase(state);
  const drawn = useMemo(() => lengthOf(edges.keys(), { vertices, edges }), [vertices, edges]);
  return (
    // biome-ignore lint/a11y/useAriaPropsSupportedByRole: it belongs to the body, and is a landmark with a name
    <footer className="status-bar" aria-label="Status">
      <dl className="status-figures">
        {(file ? figuresOfFile(file, unit) : figures(check, drawn, unit)).map(({ name, value, title }) => (
          <div key={name} title={title}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      <Underway />
      {saved.warning && (
        <span className="status-part warning" role="alert" title={saved.warning}>
          <Icon name="warning" /> changes are not backed up: save now
        </span>
      )}
      <span className="status-part">{saved.text}</span>
      {messages > 0 && <span className="status-part">{count(messages, "message")}</span>}
      {checks && (
        <button
          type="button"
          className={`status-part status-checks ${checks.tone}`}
          title={checks.tone === "fine" ? "Within the machine's limits. Show the checks" : "Show the checks"}
          onClick={() => showSection(file ? "run" : "check")}
        >
          <Mark tone={checks.tone} />
          <span>{checks.text}</span>
        </button>
      )}
    </footer>
  );
}

/** Long work that is under way. */
function Underway() {
  const works = useWork((store) => store.works);
  const work = [...works.values()].findLast(({ stage, of }) => stage !== "" || of > 0);
  if (!work) return null;
  const phrase = workPhrase(work.ask, work.stage);
  return (
    <span className="status-part status-work" title={work.stage}>
      <span>{phrase}</span>
      <Bar done={work.done} of={work.of} label={phrase} />
    </span>
  );
}
