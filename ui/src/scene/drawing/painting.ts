import type { Camera, Scene, WebGLRenderer } from "three";

/** Draws what is in the world, and then what lies over all of it. */
export function paintPicture(renderer: WebGLRenderer, world: Scene, above: Scene, camera: Camera): void {
  renderer.info.reset();
  renderer.clear();
  renderer.render(world, camera);
  renderer.clearDepth();
  renderer.render(above, camera);
}
