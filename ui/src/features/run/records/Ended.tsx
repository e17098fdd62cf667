import { useEffect, useRef } from "react";
import { useUnit } from "../../../shared/figures/unit";
import { Line } from "../../../shared/lists/Line";
import { dismissAll, tell } from "../../../state/asking/problems";
import { useRun } from "../../../state/machine/run";
import { useUnits } from "../../../state/window/units";
import { endedPhrase } from "../phrases";

const ENDED = "wire-ended";

/** Whether a line of the panel can be read where it is. */
function inSight(line: Element): boolean {
  const { top, bottom } = line.getBoundingClientRect();
  const panel = line.closest(".panel-sections")?.getBoundingClientRect();
  return !panel || (top >= panel.top && bottom <= panel.bottom);
}

/** What became of the wire that was bent last. */
export function Ended() {
  const ended = useRun((run) => run.ended);
  const endedAs = useRun((run) => run.endedAs);
  const unit = useUnit();
  const line = useRef<HTMLUListElement>(null);
  useEffect(() => {
    if (!ended || !line.current || inSight(line.current)) return;
    // Under a pointer that rests in the panel nothing is scrolled: a click that is on its way would move the machine.
    if (!line.current.closest(".panel-sections")?.matches(":hover")) {
      line.current.scrollIntoView({ block: "nearest" });
      return;
    }
    const { tone, what, sub } = endedPhrase(ended, useUnits.getState().unit, endedAs);
    tell(tone === "error" || tone === "warning" ? tone : "info", sub ? `${what}. ${sub}` : `${what}.`, ENDED);
    return () => dismissAll(ENDED);
  }, [ended, endedAs]);
  if (!ended) return null;
  const { tone, what, sub } = endedPhrase(ended, unit, endedAs);
  return (
    <ul ref={line} aria-live="polite">
      <Line tone={tone} what={what} sub={sub} />
    </ul>
  );
}
