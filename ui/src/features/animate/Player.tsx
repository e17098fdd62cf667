import { useId } from "react";
import { Button } from "../../shared/controls/Button";
import { Select, Slider } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { count, percent, time } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { machineSeconds, type Speeds, screenSeconds } from "../../state/program/clock";
import { back, forward, reset, SPEED, scrub, setSpeed, useSpeeds } from "../../state/program/player";
import { chooseWire, showDesignAgain, togglePlay, usePlayback, useProgram } from "../../state/program/program";
import { shownSpeeds, spoken } from "./steps";

const NAMES: readonly (readonly [keyof Speeds, string])[] = [
  ["feed", "Feed ×"],
  ["rotate", "Rotate ×"],
  ["bend", "Bend ×"],
  ["all", "All ×"],
];

const LIVE = "A machine is bending the wire.";

/** Playing, sliding, speeds. */
export function Player() {
  const { played, step, playing, live } = usePlayback();
  const { program, wire, machine } = useProgram();
  const speeds = useSpeeds();
  const { length, unit } = useLengths();
  const id = useId();
  const one = program?.wires[wire];
  if (!program || !one) return null;
  const seconds = one.steps.map((part) => part.seconds);
  const total = seconds.length;
  const why = live ? LIVE : null;
  const shown = shownSpeeds(machine?.rates ?? null, speeds, unit);
  return (
    <div className="stack">
      {program.wires.length > 1 && (
        <Select
          aria-label="Wire"
          value={String(wire)}
          onChoose={(chosen) => chooseWire(Number(chosen))}
          choices={program.wires.map((each, index) => ({
            value: String(index),
            label: `Wire ${index + 1} · ${count(each.steps.length, "step")}`,
            why,
          }))}
        />
      )}
      <div className="row animate-transport">
        <Button icon="reset" aria-label="Go to start" title="Go to start" why={why} onClick={reset} />
        <Button icon="previous" aria-label="Step back" title="Step back" why={why} onClick={back} />
        <Button
          kind="primary"
          icon={playing ? "pause" : "play"}
          aria-label={playing ? "Pause" : "Play"}
          title={playing ? "Pause (Space)" : "Play (Space)"}
          why={why}
          onClick={togglePlay}
        />
        <Button icon="next" aria-label="Step forward" title="Step forward" why={why} onClick={forward} />
        <span className="grow animate-figures">
          <span>{percent(total > 0 ? step / total : 0)}</span>
          <span className="muted">
            {time(machineSeconds(seconds, step))} / {one.time_s === null ? "–" : time(one.time_s)}
          </span>
        </span>
      </div>
      <Slider
        label="Position in the program"
        value={step}
        min={0}
        max={total}
        step={0.01}
        text={spoken(one, Math.min(Math.floor(step), total - 1), length)}
        onChange={scrub}
      />
      <fieldset className="animate-speeds" aria-label="Playback speed">
        {NAMES.map(([key, name]) => (
          <div key={key} className="animate-speed">
            <NumberField
              label={`${name} speed`}
              prefix={name}
              kind="number"
              value={speeds[key]}
              min={SPEED.least}
              max={SPEED.most}
              onCommit={(value) => setSpeed(key, value)}
              aria-describedby={`${id}-${key}`}
            />
            <span id={`${id}-${key}`} className="muted small" title={shown[key] ? "Playback speed" : undefined}>
              {shown[key]}
            </span>
          </div>
        ))}
      </fieldset>
      <div className="row animate-plays">
        <span className="grow muted small">plays in {time(screenSeconds(seconds, 0, speeds))}</span>
        {played && !live && (
          <Button kind="link" onClick={showDesignAgain}>
            Back to the design
          </Button>
        )}
      </div>
    </div>
  );
}
