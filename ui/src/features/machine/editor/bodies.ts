/** The bodies of a machine while they are edited: what is new or changed, and where a new one comes. Frame: that of docs/machines.md. */

import type { Shape } from "../../../generated/responses";
import { axesOf } from "../picture/picture";

type Vec3 = Shape["at_mm"];

export const PARTS = [
  { value: "frame", label: "Stands still" },
  { value: "head", label: "Turns with the head" },
  { value: "peg", label: "Goes with the peg" },
] as const;

/** With what is absent in a file as it counts. */
const whole = (shape: Shape) => ({
  ...shape,
  axis: shape.axis ?? [0, 0, 1],
  contact_zone_mm: shape.contact_zone_mm ?? 0,
  vertex_zone_mm: shape.vertex_zone_mm ?? 0,
});

const sorted = (value: unknown): unknown =>
  Array.isArray(value)
    ? value.map(sorted)
    : value && typeof value === "object"
      ? Object.fromEntries(
          Object.entries(value)
            .toSorted(([a], [b]) => (a < b ? -1 : 1))
            .map(([key, part]) => [key, sorted(part)]),
        )
      : value;

const areSame = (a: Shape, b: Shape) => JSON.stringify(sorted(whole(a))) === JSON.stringify(sorted(whole(b)));

/** The body of the parent that one takes the place of: that of its name. */
export const parentOf = (shape: Shape, parents: readonly Shape[]): Shape | null =>
  parents.find(({ name }) => name === shape.name) ?? null;

/** How a body differs from those of the parent; null where it does not. */
export function stateOf(shape: Shape, parents: readonly Shape[]): "new" | "changed" | null {
  const parent = parentOf(shape, parents);
  if (!parent) return "new";
  return areSame(shape, parent) ? null : "changed";
}

/** Bodies of the parent that are not there any more. */
export const removedOf = (shapes: readonly Shape[], parents: readonly Shape[]): Shape[] =>
  parents.filter(({ name }) => shapes.every((shape) => shape.name !== name));

/** mm of air between a new body and what is there. */
const AIR = 5;
const SIZE = 20;

/** Half of the box around a body, along x, y and z. */
function halfOf({ solid, axis }: Pick<Shape, "solid" | "axis">): Vec3 {
  const [x, y, z] =
    "box" in solid
      ? solid.box.size_mm
      : [2 * solid.cylinder.radius_mm, 2 * solid.cylinder.radius_mm, solid.cylinder.length_mm];
  const [u, v, w] = axesOf(axis ?? [0, 0, 1]);
  const along = (k: 0 | 1 | 2) => (Math.abs(u[k]) * x + Math.abs(v[k]) * y + Math.abs(w[k]) * z) / 2;
  return [along(0), along(1), along(2)];
}

/** Whether the boxes around two bodies come closer than a little air. */
export function areClose(a: Shape, b: Shape): boolean {
  const [half, other] = [halfOf(a), halfOf(b)];
  return a.at_mm.every((at, k) => Math.abs(at - (b.at_mm[k] ?? 0)) < (half[k] ?? 0) + (other[k] ?? 0) + AIR - 1e-9);
}

/** Where what is put or moved in the view comes from: nobody has measured that. */
export const PLACED = { source: "placed in the view", measured: false } as const;

/** A box or a cylinder below the wire at the pin, so far down that it meets nothing. */
export function newBody(solid: "box" | "cylinder", shapes: readonly Shape[], wire_mm: number): Shape {
  const names = new Set(shapes.map(({ name }) => name));
  let number = 1;
  while (names.has(`${solid} ${number}`)) number += 1;
  const made: Shape = {
    name: `${solid} ${number}`,
    part: "frame",
    solid: solid === "box" ? { box: { size_mm: [SIZE, SIZE, SIZE] } } : { cylinder: { radius_mm: 5, length_mm: SIZE } },
    at_mm: [0, 0, -Math.ceil(SIZE / 2 + wire_mm / 2 + AIR)],
    axis: [0, 0, 1],
    ...PLACED,
  };
  const place = (down: number): Shape => ({ ...made, at_mm: [0, 0, made.at_mm[2] - down] });
  // Below everything there is room.
  let down = 0;
  while (shapes.some((shape) => areClose(shape, place(down)))) down += AIR;
  return place(down);
}

/** "box · stands still · measured". */
export const phraseOf = ({ solid, part, measured }: Shape): string =>
  [
    "box" in solid ? "box" : "cylinder",
    PARTS.find(({ value }) => value === part)?.label.toLowerCase() ?? part,
    measured ? "measured" : "not measured",
  ].join(" · ");
