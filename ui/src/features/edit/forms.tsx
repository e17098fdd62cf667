import { type ReactNode, useState } from "react";
import type { Axis } from "../../scene/interface";
import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Checkbox, Segmented, Select } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { useDesign } from "../../state/design/design";
import { AXES, axisIndex } from "../../state/design/geometry";
import { extrude, merge, mirror, round, selectedBounds, split, straighten } from "../../state/design/operations";
import { useWhyNot } from "../../state/window/commands";
import type { CommandId } from "../../state/window/keys";

const AXIS_CHOICES = AXES.map((axis) => ({ value: axis, label: axis.toUpperCase() }));

/** The button of a form: what it does, or why it cannot. */
export function Do({
  command,
  onDo,
  why: own,
  children,
}: {
  readonly command: CommandId;
  readonly onDo: () => void;
  /** Why its fields ask for nothing yet. */
  readonly why?: string | null;
  readonly children: ReactNode;
}) {
  const why = useWhyNot(command) ?? own ?? null;
  return (
    <div className="row end">
      {why && <span className="muted small grow">{why}</span>}
      <Button why={why} onClick={onDo}>
        {children}
      </Button>
    </div>
  );
}

export function AxisField({
  label,
  value,
  onChoose,
}: {
  readonly label: string;
  readonly value: Axis;
  readonly onChoose: (axis: Axis) => void;
}) {
  return (
    <Field label={label}>
      {() => <Segmented label={label} choices={AXIS_CHOICES} value={value} onChoose={onChoose} />}
    </Field>
  );
}

export function SplitForm() {
  const [at, setAt] = useState(0.5);
  return (
    <>
      <Field label="At" hint="Measured along the edge from its first vertex.">
        {({ id }) => (
          <NumberField id={id} kind="percent" label="At" value={at} min={0.001} max={0.999} onCommit={setAt} />
        )}
      </Field>
      <Do command="split" onDo={() => void split(at)}>
        Split
      </Do>
    </>
  );
}

export function MergeForm() {
  const [at, setAt] = useState<"first" | "last" | "centre">("centre");
  return (
    <>
      <Field label="Where">
        {(ids) => (
          <Select
            {...ids}
            choices={[
              { value: "centre", label: "At the centre of all" },
              { value: "first", label: "At the one selected first" },
              { value: "last", label: "At the one selected last" },
            ]}
            value={at}
            onChoose={setAt}
          />
        )}
      </Field>
      <Do command="merge" onDo={() => void merge(at)}>
        Merge
      </Do>
    </>
  );
}

export function ExtrudeForm() {
  const [axis, setAxis] = useState<Axis>("z");
  const [by, setBy] = useState(20);
  return (
    <>
      <AxisField label="Along" value={axis} onChoose={setAxis} />
      <Field label="Length">{({ id }) => <NumberField id={id} label="Length" value={by} onCommit={setBy} />}</Field>
      <Do command="extrude" onDo={() => void extrude(axis, by, false)}>
        Extrude
      </Do>
    </>
  );
}

export function MirrorForm() {
  const [axis, setAxis] = useState<Axis>("x");
  const [through, setThrough] = useState<"origin" | "middle" | "side">("origin");
  const [copy, setCopy] = useState(true);
  useDesign();
  const planeAt = () => {
    const bounds = selectedBounds();
    if (!bounds || through === "origin") return 0;
    return (through === "middle" ? bounds.centre : bounds.low)[axisIndex(axis)];
  };
  return (
    <>
      <AxisField label="Across" value={axis} onChoose={setAxis} />
      <Field label="Plane">
        {(ids) => (
          <Select
            {...ids}
            choices={[
              { value: "origin", label: "Through the origin" },
              { value: "middle", label: "Through the centre of the selection" },
              { value: "side", label: "Along the near side of the selection" },
            ]}
            value={through}
            onChoose={setThrough}
          />
        )}
      </Field>
      <Checkbox checked={copy} onChange={setCopy}>
        Keep the original and add the mirror image
      </Checkbox>
      <Do command="mirror" onDo={() => void mirror(axis, planeAt(), copy)}>
        Mirror
      </Do>
    </>
  );
}

export function StraightenForm() {
  const [tolerance, setTolerance] = useState(1);
  return (
    <>
      <Field label="Tolerance" hint="Largest distance of a vertex from the straight line.">
        {({ id }) => <NumberField id={id} label="Tolerance" value={tolerance} min={0} onCommit={setTolerance} />}
      </Field>
      <Do command="straighten" onDo={() => void straighten(tolerance)}>
        Straighten
      </Do>
    </>
  );
}

export function RoundForm() {
  const [tolerance, setTolerance] = useState(1);
  const [step, setStep] = useState(15);
  return (
    <>
      <Field label="Tolerance" hint="Largest distance between the chain and its arcs.">
        {({ id }) => <NumberField id={id} label="Tolerance" value={tolerance} min={0} onCommit={setTolerance} />}
      </Field>
      <Field label="Step" hint="Largest bend angle at each vertex of an arc.">
        {({ id }) => <NumberField id={id} kind="angle" label="Step" value={step} min={1} max={90} onCommit={setStep} />}
      </Field>
      <Do command="round" onDo={() => void round(tolerance, step)}>
        Round
      </Do>
    </>
  );
}
