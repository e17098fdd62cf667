import { useState } from "react";
import type { Vec3 } from "../../scene/interface";
import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Checkbox, Segmented, Select } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { useLengths } from "../../shared/figures/unit";
import { sideOf } from "../../state/design/geometry";
import { addShape } from "../../state/design/operations";
import { useWhyNot } from "../../state/window/commands";
import { type PlaneName, useView } from "../../state/window/view";
import { PlaceFields } from "./Position";

type Shape = "circle" | "polygon" | "helix";
type Measure = "corners" | "flats" | "side";

const SHAPES = [
  { value: "circle", label: "Circle" },
  { value: "polygon", label: "Polygon" },
  { value: "helix", label: "Helix" },
] as const;

const MEASURES = [
  { value: "corners", label: "Radius to the corners" },
  { value: "flats", label: "Radius to the sides" },
  { value: "side", label: "Length of a side" },
] as const;

const PLANES = [
  { value: "xy", label: "XY" },
  { value: "xz", label: "XZ" },
  { value: "yz", label: "YZ" },
] as const;

function Count({
  label,
  value,
  hint,
  change,
}: {
  readonly label: string;
  readonly value: number;
  readonly hint?: string;
  readonly change: (value: number) => void;
}) {
  return (
    <Field label={label} hint={hint}>
      {({ id }) => (
        <NumberField id={id} kind="whole" label={label} value={value} min={3} max={10_000} onCommit={change} />
      )}
    </Field>
  );
}

/** Shapes from a few figures, as straight edges. */
export function Shapes() {
  const [shape, setShape] = useState<Shape>("circle");
  const [centre, setCentre] = useState<Vec3>([0, 0, 0]);
  const plane = useView((view) => view.plane);
  const [radius, setRadius] = useState(50);
  const [edges, setEdges] = useState(12);
  const [measure, setMeasure] = useState<Measure>("corners");
  const [turn, setTurn] = useState(0);
  const [pitch, setPitch] = useState(20);
  const [turns, setTurns] = useState(3);
  const [left, setLeft] = useState(false);
  const { length } = useLengths();
  const why = useWhyNot("paste");
  const add = () => {
    const at = { centre_mm: [...centre] as [number, number, number], plane };
    if (shape === "circle") void addShape({ edit: "circle", ...at, radius_mm: radius, edges });
    else if (shape === "polygon")
      void addShape({ edit: "polygon", ...at, sides: edges, measure, size_mm: radius, turn_deg: turn });
    else
      void addShape({ edit: "helix", ...at, radius_mm: radius, pitch_mm: pitch, turns, edges_per_turn: edges, left });
  };
  const size = shape === "polygon" ? (MEASURES.find(({ value }) => value === measure)?.label ?? "Size") : "Radius";
  return (
    <fieldset className="stack" aria-label="Shapes">
      <Segmented<Shape> label="Shape" choices={SHAPES} value={shape} onChoose={setShape} />
      <PlaceFields at={centre} change={setCentre} label="Centre" />
      <Field label="Plane">
        {() => (
          <Segmented<PlaneName>
            label="Plane of the shape"
            choices={PLANES}
            value={plane}
            onChoose={(value) => useView.setState({ plane: value })}
          />
        )}
      </Field>
      {shape === "polygon" && (
        <Field label="Size is">
          {(ids) => <Select {...ids} choices={MEASURES} value={measure} onChoose={setMeasure} />}
        </Field>
      )}
      <Field label={shape === "polygon" ? "Size" : size}>
        {({ id }) => <NumberField id={id} label={size} value={radius} onCommit={setRadius} />}
      </Field>
      {shape === "circle" && (
        <Count label="Edges" value={edges} change={setEdges} hint={`Each ${length(sideOf(radius, edges))} long.`} />
      )}
      {shape === "polygon" && (
        <>
          <Count label="Sides" value={edges} change={setEdges} />
          <Field label="Turned by">
            {({ id }) => <NumberField id={id} kind="angle" label="Turned by" value={turn} onCommit={setTurn} />}
          </Field>
        </>
      )}
      {shape === "helix" && (
        <>
          <Field label="Pitch" hint="How far a turn rises.">
            {({ id }) => <NumberField id={id} label="Pitch" value={pitch} onCommit={setPitch} />}
          </Field>
          <Field label="Turns">
            {({ id }) => <NumberField id={id} kind="number" label="Turns" value={turns} onCommit={setTurns} />}
          </Field>
          <Count label="Edges per turn" value={edges} change={setEdges} />
          <Checkbox checked={left} onChange={setLeft}>
            Left-handed
          </Checkbox>
        </>
      )}
      <div className="row">
        <Button className="grow" why={why} onClick={add}>
          Add {shape}
        </Button>
      </div>
    </fieldset>
  );
}
