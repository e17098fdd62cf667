import { useEffect } from "react";
import { count, sentence } from "../../shared/format";
import { Checkbox } from "../../shared/inputs";
import { Line } from "../../shared/Line";
import { Section } from "../../shared/Section";
import { useDesign } from "../../state/design";
import { needFixes } from "../../state/fixes";
import { useUi } from "../../state/ui";
import { setAnnotations, useView } from "../../state/view";
import { isCompensated } from "../viewport/marks";
import { GroupLine } from "./GroupLine";
import { fineOf, groupsOf, phraseOf } from "./texts";
import "./check.css";

/** Fixes are asked for once the design has come to rest, ms. */
const REST = 350;

/** What the machine cannot make and why, what is near a limit, and what is fine. */
export function CheckSection() {
  const { check, state, vertices } = useDesign();
  const open = useUi((ui) => ui.open.includes("check"));
  const annotations = useView((view) => view.annotations);
  const { phrase, tone } = phraseOf(check, Boolean(state?.machine), vertices.size === 0);
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
          <p className="muted">As soon as there is an edge, the machine's limits are checked with every change.</p>
        ) : !state?.machine ? (
          <p className="muted">Choose a machine in the bar at the top: its limits are what is checked.</p>
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
              {check && isCompensated(check) && <Line tone="info" what="Whether it meets the machine or itself is not checked" />}
            </ul>
            <Checkbox checked={annotations} onChange={setAnnotations}>
              Annotations in the view
            </Checkbox>
          </>
        )}
      </Section>
      <p className="visually-hidden" aria-live="polite">
        {check && vertices.size > 0 ? `Check: ${phrase}${check.wires.length > 1 ? `, ${count(check.wires.length, "wire")}` : ""}` : ""}
      </p>
    </>
  );
}
