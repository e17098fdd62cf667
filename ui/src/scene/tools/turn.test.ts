import { expect, it } from "vitest";
import { given, MM, projectionOf } from "../testing";
import { Turn } from "./turn";

const CENTRE = [10, 0, 0] as const;
const FROM = new Map([
  [1, [10, 0, 0] as const],
  [2, [30, 0, 5] as const],
]);
const top = projectionOf("top");

/** Where a place in the plane of the top view is seen. */
const seen = (x: number, y: number) => top.seen([x, y, 0]);
const turn = () => new Turn(FROM, CENTRE, "z", MM);
const placeOf = (turned: Turn) => given(turned.moved.find(({ vertex }) => vertex === 2)).at.map((mm) => mm + 0);

it("turns right-handed about its middle, along with the pointer", () => {
  const turned = turn();
  turned.follow(seen(60, 0), top, false);
  expect(turned.deg).toBe(0);
  turned.follow(seen(10, 50), top, false);
  expect(turned.deg).toBeCloseTo(90);
  const [x, y, z] = placeOf(turned);
  expect(x).toBeCloseTo(10);
  expect(y).toBeCloseTo(20);
  expect(z).toBeCloseTo(5);
});

it("goes round more than once, and back", () => {
  const turned = turn();
  for (let deg = 0; deg <= 450; deg += 30) {
    const rad = (deg * Math.PI) / 180;
    turned.follow(seen(10 + 50 * Math.cos(rad), 50 * Math.sin(rad)), top, false);
  }
  expect(turned.deg).toBeCloseTo(450);
});

it("snaps to 15°, and is exact where an angle is typed", () => {
  const turned = turn();
  turned.follow(seen(60, 0), top, true);
  turned.follow(seen(60, 40), top, true);
  // The pointer is at 38.7°.
  expect(turned.deg).toBe(45);
  for (const key of ["-", "1", "2", ".", "5"]) expect(turned.type(key)).toBe(true);
  turned.follow(seen(60, 0), top, true);
  expect(turned.deg).toBe(-12.5);
  expect(turned.readout).toBe("about z −12.5▏°");
});

it("stays as it is beyond the horizon of its plane", () => {
  const view = projectionOf("perspective");
  const turned = new Turn(FROM, CENTRE, "z", MM);
  const beside = (x: number, y: number) => view.seen([CENTRE[0] + x, CENTRE[1] + y, 0]);
  turned.follow(beside(40, 0), view, false);
  turned.follow(beside(0, 40), view, false);
  expect(turned.deg).toBeCloseTo(90);
  // Far above the middle of the picture there is sky.
  turned.follow({ x: 400, y: -20_000 }, view, false);
  expect(turned.deg).toBeCloseTo(90);
});

it("begins anew about another axis", () => {
  const turned = turn();
  turned.follow(seen(60, 0), top, false);
  turned.follow(seen(10, 50), top, false);
  turned.lock("x");
  expect([turned.deg, placeOf(turned)]).toEqual([0, [30, 0, 5]]);
  // Seen from its side an axis tells no angle.
  turned.follow(seen(10, 80), top, false);
  expect(turned.deg).toBe(0);
});
