/** What tests of the scene need: a camera without a window, and small designs. */

import type { LengthFormat, SceneDesign, SceneVertex, Vec3 } from "./interface";
import { DrawnDesign } from "./layers/drawn_design";
import { Camera } from "./view/camera";
import { HALF_HEIGHT, looking, type ViewName } from "./view/orbit";
import type { Projection } from "./view/projection";

/** 800 by 600 CSS pixels that look at the origin. In axis views a pixel is 1 mm, so z = 100 in front view is 100 pixels above the middle. */
export function projectionOf(view: ViewName): Projection {
  const camera = new Camera();
  [camera.width, camera.height] = [800, 600];
  camera.orbit = { ...looking(camera.orbit, view), target: [0, 0, 0], distance: 300 / HALF_HEIGHT };
  return camera.update();
}

/** Vertices by place with ids from 0, edges by the ids of their ends with ids from 0. */
export function designOf(places: readonly Vec3[], ends: readonly (readonly [number, number])[]): SceneDesign {
  return {
    vertices: new Map(places.map((at, id): [number, SceneVertex] => [id, { id, at, support: false }])),
    edges: new Map(ends.map(([a, b], id) => [id, { id, a, b }])),
  };
}

/** Lengths as the editor would have them written, without what sets thousands apart. */
const written = (mm: number, name: string, digits: number): LengthFormat => ({
  mm,
  name,
  number: (length) => (length / mm).toFixed(digits).replace("-", "\u2212"),
  short: (length) => String(length / mm),
  angle: (deg) => `${deg.toFixed(1)}°`,
});
export const MM = written(1, "mm", 1);
export const INCH = written(25.4, "in", 3);

/** What a test knows to be there; it fails here where it is not. */
export function given<T>(value: T | null | undefined): T {
  if (value === null || value === undefined) throw new Error("what the test looks at is not there");
  return value;
}

export function drawn(design: SceneDesign): DrawnDesign {
  const made = new DrawnDesign();
  made.update(design);
  return made;
}
