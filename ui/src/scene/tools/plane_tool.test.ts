// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from "vitest";
import type { SceneListener, Vec3 } from "../interface";
import { Overlay } from "../layers/overlay";
import { Stage } from "../stage";
import { designOf, MM } from "../testing";
import { looking } from "../view/orbit";
import { PlaneTool } from "./plane_tool";

const listener = { planePoints: vi.fn(), hovered: vi.fn() };
let stage: Stage;
let tool: PlaneTool;

beforeEach(() => {
  for (const heard of Object.values(listener)) heard.mockReset();
  const overlay = new Overlay(document.createElement("canvas"));
  stage = new Stage(overlay.element, MM, () => {});
  [stage.camera.width, stage.camera.height] = [800, 600];
  stage.camera.orbit = looking(stage.camera.orbit, "front");
  stage.viewMoved();
  stage.tool = "plane";
  tool = new PlaneTool(stage, listener as unknown as SceneListener, overlay);
  // An edge from 0 to 60 along x, and a construction line above its far end.
  stage.setDesign(
    designOf(
      [
        [0, 0, 0],
        [60, 0, 0],
      ],
      [[0, 1]],
    ),
  );
  stage.setConstruction([
    [
      [60, 5, 40],
      [60, 5, 80],
    ],
  ]);
});

const click = (at: Vec3): void => {
  const { x, y } = stage.projection.seen(at);
  tool.release({ x, y, shift: false, ctrl: false, touch: false });
};
const told = () => listener.planePoints.mock.lastCall?.[0];

it("takes vertices, middles of edges, and ends of construction lines", () => {
  click([0, 0, 0]);
  expect(told()).toEqual([{ at: [0, 0, 0], vertex: 0 }]);
  click([30, 0, 0]);
  click([60, 5, 80]);
  expect(told()).toEqual([
    { at: [0, 0, 0], vertex: 0 },
    { at: [30, 0, 0], vertex: null },
    { at: [60, 5, 80], vertex: null },
  ]);
  // The next click begins anew.
  click([60, 0, 0]);
  expect(told()).toEqual([{ at: [60, 0, 0], vertex: 1 }]);
});

it("takes no point twice, none in line with two, and nothing beside all", () => {
  for (const at of [
    [0, 0, 0],
    [0, 0, 0],
    [60, 0, 0],
    [30, 0, 0],
    [-80, 0, -80],
  ] as const)
    click(at);
  expect(told()).toHaveLength(2);
  expect(listener.planePoints).toHaveBeenCalledTimes(2);
});

it("forgets what was taken with Escape, and where the design changes", () => {
  click([0, 0, 0]);
  expect(tool.key(new KeyboardEvent("keydown", { key: "Escape" }))).toBe(true);
  expect(told()).toEqual([]);
  expect(tool.key(new KeyboardEvent("keydown", { key: "Escape" }))).toBe(false);
  click([0, 0, 0]);
  tool.designChanged();
  expect(told()).toEqual([]);
});
