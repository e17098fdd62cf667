import { describe, expect, it } from "vitest";
import type { LengthFormat, Vec3 } from "../interface";
import { given, INCH, MM, projectionOf } from "../testing";
import { Grab, type Surroundings } from "./grab";
import { displacement } from "./move";
import { NumberEntry } from "./number_entry";

const front = projectionOf("front");
const START = { x: 400, y: 300 };
const alone: Surroundings = { projection: front, target: () => null, grid: () => false, spacing: 10 };

const grabbed = (lengths: LengthFormat = MM): Grab =>
  new Grab(
    new Map<number, Vec3>([
      [7, [0, 0, 0]],
      [8, [50, 1, 2]],
    ]),
    [0, 0, 0],
    START,
    lengths,
  );
const rounded = (at: Vec3): number[] => at.map((part) => Math.round(part * 1e6) / 1e6 + 0);

it("follows the pointer in the plane of the view, all vertices alike", () => {
  const grab = grabbed();
  grab.follow({ x: 430, y: 280 }, alone, true);
  // Front view: 30 pixels right and 20 up are 30 mm in x and 20 mm in z.
  expect(grab.moved.map(({ vertex, at }) => [vertex, rounded(at)])).toEqual([
    [7, [30, 0, 20]],
    [8, [80, 1, 22]],
  ]);
});

it("stays on a locked axis, and is freed by the same key again", () => {
  const grab = grabbed();
  grab.lock("z");
  grab.follow({ x: 430, y: 280 }, alone, true);
  expect(rounded(grab.by)).toEqual([0, 0, 20]);
  grab.lock("z");
  grab.follow({ x: 430, y: 280 }, alone, true);
  expect(rounded(grab.by)).toEqual([30, 0, 20]);
});

it("stays in a locked plane", () => {
  const projection = projectionOf("perspective");
  const to = projection.seen([20, -35, 0]);
  const by = displacement({ kind: "plane", normal: "z" }, [0, 0, 0], projection.seen([0, 0, 0]), to, projection);
  expect(rounded(by).map((part) => Math.round(part * 100) / 100)).toEqual([20, -35, 0]);
});

it("goes nowhere along an axis that is seen from its end", () => {
  const grab = grabbed();
  grab.lock("y");
  grab.follow({ x: 430, y: 280 }, alone, true);
  expect(grab.by).toEqual([0, 0, 0]);
});

describe("typed numbers", () => {
  const typed = (keys: string, axis: "x" | "y" | "z" | null, lengths: LengthFormat = MM): Grab => {
    const grab = grabbed(lengths);
    if (axis) grab.lock(axis);
    for (const key of keys) grab.type(key);
    grab.follow({ x: 430, y: 280 }, alone, true);
    return grab;
  };

  it("go along the locked axis, whatever the pointer does", () => {
    expect(rounded(typed("12.5", "y").by)).toEqual([0, 12.5, 0]);
    expect(rounded(typed("3-", "z").by)).toEqual([0, 0, -3]);
  });

  it("go along x where no axis is locked, and say so", () => {
    const grab = typed("4", null);
    expect(rounded(grab.by)).toEqual([4, 0, 0]);
    expect(grab.readout).toMatch(/^x 4/);
  });

  it("are inches where the editor shows inches", () => {
    expect(rounded(typed("2", "x", INCH).by)).toEqual([50.8, 0, 0]);
  });

  it("give the pointer back when they are deleted", () => {
    const grab = typed("7", "x");
    const entry = grab.entry;
    entry.key("Backspace");
    grab.follow({ x: 430, y: 280 }, alone, true);
    expect(rounded(grab.by)).toEqual([30, 0, 0]);
  });

  it("take a comma for a point, one point only, and no letters", () => {
    const entry = new NumberEntry();
    for (const key of "-,2.5") entry.key(key);
    expect(entry.value).toBe(-0.25);
    expect(entry.key("a")).toBe(false);
    entry.clear();
    expect(entry.value).toBeNull();
  });
});

describe("snapping", () => {
  const target: Surroundings = {
    ...alone,
    target: (x, y) => (Math.hypot(x - 430, y - 280) < 10 ? [31, -5, 21] : null),
  };

  it("puts the anchor on the target, where the anchor would be and not where the pointer is", () => {
    const grab = new Grab(new Map<number, Vec3>([[7, [100, 0, 0]]]), [100, 0, 0], START, MM);
    grab.follow({ x: 332, y: 282 }, target, true);
    expect(rounded(given(grab.moved[0]).at)).toEqual([31, -5, 21]);
  });

  it("takes the part along a locked axis only", () => {
    const grab = grabbed();
    grab.lock("x");
    grab.follow({ x: 430, y: 280 }, { ...alone, target: () => [31, -5, 21] }, true);
    expect(rounded(grab.by)).toEqual([31, 0, 0]);
  });

  it("is left out while the key for it is held", () => {
    const grab = grabbed();
    grab.follow({ x: 430, y: 280 }, target, false);
    expect(rounded(grab.by)).toEqual([30, 0, 20]);
  });

  it("rounds places and not distances, and not the depth of an axis view", () => {
    const grab = new Grab(new Map<number, Vec3>([[1, [3, 4, 5]]]), [3, 4, 5], START, MM);
    grab.follow({ x: 418, y: 300 }, { ...alone, grid: () => true }, true);
    // 3 + 18 is nearest to 20, 5 to 10 (halves go up); y is the depth and stays at 4.
    expect(rounded(given(grab.moved[0]).at)).toEqual([20, 4, 10]);
  });
});
