import { expect, it } from "vitest";
import type { Camera } from "./camera";
import { FIRST, framing, looking } from "./orbit";
import { Turning } from "./turning";

function turning() {
  const camera = { orbit: FIRST } as Camera;
  const names: string[] = [];
  const turned = new Turning({ camera, tool: "select", plane: null, playing: false, viewMoved: () => {} }, (name) =>
    names.push(name),
  );
  return { camera, names, turned };
}

it("looks from the side that it was turning to once something else frames the view", () => {
  const { camera, names, turned } = turning();
  turned.fly("front", false);
  turned.advance(performance.now());
  turned.land();
  expect(camera.orbit).toEqual(looking(FIRST, "front"));
  expect(names).toEqual(["Front"]);
  expect(turned.advance(performance.now())).toBe(false);
});

it("leaves the view alone where nothing turns, or a hand has turned it meanwhile", () => {
  const { camera, names, turned } = turning();
  turned.land();
  expect(camera.orbit).toBe(FIRST);
  turned.fly("front", false);
  const byHand = framing(FIRST, [[50, 0, 0]], 1);
  camera.orbit = byHand;
  turned.land();
  expect(camera.orbit).toBe(byHand);
  expect(names).toEqual([]);
});
