import { afterEach, expect } from "vitest";
import { moved } from "./movements.ts";

// A click that is on its way would land on something else, and some of it moves machines.
afterEach(async () => {
  expect(await moved(), "moved under the pointer").toEqual([]);
});
