import { Button } from "../../shared/controls/Button";
import { useUnit } from "../../shared/figures/unit";
import {
  hideSequence,
  shownSequence,
  slideTo,
  stepAt,
  togglePlaySequence,
  useSequence,
} from "../../state/sequence/sequence";
import { displacement } from "../frame/words";
import { KINDS, placedName } from "../sequence/words";
import { movesOf, Track } from "./Track";

/** The steps of building under the view, while they are shown there instead of a program. */
export function BuildTimeline() {
  const { found, changed, at, playing } = useSequence();
  const unit = useUnit();
  const sequence = shownSequence({ found, changed })?.sequence;
  const steps = sequence?.steps ?? [];
  const now = stepAt(at, steps.length);
  const step = steps[now];
  const text = step
    ? `step ${now + 1} / ${steps.length} · ${placedName(step)} ${KINDS[step.type]}`
    : "nothing is built";
  const ticks = [...new Set(sequence?.diagnostics.flatMap(({ step }) => (step == null ? [] : [step])) ?? [])];
  const forward = () => slideTo(Math.floor(at) + 1);
  const back = () => slideTo(Math.ceil(at) - 1);
  const moves = movesOf(at, steps.length, {
    forward,
    back,
    reset: () => slideTo(0),
    goTo: slideTo,
    toggle: togglePlaySequence,
  });
  return (
    <section className="timeline" aria-label="Timeline">
      <Button icon="previous" aria-label="Step back" title="Step back" onClick={back} />
      <Button
        kind="primary"
        icon={playing ? "pause" : "play"}
        aria-label={playing ? "Pause" : "Play"}
        title={playing ? "Pause (Space)" : "Play (Space)"}
        onClick={togglePlaySequence}
      />
      <Button icon="next" aria-label="Step forward" title="Step forward" onClick={forward} />
      <Track
        label="Position in the sequence"
        value={at}
        of={steps.length}
        text={text}
        ticks={ticks}
        tickTitle="see Sequence"
        contacts={[]}
        off={steps.length === 0}
        onChange={slideTo}
        moves={moves}
      />
      <span className="timeline-step">{step ? `step ${now + 1} / ${steps.length} · ${placedName(step)}` : text}</span>
      <span className="timeline-time muted" />
      <span className="timeline-end muted">
        {step?.max_displacement_mm != null && `sags ${displacement(step.max_displacement_mm, unit)}`}
      </span>
      <span className="timeline-back">
        <Button
          kind="quiet"
          icon="close"
          aria-label="Back to the design"
          title="Back to the design"
          onClick={hideSequence}
        />
      </span>
    </section>
  );
}
