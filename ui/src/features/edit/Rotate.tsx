import { useState } from "react";
import type { Axis } from "../../scene/interface";
import { Field } from "../../shared/controls/Field";
import { Segmented } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { useDesign } from "../../state/design/design";
import { edgeOf } from "../../state/design/exact";
import { AXES } from "../../state/design/geometry";
import { rotate, rotateAbout, selectedBounds } from "../../state/design/operations";
import { select, useSelection } from "../../state/design/selection";
import { useFiles } from "../../state/files/files";
import { ABOUT, type About } from "./copies";
import { Do } from "./forms";

/** By an angle about an axis of the design, or about an edge that was selected before. */
export function RotateForm() {
  const [deg, setDeg] = useState(90);
  const [axis, setAxis] = useState<Axis | "edge">("z");
  /** Of another design the same number is another edge. */
  const [about, setAbout] = useState<{ readonly edge: number; readonly of: number } | null>(null);
  const opened = useFiles((files) => files.opened);
  const [through, setThrough] = useState<About>("middle");
  const design = useDesign();
  const selection = useSelection();
  const selected = edgeOf(selection, design);
  const line = about?.of === opened ? design.edges.get(about.edge) : undefined;
  const gone = axis === "edge" && !line ? "The edge of the axis is gone: choose another." : null;
  const make = (by: number) => {
    if (by === 0) return;
    if (axis === "edge") {
      if (line) void rotateAbout(line.id, by);
      return;
    }
    const middle = selectedBounds()?.centre;
    if (middle) void rotate(axis, through === "origin" ? [0, 0, 0] : middle, by);
  };
  const choose = (next: Axis | "edge") => {
    if (next === "edge" && typeof selected !== "string") setAbout({ edge: selected.id, of: opened });
    setAxis(next);
  };
  return (
    <>
      <Field label="Angle">
        {({ id }) => <NumberField id={id} kind="angle" label="Angle" value={deg} onCommit={setDeg} onEnter={make} />}
      </Field>
      <Field label="About">
        {() => (
          <Segmented<Axis | "edge">
            label="About"
            choices={[
              ...AXES.map((name) => ({ value: name, label: name.toUpperCase() })),
              {
                value: "edge",
                label: "Edge",
                why: axis === "edge" || typeof selected !== "string" ? null : "Select the edge to turn about first.",
              },
            ]}
            value={axis}
            onChoose={choose}
          />
        )}
      </Field>
      <Field label={axis === "edge" ? "Axis" : "Through"}>
        {() =>
          axis !== "edge" ? (
            <Segmented<About> label="The axis goes through" choices={ABOUT} value={through} onChoose={setThrough} />
          ) : (
            <button type="button" className="axis-edge" onClick={() => line && select([], [line.id])}>
              {line ? `From vertex ${line.a} to ${line.b}` : "\u2013"}
            </button>
          )
        }
      </Field>
      <Do command="rotate" onDo={() => make(deg)} why={gone ?? (deg === 0 ? "Type an angle first." : null)}>
        Rotate
      </Do>
    </>
  );
}
