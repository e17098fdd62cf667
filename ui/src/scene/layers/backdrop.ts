/** What is behind everything: a calm gradient, lighter in the middle. */

import { Mesh, PlaneGeometry, ShaderMaterial } from "three";
import { GLSL, type Shared } from "../drawing/shading";

const VERTEX = /* glsl */ `
void main() {
  gl_Position = vec4(position.xy * 2.0, 0.0, 1.0);
}`;

// A little noise, since a gradient this weak shows its steps on a screen of 8 bits.
const FRAGMENT = /* glsl */ `
${GLSL}
void main() {
  float noise = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453) - 0.5;
  gl_FragColor = vec4(backdrop(gl_FragCoord.xy) + noise / 255.0, 1.0);
}`;

export class Backdrop {
  readonly mesh: Mesh<PlaneGeometry, ShaderMaterial>;

  constructor(uniforms: Shared) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ...uniforms },
      depthTest: false,
      depthWrite: false,
    });
    this.mesh = new Mesh(new PlaneGeometry(1, 1), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -10;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
