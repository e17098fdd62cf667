import { useState } from "react";
import type { Shape } from "../../../generated/responses";
import { Button } from "../../../shared/controls/Button";
import { Select } from "../../../shared/controls/inputs";
import { NumberField } from "../../../shared/controls/NumberField";
import { count } from "../../../shared/figures/format";
import { isOwn, SHAPES, setValue, takeBack, useProfile } from "../../../state/machine/profile";
import { Fold } from "../Fold";
import { CommitText } from "./ValueRow";

const PARTS = [
  { value: "frame", label: "Frame" },
  { value: "head", label: "Turns with the head" },
  { value: "peg", label: "Goes with the peg" },
] as const;
const AXES = ["X", "Y", "Z"] as const;

type Vec3 = Shape["at_mm"];

const put = (vec: Vec3, axis: number, value: number): Vec3 =>
  vec.map((old, at) => (at === axis ? value : old)) as unknown as Vec3;

/** The boxes and cylinders of a machine: what it looks like, and what a wire can hit. The list is set as a whole. */
export function Bodies({ why }: { readonly why: string | null }) {
  const view = useProfile((store) => store.view);
  const source = useProfile((store) => store.source);
  const refused = useProfile((store) => (store.refused?.key === SHAPES ? store.refused.message : null));
  const shapes = view?.shapes ?? [];
  const own = isOwn(view, SHAPES);
  const set = (next: readonly Shape[]) => void setValue(SHAPES, next);
  const change = (at: number, part: Partial<Shape>) =>
    set(
      shapes.map((shape, index) =>
        index === at ? { ...shape, ...part, source: source.text, measured: source.measured } : shape,
      ),
    );
  const measured = shapes.filter((shape) => shape.measured).length;
  return (
    <Fold
      title="Bodies, for clearance"
      phrase={shapes.length === 0 ? "none" : `${count(shapes.length, "body", "bodies")}, ${measured} measured`}
    >
      <p className="muted small">
        The origin is where a bend begins, x the way the wire leaves, z the bend axis; the head at zero, the peg at 0°.
      </p>
      {own && !why && (
        <div className="row">
          <span className="value-changed">changed</span>
          <Button kind="link" onClick={() => void takeBack(SHAPES)}>
            Take back all bodies
          </Button>
        </div>
      )}
      {refused && (
        <p className="field-below wrong" role="alert">
          {refused}
        </p>
      )}
      <ul className="bodies">
        {shapes.map((shape, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: two bodies may have one name, and a name changes
          <li key={at}>
            <Body
              shape={shape}
              why={why}
              onChange={(part) => change(at, part)}
              onRemove={() => set(shapes.filter((_, index) => index !== at))}
            />
          </li>
        ))}
      </ul>
      {!why && (
        <div className="row">
          {(["box", "cylinder"] as const).map((solid) => (
            <Button
              key={solid}
              small
              icon="plus"
              onClick={() =>
                set([
                  ...shapes,
                  {
                    name: `new ${solid}`,
                    part: "frame",
                    solid:
                      solid === "box"
                        ? { box: { size_mm: [20, 20, 20] } }
                        : { cylinder: { radius_mm: 5, length_mm: 20 } },
                    at_mm: [-100, 0, 0],
                    axis: [0, 0, 1],
                    source: source.text,
                    measured: source.measured,
                  },
                ])
              }
            >
              {solid === "box" ? "Box" : "Cylinder"}
            </Button>
          ))}
        </div>
      )}
    </Fold>
  );
}

function Body({
  shape,
  why,
  onChange,
  onRemove,
}: {
  readonly shape: Shape;
  readonly why: string | null;
  readonly onChange: (part: Partial<Shape>) => void;
  readonly onRemove: () => void;
}) {
  const [open, setOpen] = useState(false);
  const { name, part, solid, at_mm, axis } = shape;
  const vector = (label: string, vec: Vec3, onSet: (vec: Vec3) => void, kind: "fine" | "number" = "fine") => (
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
          onCommit={(value) => onSet(put(vec, k, value))}
        />
      ))}
    </div>
  );
  const figure = (label: string, value: number, onSet: (value: number) => void) => (
    <NumberField
      label={`${name}, ${label}`}
      prefix={label}
      kind="fine"
      min={0}
      value={value}
      why={why}
      onCommit={onSet}
    />
  );
  return (
    <div className="body">
      <div className="row">
        <Button
          kind="quiet"
          icon={open ? "down" : "right"}
          aria-expanded={open}
          aria-label={`Figures of ${name}`}
          onClick={() => setOpen(!open)}
        />
        <span className="grow ellipsis">{name}</span>
        <span className="muted small">
          {"box" in solid ? "box" : "cylinder"} · {PARTS.find(({ value }) => value === part)?.label.toLowerCase()} ·{" "}
          {shape.measured ? "measured" : "estimate"}
        </span>
      </div>
      {open && (
        <div className="body-figures">
          <div className="body-line two">
            <span className="muted">Name</span>
            <CommitText label="Name" value={name} why={why} onCommit={(text) => text && onChange({ name: text })} />
            <Select
              aria-label={`${name}, part`}
              disabled={Boolean(why)}
              choices={PARTS}
              value={part}
              onChoose={(chosen) => onChange({ part: chosen })}
            />
          </div>
          {vector("Middle", at_mm, (vec) => onChange({ at_mm: vec }))}
          {vector("Axis", axis, (vec) => onChange({ axis: vec }), "number")}
          {"box" in solid ? (
            vector("Size", solid.box.size_mm as Vec3, (vec) => onChange({ solid: { box: { size_mm: vec } } }))
          ) : (
            <div className="body-line two">
              <span className="muted">Size</span>
              {figure("radius", solid.cylinder.radius_mm, (radius_mm) =>
                onChange({ solid: { cylinder: { ...solid.cylinder, radius_mm } } }),
              )}
              {figure("length", solid.cylinder.length_mm, (length_mm) =>
                onChange({ solid: { cylinder: { ...solid.cylinder, length_mm } } }),
              )}
            </div>
          )}
          <div className="body-line two">
            <span className="muted">May touch</span>
            {figure("bent wire within", shape.contact_zone_mm ?? 0, (contact_zone_mm) => onChange({ contact_zone_mm }))}
            {figure("a vertex within", shape.vertex_zone_mm ?? 0, (vertex_zone_mm) => onChange({ vertex_zone_mm }))}
          </div>
          <div className="row">
            <span className="grow muted small ellipsis" title={shape.source}>
              {shape.measured ? "Measured: " : ""}
              {shape.source}
            </span>
            <Button small icon="trash" why={why} onClick={onRemove}>
              Remove
            </Button>
          </div>
        </div>
      )}
    </div>
  );
}
