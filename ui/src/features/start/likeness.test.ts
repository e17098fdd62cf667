import { expect, it } from "vitest";
import { likeness } from "./likeness";

it("says of a model in the wrong unit that it may be", () => {
  expect(likeness(0.3)).toMatch(/check the unit/);
  expect(likeness(248_000)).toMatch(/check the unit/);
  expect(likeness(312)).toBe("about as large as a bottle");
  expect(likeness(0)).toBeNull();
  expect(likeness(Number.NaN)).toBeNull();
});
