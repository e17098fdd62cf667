import { Line } from "../../shared/Line";
import { useUnit } from "../../shared/unit";
import { useRun } from "../../state/run";
import { endedPhrase } from "./phrases";

/** What became of the wire that was made last. */
export function Ended() {
  const ended = useRun((run) => run.ended);
  const unit = useUnit();
  if (!ended) return null;
  const { tone, what, sub } = endedPhrase(ended, unit);
  return (
    <ul aria-live="polite">
      <Line tone={tone} what={what} sub={sub} />
    </ul>
  );
}
