import { describe, expect, it } from "vitest";
import type { SettingValue } from "../../../generated/responses";
import { changedKeys, ownKeys, sameValue, sourceOf, sourcePhrase, toWrite, valuesOf } from "./values";

const setting = (
  key: string,
  value: unknown,
  set_by: string | null = null,
  line: number | null = null,
): SettingValue => ({
  key,
  value: value as SettingValue["value"],
  set_by,
  file: null,
  line,
});

const SETTINGS = [
  setting("expected.$110", 500, "my-kit", 14),
  setting("baud", 115200, "my-kit", 12),
  setting("homing", "none", "grbl-bender", 18),
  setting("decimals", 3),
  setting("expected", {}),
];

describe("valuesOf", () => {
  it("puts what is within an object where it belongs, whatever the order", () => {
    expect(valuesOf(SETTINGS)).toEqual({ baud: 115200, homing: "none", decimals: 3, expected: { $110: 500 } });
  });
});

describe("sources", () => {
  it("names profile and line, or the driver", () => {
    const phrase = (key: string) => sourcePhrase(sourceOf(SETTINGS, key), "my-kit");
    expect(phrase("baud")).toBe("set here, line 12");
    expect(phrase("homing")).toBe("set by grbl-bender, line 18");
    expect(phrase("decimals")).toBe("driver's default");
    expect(phrase("expected")).toBe("set here, line 14");
    expect([...ownKeys(SETTINGS, "my-kit")].toSorted()).toEqual(["baud", "expected"]);
  });
});

describe("toWrite", () => {
  const before = valuesOf(SETTINGS);
  const own = ownKeys(SETTINGS, "my-kit");

  it("keeps what the profile sets, adds what was changed, and leaves the rest to its parent", () => {
    expect(toWrite(before, { ...before, decimals: 4 }, own)).toEqual({
      baud: 115200,
      expected: { $110: 500 },
      decimals: 4,
    });
  });

  it("takes back what is to be the parent's again", () => {
    expect(toWrite(before, before, own, "baud")).toEqual({ expected: { $110: 500 } });
  });

  it("leaves out what was emptied", () => {
    expect(toWrite(before, { ...before, baud: undefined }, own)).toEqual({ expected: { $110: 500 } });
  });

  it("knows what was changed", () => {
    expect(changedKeys(before, { ...before, expected: { $110: 600 }, homing: "none" })).toEqual(["expected"]);
    expect(sameValue({ a: 1, b: [1, 2] }, { b: [1, 2], a: 1 })).toBe(true);
    expect(sameValue(null, undefined)).toBe(true);
    expect(sameValue([1], { 0: 1 })).toBe(false);
  });
});
