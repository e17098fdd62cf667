import { beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
const pickFile = vi.hoisted(() => vi.fn());
vi.mock("../../platform", () => ({ platform: { ask, pickFile }, Refused: class Refused extends Error {} }));

import { useDesign } from "../design/design";
import { designState } from "../testing";
import { forgetFrame, frameRequest, keepSupports, useFrame } from "./frame";
import { chooseLoadCase, drawnForces, dropLoads, pickLoads, putForce } from "./loads";
import { smallFrame } from "./testing";

const CASES = {
  name: "loads.json",
  cases: [
    { name: "dead", forces: [{ vertex: 2, force_n: [0, 0, -2] }], moments: 0, along_edges: 0, gravity: [0, 0, -1] },
    { name: "wind", forces: [], moments: 0, along_edges: 2, gravity: null },
  ],
};

beforeEach(() => {
  ask.mockReset();
  pickFile.mockReset();
  forgetFrame();
  useDesign.setState({ ...smallFrame(), state: designState(), version: 1 });
});

const request = () => frameRequest(useFrame.getState());

it("puts forces on vertices, takes them away, and lets them go with their vertices", () => {
  putForce([1, 2], [0, 0, -5]);
  putForce([2], [3, 0, 0]);
  expect(request().forces).toEqual([
    { vertex: 1, force_n: [0, 0, -5] },
    { vertex: 2, force_n: [3, 0, 0] },
  ]);
  expect(drawnForces(useFrame.getState())).toEqual([
    [
      [100, 0, 0],
      [0, 0, -5],
    ],
    [
      [0, 0, 100],
      [3, 0, 0],
    ],
  ]);
  putForce([1], [0, 0, 0]);
  expect([...useFrame.getState().forces.keys()]).toEqual([2]);
  useDesign.setState({ vertices: new Map() });
  keepSupports();
  expect(useFrame.getState().forces.size).toBe(0);
});

it("takes loads of a file with the gravity that they say, and gives gravity back without them", async () => {
  pickFile.mockResolvedValue("/there/loads.json");
  ask.mockResolvedValue(CASES);
  await pickLoads();
  expect(request()).toMatchObject({ gravity: null, loads: { file: { file: "/there/loads.json" }, case: "dead" } });
  expect(drawnForces(useFrame.getState())).toHaveLength(1);
  chooseLoadCase("wind");
  expect(request().loads?.case).toBe("wind");
  expect(drawnForces(useFrame.getState())).toEqual([]);
  dropLoads();
  expect(request()).toMatchObject({ gravity: [0, 0, -1], loads: null });
});

it("keeps what acted before where a file is wrong, and forgets all with the design", async () => {
  pickFile.mockResolvedValue("/there/loads.json");
  ask.mockResolvedValueOnce(CASES);
  await pickLoads();
  ask.mockRejectedValueOnce(new Error("wrong.json is no file of load cases"));
  await pickLoads();
  expect(useFrame.getState().loadFile?.path).toBe("/there/loads.json");
  putForce([1], [0, 0, -5]);
  forgetFrame();
  expect(request()).toMatchObject({ gravity: [0, 0, -1], loads: null, forces: [] });
});
