import { expect, it, vi } from "vitest";

vi.mock("../../platform", () => ({ platform: { ask: vi.fn() }, Refused: class Refused extends Error {} }));

import { smallFrame } from "../../state/frame/testing";
import { sequenceDrawn } from "../../state/sequence/testing";
import { layerColour } from "../frame/ramp";
import { drawnSequence, layersOf } from "./struts";

it("draws a step as far as it is built, with the head at its tip and what is to come faintly", () => {
  const { lines, head } = drawnSequence(sequenceDrawn(), 0.5, smallFrame(), null);
  expect(lines.map(({ at }) => at)).toEqual([
    [
      [0, 0, 0],
      [0, 0, 50],
    ],
    [
      [0, 0, 50],
      [0, 0, 100],
    ],
    [
      [100, 0, 0],
      [0, 0, 100],
    ],
  ]);
  expect(lines.map(({ dim }) => (dim ?? 0) > 0)).toEqual([false, true, true]);
  expect(head).toMatchObject({
    tip: [0, 0, 50],
    axis: [0, 0, 1],
    free: [
      [0, 0, 1],
      [1, 0, 0],
    ],
  });
});

it("has the head at the end of the last strut when all is built", () => {
  const { lines, head } = drawnSequence(sequenceDrawn(), 2, smallFrame(), null);
  expect(lines).toHaveLength(2);
  expect(head?.tip).toEqual([0, 0, 100]);
});

it("colours what is built by its layer", () => {
  const drawn = sequenceDrawn();
  const { lines } = drawnSequence(drawn, 1.5, smallFrame(), layersOf(drawn));
  expect(lines[0]?.colours).toEqual([layerColour(0)]);
});
