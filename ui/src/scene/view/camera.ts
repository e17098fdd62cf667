/** The camera of three.js, set from an `Orbit`. */

import { Matrix4, OrthographicCamera, PerspectiveCamera, Vector3 } from "three";
import type { Shared } from "../drawing/shading";
import type { Vec3 } from "../interface";
import { dot, subtract } from "../vec";
import { axes, eye, FIELD_OF_VIEW, FIRST, HALF_HEIGHT, type Orbit } from "./orbit";
import { Projection } from "./projection";

export class Camera {
  orbit: Orbit = FIRST;
  width = 1;
  height = 1;
  /** All that there is to see, mm: what the near and far plane and the fading with depth go by. */
  ball: { centre: Vec3; radius: number } = { centre: [0, 0, 0], radius: 100 };
  private readonly perspective = new PerspectiveCamera((FIELD_OF_VIEW * 180) / Math.PI);
  private readonly orthographic = new OrthographicCamera();

  get three(): PerspectiveCamera | OrthographicCamera {
    return this.orbit.orthographic ? this.orthographic : this.perspective;
  }

  get aspect(): number {
    return this.width / Math.max(this.height, 1);
  }

  /** Before each frame, and before anything is picked after the view has changed. */
  update(): Projection {
    const { orbit, aspect } = this;
    const { right, up, back } = axes(orbit);
    const camera = this.three;
    const reach = orbit.distance + this.ball.radius;
    if (camera instanceof PerspectiveCamera) {
      camera.aspect = aspect;
      camera.near = Math.max(orbit.distance * 0.01, 0.05);
      camera.far = camera.near + 8 * reach;
    } else {
      const half = orbit.distance * HALF_HEIGHT;
      [camera.top, camera.bottom, camera.left, camera.right] = [half, -half, -half * aspect, half * aspect];
      [camera.near, camera.far] = [-8 * reach, 8 * reach];
    }
    camera.position.set(...eye(orbit));
    camera.quaternion.setFromRotationMatrix(
      new Matrix4().makeBasis(new Vector3(...right), new Vector3(...up), new Vector3(...back)),
    );
    camera.updateMatrixWorld();
    camera.updateProjectionMatrix();
    return new Projection(camera.matrixWorldInverse, camera.projectionMatrix, this.width, this.height);
  }

  /** What materials need to know of it. */
  describe(uniforms: Shared): void {
    const pixel = (2 * HALF_HEIGHT) / Math.max(this.height, 1);
    if (this.orbit.orthographic) uniforms.pixel.value.set(0, pixel * this.orbit.distance);
    else uniforms.pixel.value.set(pixel, 0);
    uniforms.size.value.set(this.width, this.height);
    const depth = dot(subtract(eye(this.orbit), this.ball.centre), axes(this.orbit).back);
    uniforms.fade.value.x = depth - this.ball.radius * 0.55;
    uniforms.fade.value.y = depth + this.ball.radius * 1.05;
  }
}
