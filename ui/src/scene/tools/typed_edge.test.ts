import { expect, it } from "vitest";
import type { DrawingPlane } from "../interface";
import { INCH, MM } from "../testing";
import { TypedEdge } from "./typed_edge";

const FRONT: DrawingPlane = { origin: [0, 0, 0], u: [1, 0, 0], v: [0, 0, 1] };
const FROM = [10, 0, 0] as const;
const TO = [40, 0, 40] as const;

/** `>` for Tab. */
function typed(keys: string): TypedEdge {
  const edge = new TypedEdge();
  for (const key of keys)
    if (key === ">") edge.other();
    else edge.type(key);
  return edge;
}
const ends = (keys: string, to: readonly [number, number, number] = TO, lengths = MM) =>
  typed(keys)
    .towards(
      to,
      FRONT,
      lengths,
    )?.(FROM)
    ?.at.map((x) => Number(x.toFixed(6)));

it("ends where the pointer shows to, as far away as is typed, in the unit that is shown", () => {
  expect(ends("25")).toEqual([25, 0, 20]);
  expect(ends("1", TO, INCH)).toEqual([25.24, 0, 20.32]);
});

it("goes the typed way, as far as is typed or as far as the pointer is along it", () => {
  // Exactly, not by the rounding of a cosine.
  expect(typed("25>90").towards(TO, FRONT, MM)?.(FROM)?.at).toEqual([10, 0, 25]);
  expect(ends("20>30")).toEqual([27.320508, 0, 10]);
  expect(ends("20>-30")).toEqual([27.320508, 0, -10]);
  expect(ends(">0")).toEqual([40, 0, 0]);
  // Behind the pointer, as far as it is away.
  expect(ends(">180")).toEqual([-40, 0, 0]);
  expect(ends(">90>25")).toEqual([10, 0, 25]);
});

it("ends nowhere without a figure, or without a way", () => {
  expect(typed("").towards(TO, FRONT, MM)).toBeNull();
  expect(typed("0").towards(TO, FRONT, MM)).toBeNull();
  expect(typed(">").towards(TO, FRONT, MM)).toBeNull();
  expect(typed("25").towards(FROM, FRONT, MM)?.(FROM)).toBeNull();
});

it("takes the keys of a number, and leaves all others to those that they belong to", () => {
  const edge = typed("2.5");
  const shown = () => edge.dimensions(FROM, TO, FRONT, MM);
  expect(["-", "a", "Enter"].map((key) => edge.type(key))).toEqual([false, false, false]);
  expect(shown()).toBe("2.5▏ mm · 53.1°");
  expect(edge.readout(shown())).toBe("edge 2.5▏ mm · 53.1°   Tab: angle, Enter: place");
  edge.other();
  expect(["-", "4", "5"].map((key) => edge.type(key))).toEqual([true, true, true]);
  expect(edge.readout(shown())).toBe("edge 2.5 mm · −45▏°   Tab: length, Enter: place");
  edge.clear();
  expect([edge.begun, edge.type("Backspace")]).toEqual([false, false]);
  expect(edge.readout(shown())).toBe("edge 50.0 mm · 53.1°   Tab: angle");
  expect(edge.dimensions(FROM, TO, FRONT, INCH)).toBe("1.969 in · 53.1°");
});
