// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from "vitest";
import type { SceneListener, Vec3 } from "../interface";
import { Overlay } from "../layers/overlay";
import { Stage } from "../stage";
import { designOf, MM } from "../testing";
import { HALF_HEIGHT, looking } from "../view/orbit";
import { MeasureTool } from "./measure_tool";

const listener = { measuring: vi.fn(), hovered: vi.fn(), menu: vi.fn() };
let stage: Stage;
let tool: MeasureTool;

/** 800 by 600 pixels that look at the origin from the front; a pixel is 1 mm. */
beforeEach(() => {
  for (const heard of Object.values(listener)) heard.mockReset();
  const overlay = new Overlay(document.createElement("canvas"));
  stage = new Stage(overlay.element, MM, () => {});
  [stage.camera.width, stage.camera.height] = [800, 600];
  stage.camera.orbit = { ...looking(stage.camera.orbit, "front"), target: [0, 0, 0], distance: 300 / HALF_HEIGHT };
  stage.tool = "measure";
  tool = new MeasureTool(stage, listener as unknown as SceneListener, overlay);
  stage.setDesign(
    designOf(
      [
        [-100, 0, 0],
        [100, 0, 0],
        [0, 40, 150],
      ],
      [[0, 1]],
    ),
  );
  stage.setConstruction([
    [
      [-100, 20, -100],
      [100, 20, -100],
    ],
  ]);
  // A triangle that stands to the right.
  stage.setStencils([
    {
      id: 1,
      surface: {
        positions: new Float32Array([200, 0, 0, 300, 0, 0, 200, 0, 100]),
        triangles: new Uint32Array([0, 1, 2]),
      },
      matrix: [
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
      ],
      colour: null,
      hidden: false,
    },
  ]);
});

const at = (x: number, z: number) => ({ x: 400 + x, y: 300 - z, shift: false, ctrl: false, touch: false });
const click = (x: number, z: number) => {
  tool.press(at(x, z));
  tool.release(at(x, z));
};
const told = (): readonly { from: Vec3; to: Vec3 }[] => listener.measuring.mock.lastCall?.[0] ?? [];
const point = (x: number, y: number, z: number) => ({ from: [x, y, z], to: [x, y, z] });

it("takes whatever is there: a vertex, an edge or its middle, a construction line or its points, the stencil", () => {
  const things: readonly [number, number, object][] = [
    [1, 151, point(0, 40, 150)],
    [60, 1, { from: [-100, 0, 0], to: [100, 0, 0] }],
    [2, 1, point(0, 0, 0)],
    [60, -101, { from: [-100, 20, -100], to: [100, 20, -100] }],
    [-99, -99, point(-100, 20, -100)],
    [201, 99, point(200, 0, 100)],
    [260, 1, { from: [200, 0, 0], to: [300, 0, 0] }],
  ];
  for (const [x, z, thing] of things) {
    click(x, z);
    expect(told()).toEqual([thing]);
    tool.cancel();
  }
  // Where a triangle is neither at a corner nor at an edge, the very place.
  click(230, 30);
  const place = [230, 0, 30].map((mm) => expect.closeTo(mm, 6));
  expect(told()).toEqual([{ from: place, to: place }]);
});

it("measures to what the pointer is on before the second click, keeps that, and begins anew with the third", () => {
  click(1, 151);
  tool.hover(at(60, 0));
  expect(told()).toEqual([point(0, 40, 150), { from: [-100, 0, 0], to: [100, 0, 0] }]);
  tool.hover(at(-300, 200));
  expect(told()).toEqual([point(0, 40, 150)]);
  click(-100, 0);
  tool.hover(at(60, -100));
  expect(told()).toEqual([point(0, 40, 150), point(-100, 0, 0)]);
  click(100, 0);
  expect(told()).toEqual([point(100, 0, 0)]);
});

it("forgets by Esc, with another design and with another tool, and lets Esc pass once nothing is measured", () => {
  const esc = () => tool.key(new KeyboardEvent("keydown", { key: "Escape" }));
  click(1, 151);
  expect([esc(), told(), esc()]).toEqual([true, [], false]);
  for (const end of [() => tool.designChanged(), () => tool.leave()]) {
    click(1, 151);
    expect(told()).toHaveLength(1);
    end();
    expect(told()).toEqual([]);
  }
  // A click on nothing takes nothing.
  click(-300, 200);
  expect(told()).toEqual([]);
});

it("measures the stencil itself, also where tracing is off it", () => {
  stage.stencils.offset = 1.5;
  click(201, 99);
  expect(told()).toEqual([point(200, 0, 100)]);
});

it("measures a straight side of the stencil as a whole, where triangles cut it into pieces and the stencil is turned", () => {
  // A plate, as a fan from a place inside of it: its lower border is in four pieces, the left one in two.
  const border = [0, 0, 30.3, 0, 33.3, 0, 70.1, 0, 100, 0, 100, 50, 0, 50, 0, 21];
  const corners = Array.from({ length: border.length / 2 }, (_, i) => [border[2 * i], border[2 * i + 1], 0]);
  const [c, s] = [Math.cos(0.3), Math.sin(0.3)];
  stage.setStencils([
    {
      id: 2,
      surface: {
        positions: new Float32Array([[40, 20, 0], ...corners].flat() as number[]),
        triangles: new Uint32Array(corners.flatMap((_, i) => [0, i + 1, ((i + 1) % corners.length) + 1])),
      },
      // Stands upright, and is turned by 0.3 rad in the plane that is seen.
      matrix: [
        [c, -s, 0, 150],
        [0, 0, 1, 0],
        [s, c, 0, 20],
      ],
      colour: null,
      hidden: false,
    },
  ]);
  const placed = ([x, y]: readonly [number, number]): [number, number] => [150 + c * x - s * y, 20 + s * x + c * y];
  const side = (a: readonly [number, number], b: readonly [number, number]) => {
    const end = ([x, z]: [number, number]) => [x, 0, z].map((mm) => expect.closeTo(mm, 4));
    return { from: end(placed(a)), to: end(placed(b)) };
  };
  for (const [on, a, b] of [
    [
      [10, 1],
      [0, 0],
      [100, 0],
    ],
    [
      [32, 1],
      [0, 0],
      [100, 0],
    ],
    [
      [50, 1],
      [0, 0],
      [100, 0],
    ],
    [
      [50, 49],
      [100, 50],
      [0, 50],
    ],
    [
      [1, 35],
      [0, 50],
      [0, 0],
    ],
  ] as const) {
    // Away from corners, which come first.
    stage.snap = { ...stage.snap, reach: 1.4 };
    click(...placed(on));
    expect(told()).toEqual([side(a, b)]);
    tool.cancel();
  }
});
