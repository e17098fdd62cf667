import { useEffect } from "react";
import type { DiagnosticReport } from "../../generated/responses";
import { count } from "../../shared/figures/format";
import { useDesign } from "../../state/design/design";
import { needFixAll, useFixAll } from "../../state/design/fixes/fix_all";
import { REST } from "../../state/design/fixes/fixes";
import { FixList } from "./FixList";

/** One change for all findings of a kind, with how many it fixes and how many stay; nothing where there is none. */
export function FixAllOffer({ code }: { readonly code: DiagnosticReport["code"] }) {
  const limits = useDesign((design) => design.limits);
  const { of, found } = useFixAll();
  const dragging = useDesign((design) => design.dragged.length > 0);
  useEffect(() => {
    if (!limits || dragging) return;
    const timer = setTimeout(() => void needFixAll(code), REST);
    return () => clearTimeout(timer);
  }, [limits, dragging, code]);
  const answer = of === limits ? found.get(code) : undefined;
  if (answer?.looking)
    return (
      <p className="muted small" role="status">
        Trying all fixes together…
      </p>
    );
  const all = answer?.all;
  if (!all) return null;
  const left = all.of - all.fixed;
  return (
    <section className="fix-all" aria-label="Fix all of this kind">
      <h3>Fix all of this kind</h3>
      <p className="muted small">
        Fixes {count(all.fixed, "place")}, {left === 0 ? "none" : left} left. Undone in one step.
      </p>
      <FixList fixes={[all.fix]} />
    </section>
  );
}
