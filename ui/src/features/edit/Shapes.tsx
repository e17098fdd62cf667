import { useState } from "react";
import type { Vec3 } from "../../scene/interface";
import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Checkbox, Segmented, Select } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { useLengths } from "../../shared/figures/unit";
import { addShape, type ShapeRequest } from "../../state/design/operations";
import { useWhyNot } from "../../state/window/commands";
import { choosePlane, type PlaneName, useView } from "../../state/window/view";
import { useFigure } from "./figure";
import { needs, Outcome, useOutcome } from "./Outcome";
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

/** How long the edges of a shape get, against what the machine can make, and how many would fit. */
function Edges({ of, take }: { readonly of: ShapeRequest; readonly take: (sides: number) => void }) {
  const answer = useOutcome("shape", of);
  const { length } = useLengths();
  if (answer?.problem) return <Outcome fits={false} text={answer.problem} use={null} />;
  const found = answer?.outcome;
  if (found?.outcome !== "shape") return <Outcome fits={null} text="" use={null} />;
  const { fits, fitting } = found;
  const none = fitting === null ? " No number of edges fits." : "";
  const use = fits || fitting === null ? null : { label: `Use ${fitting} edges`, take: () => take(fitting) };
  const text = `Each edge ${length(found.length_mm)}${needs(found.needed_mm, length)}.${none}`;
  return <Outcome fits={fits} text={text} use={use} />;
}

/** Shapes from a few figures, as straight edges. */
export function Shapes() {
  const [shape, setShape] = useState<Shape>("circle");
  const [centre, setCentre] = useState<Vec3>([0, 0, 0]);
  const plane = useView((view) => view.plane);
  // The usual machines can make it with as many edges.
  const radius = useFigure(60);
  const edges = useFigure(12);
  const [measure, setMeasure] = useState<Measure>("corners");
  const [turn, setTurn] = useState(0);
  const pitch = useFigure(20);
  const turns = useFigure(3);
  const [left, setLeft] = useState(false);
  const why = useWhyNot("paste");
  const request = (figure: "value" | "now"): ShapeRequest => {
    const at = { centre_mm: [...centre] as [number, number, number], plane };
    const [radius_mm, sides] = [radius[figure], edges[figure]];
    if (shape === "circle") return { edit: "circle", ...at, radius_mm, edges: sides };
    if (shape === "polygon") return { edit: "polygon", ...at, sides, measure, size_mm: radius_mm, turn_deg: turn };
    const winding = { pitch_mm: pitch[figure], turns: turns[figure], edges_per_turn: sides, left };
    return { edit: "helix", ...at, radius_mm, ...winding };
  };
  const size = shape === "polygon" ? (MEASURES.find(({ value }) => value === measure)?.label ?? "Size") : "Radius";
  const names = { circle: "Edges", polygon: "Sides", helix: "Edges per turn" };
  return (
    <fieldset className="stack" aria-label="Shapes">
      <Segmented<Shape> label="Shape" choices={SHAPES} value={shape} onChoose={setShape} />
      <PlaceFields at={centre} change={setCentre} label="Centre" />
      <Field label="Plane">
        {() => (
          <Segmented<PlaneName> label="Plane of the shape" choices={PLANES} value={plane} onChoose={choosePlane} />
        )}
      </Field>
      {shape === "polygon" && (
        <Field label="Size is">
          {(ids) => <Select {...ids} choices={MEASURES} value={measure} onChoose={setMeasure} />}
        </Field>
      )}
      <Field label={shape === "polygon" ? "Size" : size}>
        {({ id }) => <NumberField id={id} label={size} {...radius.field} />}
      </Field>
      {shape === "helix" && (
        <>
          <Field label="Pitch" hint="How far a turn rises.">
            {({ id }) => <NumberField id={id} label="Pitch" {...pitch.field} />}
          </Field>
          <Field label="Turns">
            {({ id }) => <NumberField id={id} kind="number" label="Turns" {...turns.field} />}
          </Field>
        </>
      )}
      <Field label={names[shape]}>
        {({ id }) => <NumberField id={id} kind="whole" label={names[shape]} min={3} max={10_000} {...edges.field} />}
      </Field>
      {shape === "polygon" && (
        <Field label="Turned by">
          {({ id }) => <NumberField id={id} kind="angle" label="Turned by" value={turn} onCommit={setTurn} />}
        </Field>
      )}
      {shape === "helix" && (
        <Checkbox checked={left} onChange={setLeft}>
          Left-handed
        </Checkbox>
      )}
      <Edges of={request("now")} take={edges.set} />
      <div className="row">
        <Button className="grow" why={why} onClick={() => void addShape(request("value"))}>
          Add {shape}
        </Button>
      </div>
    </fieldset>
  );
}
