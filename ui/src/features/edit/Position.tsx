import { useState } from "react";
import type { Axis, Vec3 } from "../../scene/interface";
import { Button } from "../../shared/controls/Button";
import { Checkbox } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { useDesign } from "../../state/design/design";
import { AXES, axisIndex } from "../../state/design/geometry";
import { moveBy, placeAlong, support } from "../../state/design/operations";
import { isEmpty, useSelection, verticesOf } from "../../state/design/selection";
import { run } from "../../state/window/commands";
import { useView } from "../../state/window/view";
import { Joint } from "./Joint";

function with_(at: Vec3, axis: Axis, value: number): Vec3 {
  const changed: [number, number, number] = [...at];
  changed[axisIndex(axis)] = value;
  return changed;
}

/** X, Y and Z in a row. `change` is given the axis too: of a place that is asked for the others may be on their way still. `onEnter` is given the place as it was read just now. */
export function PlaceFields({
  at,
  change,
  label,
  why,
  onEnter,
}: {
  readonly at: Vec3;
  readonly change: (at: Vec3, axis: Axis, value: number) => void;
  readonly label: string;
  readonly why?: string | null;
  readonly onEnter?: (at: Vec3) => void;
}) {
  return (
    <div className="three">
      {AXES.map((axis) => (
        <NumberField
          key={axis}
          label={`${label}, ${axis.toUpperCase()}`}
          prefix={axis.toUpperCase()}
          value={at[axisIndex(axis)]}
          why={why}
          onCommit={(value) => change(with_(at, axis, value), axis, value)}
          {...(onEnter ? { onEnter: (value: number) => onEnter(with_(at, axis, value)) } : {})}
        />
      ))}
    </div>
  );
}

function MoveBy({ none }: { readonly none: string | null }) {
  const [by, setBy] = useState<Vec3>([0, 0, 0]);
  const still = by.every((value) => value === 0);
  return (
    <>
      <PlaceFields at={by} change={setBy} label="Move by" why={none} />
      <div className="row move-by">
        <Button
          className="grow"
          why={none ?? (still ? "Type a distance first" : null)}
          onClick={() => {
            void moveBy(by);
            setBy([0, 0, 0]);
          }}
        >
          Move
        </Button>
      </div>
    </>
  );
}

/** Begins to move the selection with the pointer, along one axis. */
function grab(axis: Axis): void {
  run("move");
  useView.getState().handle?.lockAxis(axis);
}

const NONE = "Nothing is selected.";

/** Where one vertex is, or how far several are to go. As high whatever is selected: what is below it stays where it is. */
export function Position() {
  const design = useDesign();
  const selection = useSelection();
  const ids = verticesOf(selection, design);
  const [one] = ids;
  const alone = ids.length === 1 && selection.lines.size === 0;
  const vertex = alone && one !== undefined ? design.vertices.get(one) : undefined;
  const none = ids.length === 0 ? NONE : null;
  const still = isEmpty(selection) ? NONE : null;
  const supports = ids.filter((id) => design.vertices.get(id)?.support).length;
  return (
    <>
      {vertex ? (
        <>
          <PlaceFields
            key={vertex.id}
            at={vertex.at}
            label={`Vertex ${vertex.id}`}
            change={(_, axis, value) => void placeAlong(vertex.id, axis, value)}
          />
          <div className="move-by" />
        </>
      ) : (
        <MoveBy none={still} />
      )}
      <div className="row">
        <span className="muted grow">Move with the pointer along</span>
        {AXES.map((axis) => (
          <Button key={axis} small why={still} onClick={() => grab(axis)} title={`G, then ${axis.toUpperCase()}`}>
            {axis.toUpperCase()}
          </Button>
        ))}
      </div>
      <Checkbox checked={none === null && supports === ids.length} why={none} onChange={(fixed) => void support(fixed)}>
        {ids.length <= 1 ? "Support: this vertex is held fixed" : `Supports: ${supports} of ${ids.length} are fixed`}
      </Checkbox>
      <Joint none={none} />
    </>
  );
}
