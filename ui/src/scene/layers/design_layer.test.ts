import type { InterleavedBufferAttribute, Mesh, Object3D } from "three";
import { expect, it } from "vitest";
import { shared } from "../drawing/shading";
import { THEMES } from "../drawing/theme";
import type { Vec3 } from "../interface";
import { designOf, given } from "../testing";
import { DesignLayer, NO_MARKS } from "./design_layer";
import { DrawnDesign } from "./drawn_design";

/** Rows of numbers of tubes (first) and balls (second). */
const buffers = (layer: DesignLayer) =>
  layer.group.children
    .map((child: Object3D) => (child as Mesh).geometry.getAttribute("colour") as InterleavedBufferAttribute)
    .map((attribute) => attribute.data);

/** A chain of 1,001 vertices and 1,000 edges, as if it had been drawn once. */
function chain() {
  const places = Array.from({ length: 1001 }, (_, i): Vec3 => [i, 0, 0]);
  const design = new DrawnDesign();
  const layer = new DesignLayer(shared(), THEMES.dark);
  const first = designOf(
    places,
    places.slice(1).map((_, i) => [i, i + 1] as const),
  );
  layer.sync(design, design.update(first));
  for (const buffer of buffers(layer)) buffer.onUploadCallback();
  return { design, layer, first };
}

it("sends two edges and a ball to the graphics card when one vertex of 1,000 edges has moved", () => {
  const { design, layer, first } = chain();
  const vertices = new Map(first.vertices).set(500, { id: 500, at: [500, 9, 9], support: false });
  layer.sync(design, design.update({ ...first, vertices }));
  const rows = buffers(layer).map((buffer) =>
    buffer.updateRanges.reduce((sum, range) => sum + range.count / buffer.stride, 0),
  );
  expect(rows).toEqual([2, 1]);
});

it("moves both lines of a doubled edge", () => {
  const { design, layer, first } = chain();
  layer.mark(design, { ...NO_MARKS, doubled: new Set([499, 10]) }, new Set());
  for (const buffer of buffers(layer)) {
    buffer.clearUpdateRanges();
    buffer.onUploadCallback();
  }
  const vertices = new Map(first.vertices).set(500, { id: 500, at: [500, 9, 9], support: false });
  layer.sync(design, design.update({ ...first, vertices }));
  const tubes = given(buffers(layer)[0]);
  const moved = tubes.updateRanges.map((range) => range.start / tubes.stride).toSorted((a, b) => a - b);
  // The edges 499 and 500, and the second line of 499: after 1,000 first lines and the one of edge 10.
  expect(moved).toEqual([499, 500, 1001]);
  expect([...tubes.array.slice(1001 * tubes.stride + 3, 1001 * tubes.stride + 6)]).toEqual([500, 9, 9]);
});

it("makes what cannot be made thicker and larger, not only red", () => {
  const { design, layer } = chain();
  const [thin, small] = buffers(layer).map((buffer) => buffer.array.slice());
  layer.mark(
    design,
    {
      ...NO_MARKS,
      checked: true,
      vertices: new Map([[3, "error"]]),
      edges: new Map([[3, "error"]]),
      odd: new Set([3]),
    },
    new Set(),
  );
  const [tubes, balls] = buffers(layer).map(given);
  const width = (array: ArrayLike<number> | undefined) => given(array?.[3 * given(tubes).stride + 9]);
  const size = (array: ArrayLike<number> | undefined) => given(array?.[3 * given(balls).stride + 6]);
  expect(width(tubes?.array)).toBeGreaterThan(1.5 * width(thin));
  expect(size(balls?.array)).toBeGreaterThan(1.3 * size(small));
});
