import { useUnit } from "../../../shared/figures/unit";
import { Line } from "../../../shared/lists/Line";
import { useRun } from "../../../state/machine/run";
import { endedPhrase } from "../phrases";

/** What became of the wire that was bent last. */
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
