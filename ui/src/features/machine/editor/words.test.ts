import { expect, it } from "vitest";
import { shownValue } from "./words";

it.each([
  ["bend.pin_radius_mm", 1.5, "1.5 mm"],
  ["feed.rate_mm_per_s", 20, "20 mm/s"],
  ["rotate.backlash_deg", -0.25, "−0.25°"],
  ["youngs_modulus_gpa", 68.9, "68.9 GPa"],
  ["feed.scale", 1.002, "1.002"],
  ["springback.angle_deg", 2.4, "2.4°"],
  [
    "springback.positive",
    [
      [10, 1],
      [90, 4],
    ],
    "2 pairs",
  ],
  ["bend.before_zero", true, "yes"],
  ["calibrated.readings", 36, "36"],
  ["calibrated.machine", "my-kit", "my-kit"],
  ["of_another_time_mm", 2, "2 mm"],
  ["limits.max_stock_mm", null, "–"],
])("says a value of a profile with its unit: %s", (key, value, text) => {
  expect(shownValue(key, value, "mm")).toBe(text);
});

it("says lengths in the unit that is chosen", () => {
  expect(shownValue("bend.pin_radius_mm", 25.4, "inch")).toBe("1 in");
});
