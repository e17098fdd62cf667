/**
 * A bend head from above with its dimensions, to scale. The head: mm, the origin where a bend begins, x along the wire that comes,
 * y to the side of a positive bend. The drawing: px, x to the right, y down.
 */

import type { HeadReport } from "../../../generated/responses";

type Point = readonly [number, number];

interface Circle {
  readonly at: Point;
  readonly radius: number;
}

/** A line between two places with its figure; `key` is the value that it shows. */
interface Dimension {
  readonly key: string;
  readonly from: Point;
  readonly to: Point;
  /** Where its text stands. */
  readonly text: Point;
  readonly anchor: "start" | "middle" | "end";
  /** "R", "s", "pin", "peg". */
  readonly name: string;
  readonly mm: number;
}

export interface HeadDrawing {
  /** px a mm. */
  readonly scale: number;
  /** How thick the wire is, px. */
  readonly wire: number;
  /** The centreline of the wire, as an SVG path. */
  readonly path: string;
  readonly pin: Circle;
  readonly peg: Circle | null;
  /** The path of the peg. */
  readonly orbit: Circle | null;
  /** Where the bend begins. */
  readonly begin: Point;
  readonly dimensions: readonly Dimension[];
}

/** px around the head, for the figures. */
const MARGIN = 26;
/** px from the wire to the dimension of the offset. */
const BELOW = 22;

export function drawingOf(head: HeadReport, width: number, height: number): HeadDrawing {
  const half = head.wire_mm / 2;
  // The centreline goes around the pin at this radius.
  const around = head.pin_radius_mm + half;
  const { peg } = head;
  const reach = peg ? peg.orbit_radius_mm : 4 * around;
  const centre = peg ? peg.orbit_offset_mm : 0;
  const pegRadius = peg?.radius_mm ?? 0;
  const left = Math.min(centre - reach, -2 * around) - pegRadius;
  const right = Math.max(centre + reach, around + half) + pegRadius;
  const top = Math.max(reach + pegRadius, 3 * around) + half;
  const bottom = -Math.max(pegRadius, head.wire_mm);
  const scale = Math.min((width - 2 * MARGIN) / (right - left), (height - 2 * MARGIN - BELOW) / (top - bottom));
  const middle = (left + right) / 2;
  const at = (x: number, y: number): Point => [width / 2 + (x - middle) * scale, MARGIN + (top - y) * scale];
  const text = ([x, y]: Point): string => `${x.toFixed(2)} ${y.toFixed(2)}`;
  const r = around * scale;
  const path = `M ${text(at(left, 0))} L ${text(at(0, 0))} A ${r.toFixed(2)} ${r.toFixed(2)} 0 0 0 ${text(
    at(around, around),
  )} L ${text(at(around, top))}`;
  const pin: Circle = { at: at(0, around), radius: head.pin_radius_mm * scale };
  const dimensions: Dimension[] = [
    {
      key: "bend.pin_radius_mm",
      from: pin.at,
      to: [pin.at[0] - pin.radius, pin.at[1]],
      text: [pin.at[0] - pin.radius - 8, pin.at[1] - 6],
      anchor: "end",
      name: "pin",
      mm: head.pin_radius_mm,
    },
  ];
  const begin = at(0, 0);
  if (peg) {
    const focus = at(peg.orbit_offset_mm, 0);
    const stands = peg.at_mm ? at(...peg.at_mm) : at(peg.orbit_offset_mm + peg.orbit_radius_mm, 0);
    const low = begin[1] + Math.max((head.wire_mm / 2) * scale, 4) + BELOW;
    dimensions.push(
      {
        key: "bend.orbit_radius_mm",
        from: focus,
        to: stands,
        text: [(focus[0] + stands[0]) / 2 + 8, (focus[1] + stands[1]) / 2],
        anchor: "start",
        name: "R",
        mm: peg.orbit_radius_mm,
      },
      {
        key: "bend.orbit_offset_mm",
        from: [begin[0], low],
        to: [focus[0], low],
        text: [(begin[0] + focus[0]) / 2, low + 16],
        anchor: "middle",
        name: "s",
        mm: peg.orbit_offset_mm,
      },
      {
        key: "bend.rod_radius_mm",
        from: stands,
        to: [stands[0] + peg.radius_mm * scale, stands[1]],
        text: [stands[0] + peg.radius_mm * scale + 8, stands[1] + 4],
        anchor: "start",
        name: "peg",
        mm: peg.radius_mm,
      },
    );
    return {
      scale,
      wire: head.wire_mm * scale,
      path,
      pin,
      begin,
      peg: { at: stands, radius: peg.radius_mm * scale },
      orbit: { at: focus, radius: peg.orbit_radius_mm * scale },
      dimensions,
    };
  }
  return { scale, wire: head.wire_mm * scale, path, pin, begin, peg: null, orbit: null, dimensions };
}
