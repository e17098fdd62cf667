/** The cube that shows from where the view looks: what of it is seen, and where. Pure: the cube reaches from -1 to 1 along each axis. */

import type { Vec3, ViewAxes } from "../../scene/interface";
import type { Side } from "../../state/window/view";

/** A face, an edge or a corner by the way to it from the middle: each part is -1, 0 or 1. */
export type Zone = Vec3;

/** As seen from that side, z up; from above and below, x to the right. */
const SIDES: Readonly<Record<Side, { readonly out: Vec3; readonly right: Vec3; readonly up: Vec3 }>> = {
  front: { out: [0, -1, 0], right: [1, 0, 0], up: [0, 0, 1] },
  back: { out: [0, 1, 0], right: [-1, 0, 0], up: [0, 0, 1] },
  right: { out: [1, 0, 0], right: [0, 1, 0], up: [0, 0, 1] },
  left: { out: [-1, 0, 0], right: [0, -1, 0], up: [0, 0, 1] },
  top: { out: [0, 0, 1], right: [1, 0, 0], up: [0, 1, 0] },
  bottom: { out: [0, 0, -1], right: [1, 0, 0], up: [0, -1, 0] },
};

/** Each side before the one across from it, as their keys go. */
export const SIDE_NAMES: readonly Side[] = ["front", "back", "right", "left", "top", "bottom"];

/** Where a face ends and its edges begin: these are wide enough to be clicked on. */
const CUT = 0.58;
const CUTS = [-1, -CUT, CUT, 1] as const;
const STEPS = [-1, 0, 1] as const;
/** The cosine at which a face is seen from its edge, so nearly that nothing on it can be read or clicked. */
const EDGE_ON = 0.04;

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const plus = (a: Vec3, b: Vec3, by: number): Vec3 => [a[0] + b[0] * by, a[1] + b[1] * by, a[2] + b[2] * by];
const tidy = (value: number): string => String(Math.round(value * 100) / 100 + 0);

/** "Top, front, right" of a corner. */
export function zoneName([x, y, z]: Zone): string {
  const parts = [z && (z > 0 ? "top" : "bottom"), y && (y > 0 ? "back" : "front"), x && (x > 0 ? "right" : "left")];
  const name = parts.filter((part) => part !== 0).join(", ");
  return (name[0] ?? "").toUpperCase() + name.slice(1);
}

/** The face of a side, as a zone. */
export const zoneOf = (side: Side): Zone => SIDES[side].out;

/** The side that a zone is the face of; null of an edge or a corner. */
export const sideOf = (zone: Zone): Side | null =>
  SIDE_NAMES.find((side) => dot(SIDES[side].out, zone) === dot(zone, zone)) ?? null;

/** What of a zone lies on a face. */
interface Patch {
  readonly zone: Zone;
  /** Corners in the picture, as an SVG polygon takes them. */
  readonly points: string;
}

interface Face {
  readonly side: Side;
  readonly points: string;
  readonly patches: readonly Patch[];
  /** From a picture of the face with x to the right and y down to the picture, as SVG takes it. */
  readonly transform: string;
  /** How squarely it is seen: 1 straight on. */
  readonly square: number;
}

/** The faces that are seen; `scale`: CSS pixels from the middle of the cube to a face. The middle is the origin, y goes down. */
export function facesOf({ right, up, back }: ViewAxes, scale: number): Face[] {
  const x = (way: Vec3) => dot(way, right) * scale;
  const y = (way: Vec3) => -dot(way, up) * scale;
  return SIDE_NAMES.flatMap((side): Face[] => {
    const { out, right: u, up: v } = SIDES[side];
    const square = dot(out, back);
    if (square < EDGE_ON) return [];
    const corner = (a: number, b: number) => {
      const at = plus(plus(out, u, a), v, b);
      return `${tidy(x(at))},${tidy(y(at))}`;
    };
    const area = (left: number, low: number, rightmost: number, high: number) =>
      [corner(left, low), corner(rightmost, low), corner(rightmost, high), corner(left, high)].join(" ");
    const patches = STEPS.flatMap((row, j) =>
      STEPS.map(
        (column, i): Patch => ({
          zone: plus(plus(out, u, column), v, row),
          points: area(CUTS[i] ?? -1, CUTS[j] ?? -1, CUTS[i + 1] ?? 1, CUTS[j + 1] ?? 1),
        }),
      ),
    );
    // Of length 1 a pixel: letters keep their size.
    const matrix = [x(u) / scale, y(u) / scale, -x(v) / scale, -y(v) / scale, x(out), y(out)];
    return [{ side, points: area(-1, -1, 1, 1), patches, transform: `matrix(${matrix.map(tidy).join(" ")})`, square }];
  });
}
