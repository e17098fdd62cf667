import { useState } from "react";
import type { Shape } from "../../../generated/responses";
import { Button } from "../../../shared/controls/Button";
import { Select } from "../../../shared/controls/inputs";
import { NumberField } from "../../../shared/controls/NumberField";
import { PARTS } from "./bodies";
import { CommitText } from "./CommitText";
import { SourceForm } from "./SourceForm";

const AXES = ["X", "Y", "Z"] as const;

type Vec3 = Shape["at_mm"];

const put = (vec: Vec3, axis: number, value: number): Vec3 =>
  vec.map((old, at) => (at === axis ? value : old)) as unknown as Vec3;

/** The figures of the body that is chosen. */
export function BodyForm({
  shape,
  why,
  onChange,
  onType,
  onTakeBack,
  onRemove,
}: {
  readonly shape: Shape;
  readonly why: string | null;
  readonly onChange: (part: Partial<Shape>) => void;
  /** What is typed and not taken yet; null: nothing. */
  readonly onType: (part: Partial<Shape> | null) => void;
  /** As it is in the parent again; null where it does not differ. */
  readonly onTakeBack: (() => void) | null;
  readonly onRemove: () => void;
}) {
  const [editing, setEditing] = useState(false);
  const { name, part, solid, at_mm, axis } = shape;
  /** What is half written leaves the picture as it was. */
  const typed = (change: (value: number) => Partial<Shape>) => (value: number | null, isTyping: boolean) => {
    if (value !== null) onType(change(value));
    else if (!isTyping) onType(null);
  };
  const vector = (label: string, vec: Vec3, made: (vec: Vec3) => Partial<Shape>, kind: "fine" | "number" = "fine") => (
    <div className="body-line">
      <span className="muted">{label}</span>
      {AXES.map((prefix, k) => (
        <NumberField
          key={prefix}
          label={`${name}, ${label.toLowerCase()} ${prefix}`}
          prefix={prefix}
          kind={kind}
          value={vec[k] ?? 0}
          why={why}
          onType={typed((value) => made(put(vec, k, value)))}
          onCommit={(value) => onChange(made(put(vec, k, value)))}
        />
      ))}
    </div>
  );
  const figure = (label: string, value: number, made: (value: number) => Partial<Shape>, read = label) => (
    <NumberField
      label={`${name}, ${read}`}
      prefix={label}
      kind="fine"
      min={0}
      value={value}
      why={why}
      onType={typed(made)}
      onCommit={(changed) => onChange(made(changed))}
    />
  );
  return (
    <fieldset className="body-form" aria-label={`Figures of ${name}`}>
      <div className="body-line two">
        <span className="muted">Name</span>
        <CommitText label="Name" value={name} why={why} onCommit={(text) => text && onChange({ name: text })} />
        <Select
          aria-label={`${name}, what it moves with`}
          disabled={Boolean(why)}
          choices={PARTS}
          value={part}
          onChoose={(chosen) => onChange({ part: chosen })}
        />
      </div>
      {vector("Middle", at_mm, (vec) => ({ at_mm: vec }))}
      {vector("Axis", axis, (vec) => ({ axis: vec }), "number")}
      {"box" in solid ? (
        vector("Size", solid.box.size_mm as Vec3, (vec) => ({ solid: { box: { size_mm: vec } } }))
      ) : (
        <div className="body-line two">
          <span className="muted">Size</span>
          {figure("radius", solid.cylinder.radius_mm, (radius_mm) => ({
            solid: { cylinder: { ...solid.cylinder, radius_mm } },
          }))}
          {figure("length", solid.cylinder.length_mm, (length_mm) => ({
            solid: { cylinder: { ...solid.cylinder, length_mm } },
          }))}
        </div>
      )}
      <div
        className="body-line two"
        title="How far from the bend point the wire that is bent, and how far from a vertex other struts, may touch this body. 0: nowhere."
      >
        <span className="muted">May touch</span>
        {figure(
          "wire",
          shape.contact_zone_mm ?? 0,
          (contact_zone_mm) => ({ contact_zone_mm }),
          "the wire may touch within",
        )}
        {figure(
          "vertex",
          shape.vertex_zone_mm ?? 0,
          (vertex_zone_mm) => ({ vertex_zone_mm }),
          "a vertex may touch within",
        )}
      </div>
      <div className="body-line source">
        <span className="muted">Source</span>
        <span className="muted small ellipsis" title={shape.source}>
          {shape.measured && !/measured/i.test(shape.source) ? "Measured: " : ""}
          {shape.source}
        </span>
        {!why && (
          <Button kind="link" aria-label={`Change the source of ${name}`} onClick={() => setEditing(!editing)}>
            Source…
          </Button>
        )}
      </div>
      {editing && (
        <SourceForm
          of={name}
          source={{ text: shape.source, measured: shape.measured }}
          onSet={({ text, measured }) => {
            onChange({ source: text, measured });
            return Promise.resolve();
          }}
          onDone={() => setEditing(false)}
        />
      )}
      {!why && (
        <div className="row">
          {onTakeBack && (
            <Button kind="link" onClick={onTakeBack}>
              Take back {name}
            </Button>
          )}
          <span className="grow" />
          <Button small icon="trash" onClick={onRemove}>
            Remove {name}
          </Button>
        </div>
      )}
    </fieldset>
  );
}
