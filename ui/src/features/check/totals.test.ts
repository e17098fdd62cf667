import { expect, it } from "vitest";
import type { Fix } from "../../generated/responses";
import { afterwards, metOf } from "./totals";

const fix = (errors_after: number, length_mm: number | null): Fix =>
  ({
    errors_after,
    change: { length_mm, stock_mm: null, time_s: null, cost: null, currency: null },
    after: { wires: 1, collisions: null },
  }) as unknown as Fix;

it("says of errors that a fix brings to light that they could not be checked before", () => {
  expect(afterwards(fix(3, null), 4)).toBe("gives a wire with 3 errors");
  expect(afterwards(fix(53, null), 15)).toBe(
    "gives a wire with 53 errors, of which at least 38 could not be checked before",
  );
  expect(afterwards(fix(4, 2), 4)).toBe("then 4 errors");
});

it("tells what a fix leaves that is hit from what only comes near", () => {
  expect(metOf({ collisions: null, near: null })).toBeNull();
  expect(metOf({ collisions: 0, near: 0 })).toBe("no collision found");
  expect(metOf({ collisions: 2, near: 0 })).toBe("2 collisions");
  expect(metOf({ collisions: 0, near: 1 })).toBe("no collision found, and 1 place nearer than the clearance");
});
