import { expect, it } from "vitest";
import { flown } from "./flight";
import { FIRST, looking, lookingFrom } from "./orbit";

const at = (yaw: number, pitch = 0) => ({ ...FIRST, yaw, pitch });

it("begins where the view is, passes its middle halfway, and arrives at the very view", () => {
  const [from, to] = [at(-1, 0.2), looking(FIRST, "right")];
  const flight = { from, to, begun: 1000 };
  expect(flown(flight, 1000)).toEqual({ orbit: from, arrived: false });
  const half = flown(flight, 1130).orbit;
  expect([half.yaw, half.pitch, half.orthographic]).toEqual([-0.5, 0.1, false]);
  expect(flown(flight, 1260)).toEqual({ orbit: to, arrived: true });
  expect(flown(flight, 9000).orbit).toBe(to);
});

it("takes the shorter way around, whatever turns were made before", () => {
  for (const turns of [-2, -1, 0, 1, 3]) {
    const flight = { from: at(3 + turns * 2 * Math.PI), to: at(-3), begun: 0 };
    // From 3 rad on to -3 rad it is 2π - 6 forwards.
    for (const now of [0, 60, 130, 200, 259]) {
      const gone = flown(flight, now).orbit.yaw - flight.from.yaw;
      expect(gone).toBeGreaterThanOrEqual(0);
      expect(gone).toBeLessThanOrEqual(2 * Math.PI - 6);
    }
  }
});

it("looks from a corner along its diagonal, and from an edge halfway between its faces", () => {
  const corner = lookingFrom(FIRST, [1, -1, 1]);
  expect(corner.yaw).toBeCloseTo(-Math.PI / 4, 12);
  expect(Math.sin(corner.pitch)).toBeCloseTo(1 / Math.sqrt(3), 12);
  const edge = lookingFrom(FIRST, [0, -1, 1]);
  expect([edge.yaw, edge.pitch]).toEqual([-Math.PI / 2, expect.closeTo(Math.PI / 4, 12)]);
});
