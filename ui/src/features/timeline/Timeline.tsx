import { Button } from "../../shared/controls/Button";
import { count, number, percent, time } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { useDesign } from "../../state/design/design";
import { hideByHand, useByHand } from "../../state/machine/by_hand";
import { useRun } from "../../state/machine/run";
import { machineSeconds, stepOf } from "../../state/program/clock";
import { useContacts } from "../../state/program/contacts";
import { back, forward, reset, scrub, useSpeeds } from "../../state/program/player";
import {
  goTo,
  makeProgram,
  showDesignAgain,
  togglePlay,
  usePlayback,
  useProgram,
  useStale,
} from "../../state/program/program";
import { useRunFindings } from "../../state/program/run_file";
import { useSequence } from "../../state/sequence/sequence";
import { useWhyNot } from "../../state/window/commands";
import { namedSteps, spoken } from "../animate/steps";
import { BuildTimeline } from "./BuildTimeline";
import { movesOf, Track } from "./Track";
import "./timeline.css";

const LIVE = "A machine is bending the wire.";

/** The program is made when it is played. */
const NOT_PLAYED = "Press Play first.";

/** What plays in the view: a program, or the steps of building. */
export function Timeline() {
  const builds = useSequence(({ shown }) => shown);
  return builds ? <BuildTimeline /> : <ProgramTimeline />;
}

/** The program under the view. Its place is kept while there is none, so that the view keeps its own. */
function ProgramTimeline() {
  const { program, wire, asking } = useProgram();
  const { played, step, playing, live } = usePlayback();
  const stands = useRun(({ question, state }) =>
    question?.doubt != null ? "stopped" : state?.phase === "holding" ? "paused" : "bending",
  );
  const stale = useStale();
  const speeds = useSpeeds();
  const { length } = useLengths();
  const check = useDesign((design) => design.check);
  const byHand = useByHand(({ played, moves }) => (played ? moves : null));
  const { contacts } = useContacts();
  const file = useRunFindings();
  const none = useWhyNot("play");
  const one = program?.wires[wire];
  const total = one?.steps.length ?? 0;
  const why = live ? LIVE : null;
  const noSteps = none ?? NOT_PLAYED;
  const whyStep = why ?? (one ? null : noSteps);
  const at = Math.max(stepOf(total, step), 0);
  const goThere = (step: number) => void goTo(step);
  const moves = movesOf(step, total, { forward, back, reset, goTo: goThere, toggle: togglePlay });
  return (
    <section className="timeline" aria-label="Timeline">
      <Button icon="previous" aria-label="Step back" title="Step back" why={whyStep} onClick={back} />
      <Button
        kind="primary"
        icon={playing ? "pause" : "play"}
        aria-label={playing ? "Pause" : "Play"}
        title={playing ? "Pause (Space)" : "Play (Space)"}
        why={why ?? (one ? null : none)}
        onClick={togglePlay}
      />
      <Button icon="next" aria-label="Step forward" title="Step forward" why={whyStep} onClick={forward} />
      <Track
        value={step}
        of={total}
        text={one ? spoken(one, at, length) : noSteps}
        ticks={program ? namedSteps((file ?? check)?.diagnostics ?? [], program.wires.length) : []}
        contacts={one ? contacts : []}
        off={live || !one}
        onChange={scrub}
        moves={moves}
      />
      <span className={byHand === null && one ? "timeline-step" : "timeline-step muted"}>
        {byHand !== null
          ? `${count(byHand, "move")} by hand, not this program`
          : one
            ? `${live ? `${stands} · ` : ""}step ${at + 1} / ${total} · ${percent(total > 0 ? step / total : 0)}`
            : none === null
              ? "not played yet"
              : "no program yet"}
      </span>
      <span className="timeline-time muted">
        {byHand === null &&
          one &&
          time(
            machineSeconds(
              one.steps.map((each) => each.seconds),
              step,
            ),
          )}
      </span>
      <span className="timeline-end">
        {one && stale && !live ? (
          <Button
            small
            why={asking ? "The program is being generated." : null}
            title="The design or its machine was changed since the program was made"
            onClick={() => void makeProgram()}
          >
            Update
          </Button>
        ) : live || byHand !== null || !one ? null : (
          <span className="timeline-speeds muted" title="Playback speed relative to the machine. Set it under Animate">
            feed ×{number(speeds.feed * speeds.all, digits(speeds.feed * speeds.all))} · bend ×
            {number(speeds.bend * speeds.all, digits(speeds.bend * speeds.all))} · rotate ×
            {number(speeds.rotate * speeds.all, digits(speeds.rotate * speeds.all))}
          </span>
        )}
      </span>
      <span className="timeline-back">
        {((played && !live) || byHand !== null) && (
          <Button
            kind="quiet"
            icon="close"
            aria-label="Back to the design"
            title="Back to the design"
            onClick={played ? showDesignAgain : hideByHand}
          />
        )}
      </span>
    </section>
  );
}

/** A whole number needs none. */
const digits = (value: number): number => (Math.abs(value - Math.round(value)) < 0.005 ? 0 : 1);
