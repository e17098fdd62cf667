import { describe, expect, it } from "vitest";
import {
  ago,
  angle,
  count,
  length,
  lengthFormat,
  longLength,
  money,
  number,
  percent,
  roughly,
  short,
  signed,
  speed,
  time,
} from "./format";
import { parseAngle, parseLength, parseNumber } from "./parse";

const thin = (text: string) => text.replaceAll("_", "\u202f").replaceAll("-", "\u2212");

describe("figures as a person reads them", () => {
  it.each([
    [11821.44, "11_821.4"],
    [999.94, "999.9"],
    [999.95, "1_000.0"],
    [1234567, "1_234_567.0"],
    [-35, "-35.0"],
    [-0.04, "0.0"],
    [Number.NaN, "\u2013"],
  ])("%f is %s", (value, text) => expect(number(value)).toBe(thin(text)));

  it("shows lengths with the digits that a machine can make", () => {
    expect(length(601.42, "mm")).toBe("601.4 mm");
    expect(length(25.4, "inch")).toBe("1.000 in");
    expect([speed(110.2, "mm"), speed(110.2, "inch")]).toEqual(["110.2 mm/s", "4.339 in/s"]);
    expect(longLength(12_220, "mm")).toBe("12.22 m");
    expect(longLength(9_999, "mm")).toBe(thin("9_999.0 mm"));
    expect(longLength(3657.6, "inch")).toBe("12.00 ft");
  });

  it.each([
    [5, "5"],
    [0.1 + 0.2, "0.3"],
    [-0.125, "-0.125"],
    [1500, "1_500"],
    [1 / 3, "0.333333"],
  ])("shows %f with the digits that it needs, as %s", (value, text) => expect(short(value)).toBe(thin(text)));

  it("gives the scene the same formats", () => {
    const { mm, name, number: figure, short: round } = lengthFormat("inch");
    expect([mm, name, figure(-25.4), round(6.35)]).toEqual([25.4, "in", thin("-1.000"), "0.25"]);
    expect([lengthFormat("mm").number(1250), lengthFormat("mm").short(10)]).toEqual([thin("1_250.0"), "10"]);
  });

  it("shows angles, shares, counts and differences", () => {
    expect(angle(-151.26)).toBe(thin("-151.3°"));
    expect(percent(0.374)).toBe("37 %");
    expect([count(1, "vertex", "vertices"), count(57, "vertex", "vertices"), count(0, "edge")]).toEqual([
      "1 vertex",
      "57 vertices",
      "0 edges",
    ]);
    expect(signed(601.4, (mm) => length(mm, "mm"))).toBe("+601.4 mm");
    expect(signed(-2, (mm) => length(mm, "mm"))).toBe(thin("-2.0 mm"));
    expect([roughly(812), roughly(3400), roughly(69451), roughly(1_250_000)]).toEqual(["812", "3.4k", "69k", "1.3M"]);
  });

  it.each([
    [42, "0:42"],
    [3130, "52:10"],
    [3599.6, "1 h 00"],
    [3725, "1 h 02"],
  ])("%f seconds are %s", (seconds, text) => expect(time(seconds)).toBe(text));

  it("puts the sign of a currency in front, its name behind", () => {
    expect(money(1.2, "USD")).toBe("$1.20");
    expect(money(-1.2, "EUR")).toBe(thin("-€1.20"));
    expect(money(23.5, "CHF")).toBe("23.50 CHF");
    expect(money(3, null)).toBe("3.00");
  });

  it("says how long ago", () => {
    expect([0, 12, 320, 7200, 90_000, 180_000].map(ago)).toEqual([
      "now",
      "12 s ago",
      "5 min ago",
      "2 h ago",
      "1 day ago",
      "2 days ago",
    ]);
  });
});

describe("figures as a person types them", () => {
  it.each([
    ["12.5", 12.5],
    ["12,5", 12.5],
    [" 1/2 ", 0.5],
    ["1 1/2", 1.5],
    ["-1 1/2", -1.5],
    ["\u22123", -3],
    ["1\u202f250.5", 1250.5],
    ["1.250,5", 1250.5],
    ["1,250.5", 1250.5],
    [".5", 0.5],
    ["1e3", 1000],
    ["", null],
    ["abc", null],
    ["1/0", null],
    ["1.2.3", null],
    ["1'250'000", 1_250_000],
    ["1\u202f250,25", 1250.25],
    ["- 3", -3],
    ["5'6", null],
    ["5 6", null],
    ["1'25", null],
    ["--1", null],
  ])("%j", (text, value) => expect(parseNumber(text)).toBe(value));

  it.each([
    ["12", "mm", 12],
    ["12 mm", "inch", 12],
    ["1/2 in", "mm", 12.7],
    ['1/2"', "mm", 12.7],
    ["2", "inch", 50.8],
    ["1.5cm", "mm", 15],
    ["1 m", "mm", 1000],
    ["2 ft", "mm", 609.6],
    // 5 ft 6 in are 66 in, of 25.4 mm each.
    ["5'6\"", "inch", 1676.4],
    ["5\u20326\u2033", "mm", 1676.4],
    ["5'-6\"", "inch", 1676.4],
    ["5 ft 6 in", "mm", 1676.4],
    ["5'6", "inch", 1676.4],
    ["5' 6 1/2\"", "inch", 1689.1],
    ["-5'6\"", "inch", -1676.4],
    ["5'", "mm", 1524],
    // With room before it a minus takes away, as in every other sum.
    ["5 ft - 1 in", "mm", 1498.6],
    ["5' - 1\"", "mm", 1498.6],
    ["5'+3\"", "mm", 1600.2],
    ["1'250 mm", "inch", 1250],
    ["1'005", "mm", 1005],
    ["5'6 mm", "mm", null],
    ["5'13\"", "inch", null],
    ["3 apples", "mm", null],
    ["mm", "mm", null],
  ] as const)("%j shown in %s", (text, unit, mm) => {
    const read = parseLength(text, unit);
    if (mm === null) expect(read).toBeNull();
    else expect(read).toBeCloseTo(mm, 9);
  });

  it("reads angles", () => {
    expect([parseAngle("45"), parseAngle("45,5°"), parseAngle("-90 deg"), parseAngle("x")]).toEqual([
      45,
      45.5,
      -90,
      null,
    ]);
    expect(parseAngle("1 rad")).toBeCloseTo(57.29578, 5);
  });
});
