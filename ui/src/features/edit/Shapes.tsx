import { useState } from "react";
import type { Vec3 } from "../../scene/interface";
import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Checkbox, Segmented, Select } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { useLengths } from "../../shared/figures/unit";
import { addShape, type ShapeRequest } from "../../state/design/operations";
import { useWhyNot } from "../../state/window/commands";
import { drawnPlane, type PlaneName, useView } from "../../state/window/view";
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

const POINTS = { value: "points", label: "Points" } as const;

const ORIGIN: Vec3 = [0, 0, 0];

/** Which plane a shape lies on: the one that is drawn on until another is chosen here, which leaves that one as it is. */
function usePlane() {
  const { plane, ownPlane, planeOffset } = useView();
  const [chosen, setChosen] = useState<{ plane: PlaneName; own: typeof ownPlane; value: PlaneName | "points" } | null>(
    null,
  );
  const isOf = chosen?.plane === plane && chosen.own === ownPlane;
  const value = isOf ? chosen.value : ownPlane ? POINTS.value : plane;
  const drawn = value === POINTS.value && ownPlane ? drawnPlane({ plane, ownPlane, planeOffset }) : null;
  const vector = ([x, y, z]: Vec3): [number, number, number] => [x, y, z];
  const own = drawn && { origin_mm: vector(drawn.origin), u: vector(drawn.u), v: vector(drawn.v) };
  const choose = (to: PlaneName | "points") => setChosen({ plane, own: ownPlane, value: to });
  return { value, own, through: ownPlane?.through ?? null, choose };
}

/** Where the axes of the plane on three points lead. */
function axesText([a = null, b = null, c = null]: readonly (number | null)[]): string {
  if (a === null || b === null || c === null) return "Points: X from the first to the second, Y towards the third.";
  return `Points: X from vertex ${a} to ${b}, Y towards ${c}, Z off the plane.`;
}

/** How long the edges of a shape get, against what the machine can make, and how many would fit. */
function Edges({
  answer,
  take,
}: {
  readonly answer: ReturnType<typeof useOutcome>;
  readonly take: (sides: number) => void;
}) {
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
  const [centre, setCentre] = useState(ORIGIN);
  const [onPoints, setOnPoints] = useState(ORIGIN);
  const plane = usePlane();
  // The usual machines can make it with as many edges.
  const radius = useFigure(60);
  const edges = useFigure(12);
  const [measure, setMeasure] = useState<Measure>("corners");
  const [turn, setTurn] = useState(0);
  const pitch = useFigure(20);
  const turns = useFigure(3);
  const [left, setLeft] = useState(false);
  const whyNot = useWhyNot("paste");
  const request = (figure: "value" | "now"): ShapeRequest => {
    const [x, y, z] = plane.own ? onPoints : centre;
    const at = {
      centre_mm: [x, y, z] as [number, number, number],
      plane: plane.value === "points" ? ("xy" as const) : plane.value,
      ...(plane.own && { on: plane.own }),
    };
    const [radius_mm, sides] = [radius[figure], edges[figure]];
    if (shape === "circle") return { edit: "circle", ...at, radius_mm, edges: sides };
    if (shape === "polygon") return { edit: "polygon", ...at, sides, measure, size_mm: radius_mm, turn_deg: turn };
    const winding = { pitch_mm: pitch[figure], turns: turns[figure], edges_per_turn: sides, left };
    return { edit: "helix", ...at, radius_mm, ...winding };
  };
  const answer = useOutcome("shape", request("now"));
  const why = whyNot ?? answer?.problem ?? null;
  const size = shape === "polygon" ? (MEASURES.find(({ value }) => value === measure)?.label ?? "Size") : "Radius";
  const names = { circle: "Edges", polygon: "Sides", helix: "Edges per turn" };
  return (
    <fieldset className="stack" aria-label="Shapes">
      <Segmented<Shape> label="Shape" choices={SHAPES} value={shape} onChoose={setShape} />
      {plane.own ? (
        <PlaceFields at={onPoints} change={setOnPoints} label="Centre" />
      ) : (
        <PlaceFields at={centre} change={setCentre} label="Centre" />
      )}
      <Field label="Plane" hint={plane.through && axesText(plane.through)}>
        {() => (
          <Segmented<PlaneName | "points">
            label="Plane of the shape"
            choices={plane.through ? [...PLANES, POINTS] : PLANES}
            value={plane.value}
            onChoose={plane.choose}
          />
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
      <Edges answer={answer} take={edges.set} />
      <div className="row">
        <Button className="grow" why={why} onClick={() => void addShape(request("value"))}>
          Add {shape}
        </Button>
      </div>
    </fieldset>
  );
}
