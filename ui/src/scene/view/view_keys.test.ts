import { expect, it } from "vitest";
import { given } from "../testing";
import { FIRST, shifted, turned } from "./orbit";
import { afterKey } from "./view_keys";

const press = (key: string, shiftKey = false) => afterKey(FIRST, { key, shiftKey }, 600);

it("turns as dragging the same way does, and the other way back", () => {
  expect(press("ArrowRight")).toEqual({ orbit: turned(FIRST, 24, 0), turned: true });
  const { orbit } = given(press("ArrowUp"));
  expect(afterKey(orbit, { key: "ArrowDown", shiftKey: false }, 600)?.orbit.pitch).toBeCloseTo(FIRST.pitch, 12);
});

it("shifts with Shift, without turning", () => {
  expect(press("ArrowDown", true)).toEqual({ orbit: shifted(FIRST, 0, 24, 600), turned: false });
});

it("comes nearer with plus, farther with minus, about the middle", () => {
  expect(press("+")?.orbit.distance).toBeLessThan(FIRST.distance);
  expect(press("-")?.orbit.distance).toBeGreaterThan(FIRST.distance);
  expect(press("+")?.orbit.target).toEqual(FIRST.target);
});

it("leaves other keys alone", () => {
  for (const key of ["a", "Enter", " ", "Tab", "1"]) expect(press(key)).toBeNull();
});
