/** What tests of the scene need: a camera without a window, and small designs. */

import { Camera } from "./camera";
import { DrawnDesign } from "./drawn_design";
import type { SceneDesign, SceneVertex, Vec3 } from "./interface";
import { HALF_HEIGHT, looking, type ViewName } from "./orbit";
import type { Projection } from "./projection";

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

export function drawn(design: SceneDesign): DrawnDesign {
  const made = new DrawnDesign();
  made.update(design);
  return made;
}
