// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import { USUAL_SPEEDS } from "./clock";
import { keptSpeeds } from "./player";

describe("keptSpeeds", () => {
  it("takes what makes sense, and the usual for the rest", () => {
    expect(keptSpeeds(null)).toEqual(USUAL_SPEEDS);
    expect(keptSpeeds("{")).toEqual(USUAL_SPEEDS);
    expect(keptSpeeds('{"feed": 2, "bend": -1, "rotate": "fast", "all": 1000}')).toEqual({ ...USUAL_SPEEDS, feed: 2 });
  });
});
