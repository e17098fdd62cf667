import { useState } from "react";
import { Button } from "../../../shared/controls/Button";
import { NumberField } from "../../../shared/controls/NumberField";
import { angle } from "../../../shared/figures/format";
import { useLengths } from "../../../shared/figures/unit";
import { hideByHand, jogBy, useByHand } from "../../../state/machine/by_hand";
import type { MachineState, Move } from "../../../state/machine/operator";
import { Part } from "../../panel/Section";
import { buttons } from "../buttons";
import { movePhrase } from "../phrases";
import { useProspect } from "../prospect";
import { JogKeys } from "./JogKeys";
import { type Axis, STEPS, type Steps } from "./jog_keys";
import { Recording } from "./Recording";

const AXES: readonly (readonly [Axis, string, string])[] = [
  ["feed", "F", "Feed"],
  ["bend", "B", "Bend"],
  ["rotate", "R", "Rotate"],
];

const moveOf = (axis: Axis, by: number): Move => (axis === "feed" ? { move: "feed", mm: by } : { move: axis, deg: by });

/** Moving the machine axis by axis. */
export function Manual({ state }: { readonly state: MachineState }) {
  const [by, setBy] = useState<Steps>(STEPS.coarse);
  const [record, setRecord] = useState(false);
  const { length, unit } = useLengths();
  const why = buttons(state, useProspect()).jog;
  const drawn = useByHand(({ played }) => played !== null);
  const { position } = state;
  const jog = (axis: Axis, amount: number) => {
    if (!why) void jogBy([moveOf(axis, amount)], record);
  };
  const at: Readonly<Record<Axis, string>> = {
    feed: position ? length(position.feed_mm) : "–",
    bend: position ? angle(position.bend_deg) : "–",
    rotate: position ? angle(position.rotate_deg) : "–",
  };
  return (
    <Part
      title="Manual"
      aside={
        <Button
          small
          icon="record"
          pressed={record}
          title="Record moves, to replay them later"
          onClick={() => setRecord(!record)}
        >
          Record
        </Button>
      }
    >
      <div className="manual">
        {AXES.map(([axis, letter, name]) => (
          <fieldset key={axis} className="manual-axis" aria-label={name}>
            <NumberField
              label={`${name} by`}
              prefix={letter}
              kind={axis === "feed" ? "length" : "angle"}
              value={by[axis]}
              min={0}
              onCommit={(value) => setBy((before) => ({ ...before, [axis]: value }))}
              onEnter={(value) => jog(axis, value)}
            />
            <div className="row">
              <Button
                className="grow"
                small
                icon="minus"
                aria-label={`${movePhrase(moveOf(axis, -by[axis]), unit)}`}
                title={movePhrase(moveOf(axis, -by[axis]), unit)}
                why={why}
                onClick={() => jog(axis, -by[axis])}
              />
              <Button
                className="grow"
                small
                icon="plus"
                aria-label={`${movePhrase(moveOf(axis, by[axis]), unit)}`}
                title={movePhrase(moveOf(axis, by[axis]), unit)}
                why={why}
                onClick={() => jog(axis, by[axis])}
              />
            </div>
            <span className="manual-at muted small">at {at[axis]}</span>
          </fieldset>
        ))}
      </div>
      <JogKeys steps={by} why={why} onSteps={setBy} onJog={jog} />
      <Recording state={state} record={record} />
      {drawn && (
        <div className="row" role="status">
          <span className="grow muted small">The view shows the wire that these moves bend, springback left out.</span>
          <Button kind="link" onClick={hideByHand}>
            Back to the design
          </Button>
        </div>
      )}
    </Part>
  );
}
