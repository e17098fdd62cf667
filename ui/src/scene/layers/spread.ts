/** Balls around vertices, within which they come out. */

import type { Shared } from "../drawing/shading";
import { Spheres } from "../drawing/spheres";
import type { SceneBall } from "../interface";

export class SpreadLayer {
  private readonly spheres: Spheres;

  constructor(uniforms: Shared) {
    // At true scale, however small they are on the screen.
    this.spheres = new Spheres(uniforms, 1, 0, 1e6, true);
    this.spheres.mesh.renderOrder = 1;
  }

  get mesh() {
    return this.spheres.mesh;
  }

  show(balls: readonly SceneBall[]): void {
    this.spheres.count = balls.length;
    balls.forEach(({ at, radius, colour }, row) => this.spheres.set(row, at, { colour, size: radius, cube: false }));
  }

  /** Only so many of them are seen, the first ones. */
  keep(count: number): void {
    this.spheres.count = count;
  }

  dispose(): void {
    this.spheres.dispose();
  }
}
