import { describe, expect, it } from "vitest";
import type { KindReport, MachineEntry } from "../../../generated/responses";
import { residualsOf } from "./residuals";
import { parseAngles, parseReading, unbentPhrase, usualAngles, versionsOf } from "./words";

describe("parseReading", () => {
  it.each([
    ["90.5", "deg", 90.5],
    ["90,5°", "deg", 90.5],
    ["−89", "deg", -89],
    ["35.2 mm", "mm", 35.2],
    ["", "deg", null],
    ["-", "deg", null],
    ["9o", "deg", undefined],
  ])("reads %j in %s as a person means it", (text, unit, expected) => {
    expect(parseReading(text, unit)).toBe(expected);
  });
});

describe("parseAngles", () => {
  it.each([
    ["", []],
    ["20, 45; 90", [20, 45, 90]],
    ["20 x", null],
    ["0", null],
    ["-20", null],
  ])("reads %j", (text, expected) => {
    expect(parseAngles(text)).toEqual(expected);
  });
});

it("says which jobs have to be bent before a simulated machine has readings of them", () => {
  expect(unbentPhrase([])).toBeNull();
  expect(unbentPhrase(["turns.wbjob"])).toBe(
    "There is no new simulated run of turns.wbjob. Bend it on the simulated machine first, with Run… in Coupons.",
  );
  expect(unbentPhrase(["angles.wbjob", "sides.wbjob", "turns.wbjob"])).toContain(
    "of angles.wbjob, sides.wbjob and turns.wbjob. Bend them",
  );
});

describe("usualAngles", () => {
  it.each([
    [[-120, 120], "20° to at most 120°"],
    [[-155, 155], "20° to at most 135°"],
    // To both sides.
    [[-90, 112.5], "20° to at most 90°"],
    [null, "20° to what the machine can bend"],
  ] as const)("follows a machine of %j", (bends, expected) => {
    expect(usualAngles(bends)).toBe(expected);
  });
});

describe("residualsOf", () => {
  const kind = (values: readonly (readonly [number, number])[]): KindReport =>
    ({
      scatter: 0.1,
      values: values.map(([commanded, off], at) => ({
        line: at + 1,
        reading: 1,
        commanded,
        read: 10 + off,
        fitted: 10,
      })),
    }) as unknown as KindReport;

  it("puts what is read above the model above the middle, in one scale", () => {
    const { points, zero, most } = residualsOf(
      kind([
        [-90, 0.4],
        [0, -0.2],
        [90, 0],
      ]),
      320,
      132,
    );
    expect(most).toBeCloseTo(0.4);
    expect(points.map(({ x }) => x)).toEqual([10, 160, 310]);
    expect(zero - (points[0]?.y ?? 0)).toBeCloseTo(2 * ((points[1]?.y ?? 0) - zero));
    expect(points[2]?.y).toBeCloseTo(zero);
  });

  it("draws one reading in the middle", () => {
    expect(residualsOf(kind([[40, 0]]), 320, 132).points[0]?.x).toBe(160);
  });
});

describe("versionsOf", () => {
  it("puts the newest first, and last what they were made from, with the wire that it had then", () => {
    const machine = (id: string, date: string | null) =>
      ({
        id,
        name: id.toUpperCase(),
        default_material: `wire-of-${id}`,
        ...(date
          ? { calibrated: { date, readings: 9, machine: date > "2026-06" ? "first" : "kit", material: "spool" } }
          : {}),
      }) as MachineEntry;
    const all = [
      machine("first", "2026-05-01"),
      machine("kit", null),
      machine("other", null),
      machine("second", "2026-11-27"),
    ];
    expect(versionsOf(all).map(({ id, material }) => [id, material])).toEqual([
      ["second", "wire-of-second"],
      ["first", "wire-of-first"],
      ["kit", "spool"],
    ]);
  });
});
