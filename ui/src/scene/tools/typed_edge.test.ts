import { expect, it } from "vitest";
import { INCH, MM } from "../testing";
import { TypedEdge } from "./typed_edge";

const FROM = [10, 0, 0] as const;
const TO = [10, 30, 40] as const;

function typed(keys: string): TypedEdge {
  const edge = new TypedEdge();
  for (const key of keys) edge.type(key);
  return edge;
}

it("ends where the pointer shows to, as far away as is typed, in the unit that is shown", () => {
  expect(typed("25").towards(TO, MM)?.(FROM)?.at).toEqual([10, 15, 20]);
  expect(
    typed("1")
      .towards(
        TO,
        INCH,
      )?.(FROM)
      ?.at.map((x) => x.toFixed(2)),
  ).toEqual(["10.00", "15.24", "20.32"]);
});

it("ends nowhere without a length, or without a way", () => {
  expect(typed("").towards(TO, MM)).toBeNull();
  expect(typed("0").towards(TO, MM)).toBeNull();
  expect(typed("25").towards(FROM, MM)?.(FROM)).toBeNull();
});

it("takes the keys of a length, and leaves all others to those that they belong to", () => {
  const edge = typed("2.5");
  expect(["-", "a", "Enter"].map((key) => edge.type(key))).toEqual([false, false, false]);
  expect(edge.readout(FROM, TO, MM)).toBe("edge 2.5▏ mm, Enter places it");
  for (const key of ["Backspace", "Backspace", "Backspace"]) expect(edge.type(key)).toBe(true);
  expect([edge.begun, edge.type("Backspace")]).toEqual([false, false]);
  expect([edge.readout(FROM, TO, MM), edge.readout(FROM, TO, INCH)]).toEqual(["edge 50.0 mm", "edge 1.969 in"]);
});
