import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import type { Shape } from "../../../generated/responses";
import { areClose, newBody, removedOf, stateOf } from "./bodies";

const MACHINES = ["wirebend-kit", "grbl-bender", "howtomechatronics", "table-bender"];

function shapesOf(id: string): Shape[] {
  const file = new URL(`../../../../../machine-profiles/machines/${id}.json`, import.meta.url);
  const { shapes } = JSON.parse(readFileSync(file, "utf8")) as { shapes: Shape[] };
  return shapes;
}

describe("newBody", () => {
  it.each(MACHINES)("puts a body on %s where it meets neither the wire nor another body", (id) => {
    let shapes = shapesOf(id);
    for (const solid of ["box", "cylinder", "box", "box"] as const) {
      const made = newBody(solid, shapes, 3);
      expect(shapes.filter((shape) => areClose(shape, made))).toEqual([]);
      const top = made.at_mm[2] + 10;
      expect(top).toBeLessThan(-1.5);
      expect(made.at_mm.slice(0, 2)).toEqual([0, 0]);
      shapes = [...shapes, made];
    }
    expect(new Set(shapes.map(({ name }) => name)).size).toBe(shapes.length);
  });
});

describe("stateOf", () => {
  const parents = shapesOf("wirebend-kit");
  const [first] = parents as [Shape];

  it("takes what is left out in a file for what it stands for", () => {
    const whole = { ...first, axis: [0, 0, 1] as Shape["axis"], contact_zone_mm: 0, vertex_zone_mm: 0 };
    expect(stateOf(whole, parents)).toBeNull();
  });

  it("says what is changed, also where it is the source alone, and what is new", () => {
    expect(stateOf({ ...first, source: "caliper", measured: true }, parents)).toBe("changed");
    expect(stateOf({ ...first, at_mm: [1, 2, 3] }, parents)).toBe("changed");
    expect(stateOf({ ...first, name: "lamp" }, parents)).toBe("new");
    expect(removedOf(parents.slice(1), parents)).toEqual([first]);
  });
});
