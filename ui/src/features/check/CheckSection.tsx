import { useEffect } from "react";
import { Checkbox } from "../../shared/controls/inputs";
import { count, sentence } from "../../shared/figures/format";
import { Line } from "../../shared/lists/Line";
import { useKnown } from "../../state/design/collisions";
import { useDesign } from "../../state/design/design";
import { needFixes, REST } from "../../state/design/fixes/fixes";
import { useUi } from "../../state/window/ui";
import { setAnnotations, useView } from "../../state/window/view";
import { Section } from "../panel/Section";
import { Accuracy } from "./Accuracy";
import { Collisions } from "./Collisions";
import { GroupLine } from "./GroupLine";
import { fineOf, groupsOf, phraseOf } from "./texts";
import "./check.css";

/** What the machine cannot make and why, what is near a limit, and what is fine. */
export function CheckSection() {
  const { check, state, vertices } = useDesign();
  const open = useUi((ui) => ui.open.includes("check"));
  const annotations = useView((view) => view.annotations);
  const { phrase, tone } = phraseOf(check, Boolean(state?.machine), vertices.size === 0, useKnown());
  useEffect(() => {
    if (!open || !check?.diagnostics.some(({ severity }) => severity !== "info")) return;
    const timer = setTimeout(() => void needFixes(), REST);
    return () => clearTimeout(timer);
  }, [check, open]);
  const groups = check ? groupsOf(check) : [];
  const fine = check && vertices.size > 0 ? fineOf(check) : [];
  return (
    <>
      <Section id="check" title="Check" phrase={phrase} tone={tone}>
        {vertices.size === 0 ? (
          <p className="muted">Draw an edge. Every change is then checked against the machine's limits.</p>
        ) : !state?.machine ? (
          <p className="muted">Choose a machine in the top bar. The design is checked against its limits.</p>
        ) : (
          <>
            <ul className="check-list">
              {groups.map((group) => (
                <GroupLine key={group.key} group={group} />
              ))}
              {fine.map((text) => (
                <Line key={text} tone="fine" what={text} />
              ))}
              {check?.limits_unknown && <Line tone="warning" what={sentence(check.limits_unknown)} />}
              <Collisions />
            </ul>
            <Checkbox checked={annotations} onChange={setAnnotations}>
              Annotations in the view
            </Checkbox>
            <Accuracy />
          </>
        )}
      </Section>
      <p className="visually-hidden" aria-live="polite">
        {check && vertices.size > 0
          ? `Check: ${phrase}${check.wires.length > 1 ? `, ${count(check.wires.length, "wire")}` : ""}`
          : ""}
      </p>
    </>
  );
}
