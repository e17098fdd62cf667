import { PerspectiveCamera } from "three";
import { expect, it } from "vitest";
import { shared } from "../drawing/shading";
import type { Vec3 } from "../interface";
import { Projection } from "../view/projection";
import { Stencils } from "./stencils";

/** A sheet along the y axis at x = 1, which an eye at (0, -100, 0) sees from the left, nearly edge-on. Wound so that its normal is -x. */
const SHEET = {
  positions: new Float32Array([1, 0, -10, 1, 50, -10, 1, 0, 10, 1, 50, 10]),
  triangles: new Uint32Array([0, 2, 1, 1, 2, 3]),
};

function seenFrom(): Projection {
  const camera = new PerspectiveCamera(40, 800 / 600, 1, 1000);
  camera.up.set(0, 0, 1);
  camera.position.set(0, -100, 0);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  return new Projection(camera.matrixWorldInverse, camera.projectionMatrix, 800, 600);
}

it("lifts a vertex beside the silhouette to the side that is seen, also where the ray of the pointer would see the other", () => {
  const stencils = new Stencils(shared());
  const row = (i: number) => [0, 1, 2, 3].map((k) => (k === i ? 1 : 0)) as [number, number, number, number];
  const matrix = [row(0), row(1), row(2)] as const;
  stencils.show([{ id: 1, surface: SHEET, matrix, colour: null, hidden: false }]);
  stencils.offset = 1.5;
  const projection = seenFrom();
  const far: Vec3 = [1, 50, 10];
  const { x, y } = projection.seen(far);
  // Left of the middle, where rays go to the left, and the sheet is to the right of it.
  const pointer = { x: 398, y };
  expect(projection.ray(pointer.x, pointer.y).direction[0]).toBeLessThan(0);
  expect(x).toBeGreaterThan(400);
  const { surface } = stencils.near(projection, pointer.x, 300, 14);
  expect(surface?.[0]).toBeCloseTo(1 - 1.5, 5);
});
