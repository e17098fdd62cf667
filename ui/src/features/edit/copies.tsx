import { useState } from "react";
import type { Axis, Vec3 } from "../../scene/interface";
import { Field } from "../../shared/controls/Field";
import { Segmented } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { useDesign } from "../../state/design/design";
import { AXES, axisIndex, rotation, scaling, translation } from "../../state/design/geometry";
import { array, largest, selectedBounds, transform } from "../../state/design/operations";
import { useSelection } from "../../state/design/selection";
import { useWhyNot } from "../../state/window/commands";
import { AxisField, Do } from "./forms";

type Kind = "step" | "turn";
export type About = "origin" | "middle";

export const ABOUT = [
  { value: "origin", label: "Origin" },
  { value: "middle", label: "Selection" },
] as const;

/** Copies in a row, or around an axis. */
export function ArrayForm() {
  const [kind, setKind] = useState<Kind>("step");
  const [count, setCount] = useState(3);
  const [by, setBy] = useState<Vec3>([50, 0, 0]);
  const [axis, setAxis] = useState<Axis>("z");
  const [deg, setDeg] = useState(90);
  const [along, setAlong] = useState(0);
  const [about, setAbout] = useState<About>("origin");
  const make = () => {
    const middle = selectedBounds()?.centre ?? [0, 0, 0];
    void array(
      kind === "step" ? translation(by) : rotation(axis, deg, about === "origin" ? [0, 0, 0] : middle, along),
      count,
    );
  };
  return (
    <>
      <Field label="Copies">
        {({ id }) => (
          <NumberField id={id} kind="whole" label="Copies" value={count} min={1} max={1000} onCommit={setCount} />
        )}
      </Field>
      <Field label="Each">
        {() => (
          <Segmented<Kind>
            label="Each copy"
            choices={[
              { value: "step", label: "Linear" },
              { value: "turn", label: "Circular" },
            ]}
            value={kind}
            onChoose={setKind}
          />
        )}
      </Field>
      {kind === "step" ? (
        <div className="three">
          {AXES.map((name) => (
            <NumberField
              key={name}
              label={`From copy to copy, ${name.toUpperCase()}`}
              prefix={name.toUpperCase()}
              value={by[axisIndex(name)]}
              onCommit={(value) => {
                const next: [number, number, number] = [...by];
                next[axisIndex(name)] = value;
                setBy(next);
              }}
            />
          ))}
        </div>
      ) : (
        <>
          <AxisField label="About" value={axis} onChoose={setAxis} />
          <Field label="Through">
            {() => <Segmented<About> label="The axis goes through" choices={ABOUT} value={about} onChoose={setAbout} />}
          </Field>
          <Field label="Angle per copy">
            {({ id }) => <NumberField id={id} kind="angle" label="Angle per copy" value={deg} onCommit={setDeg} />}
          </Field>
          <Field label="Rise per copy">
            {({ id }) => <NumberField id={id} label="Rise per copy" value={along} onCommit={setAlong} />}
          </Field>
        </>
      )}
      <Do command="array" onDo={make}>
        Make {count === 1 ? "1 copy" : `${count} copies`}
      </Do>
    </>
  );
}

/** To a size of the largest side, or by a factor. */
export function ScaleForm() {
  const [about, setAbout] = useState<About>("middle");
  const [factor, setFactor] = useState(1);
  useDesign();
  useSelection();
  const now = largest();
  const why = useWhyNot("scale");
  const make = (by: number) => {
    if (!now || why || by === 1) return;
    void transform(scaling(by, about === "origin" ? [0, 0, 0] : now.centre));
    setFactor(1);
  };
  return (
    <>
      <Field
        label="Size"
        hint={now ? `Along ${now.axis.toUpperCase()}, the largest side.` : "Select more than one vertex to scale."}
      >
        {({ id }) => (
          <NumberField
            id={id}
            label="Size"
            value={now && now.size * factor}
            positive
            min={1e-3}
            onCommit={(mm) => now && setFactor(mm / now.size)}
            onEnter={(mm) => now && make(mm / now.size)}
            why={now ? null : "The selection has no size"}
          />
        )}
      </Field>
      <Field label="Factor">
        {({ id }) => (
          <NumberField
            id={id}
            kind="number"
            label="Factor"
            value={factor}
            positive
            min={1e-4}
            max={1e4}
            onCommit={setFactor}
            onEnter={make}
          />
        )}
      </Field>
      <Field label="About">
        {() => <Segmented<About> label="Fixed point" choices={ABOUT} value={about} onChoose={setAbout} />}
      </Field>
      <Do command="scale" onDo={() => make(factor)} why={factor === 1 ? "Type a size or a factor first." : null}>
        Scale
      </Do>
    </>
  );
}
