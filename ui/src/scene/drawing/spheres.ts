/** Balls of a kind, all in one draw call, and cubes where the design holds a vertex fixed. */

import { IcosahedronGeometry, Mesh, ShaderMaterial, Vector3 } from "three";
import type { Vec3 } from "../interface";
import { Instances } from "./instances";
import { GLSL, type Shared } from "./shading";
import type { Rgb } from "./theme";

const VERTEX = /* glsl */ `
attribute vec3 at;
attribute vec3 colour;
attribute vec2 look;
uniform vec3 radius;
varying vec3 vNormal;
varying vec3 vPlace;
varying vec3 vColour;
varying float vDepth;
varying float vCube;
${GLSL}
void main() {
  vec3 centre = (modelViewMatrix * vec4(at, 1.0)).xyz;
  float px = pixelAt(-centre.z);
  vec3 reach = abs(position);
  vec3 corner = position / max(reach.x, max(reach.y, reach.z)) * 0.82;
  vec3 place = mix(position, corner, look.y);
  float thick = clamp(radius.x, radius.y * px, radius.z * px) * look.x;
  vec3 seen = centre + mat3(modelViewMatrix) * place * thick;
  vNormal = mat3(modelViewMatrix) * position;
  vPlace = seen;
  vColour = colour;
  vCube = look.y;
  vDepth = -seen.z;
  gl_Position = projectionMatrix * vec4(seen, 1.0);
}`;

const FRAGMENT = /* glsl */ `
varying vec3 vNormal;
varying vec3 vPlace;
varying vec3 vColour;
varying float vDepth;
varying float vCube;
${GLSL}
void main() {
  vec3 normal = vCube > 0.5 ? normalize(cross(dFdx(vPlace), dFdy(vPlace))) : normalize(vNormal);
  gl_FragColor = vec4(faded(lit(vColour, normal), vDepth, gl_FragCoord.xy), 1.0);
}`;

// Glass: it is seen by its outline, and what is in it through its middle.
const GLASS = /* glsl */ `
varying vec3 vNormal;
varying vec3 vPlace;
varying vec3 vColour;
varying float vDepth;
${GLSL}
void main() {
  vec3 normal = normalize(vNormal);
  float edge = 1.0 - abs(dot(normal, towardsEye(vPlace)));
  gl_FragColor = vec4(faded(lit(vColour, normal), vDepth, gl_FragCoord.xy), mix(0.16, 0.8, edge * edge));
}`;

export interface SphereLook {
  readonly colour: Rgb;
  /** Factor on the radius. */
  readonly size: number;
  readonly cube: boolean;
}

export class Spheres {
  readonly mesh: Mesh<Instances["geometry"], ShaderMaterial>;
  private readonly instances = new Instances(new IcosahedronGeometry(1, 2), [
    ["at", 3],
    ["colour", 3],
    ["look", 2],
  ]);

  /** `radius` in mm, kept between `least` and `most` CSS pixels on the screen. */
  constructor(uniforms: Shared, radius: number, least: number, most: number, glass = false) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: glass ? GLASS : FRAGMENT,
      uniforms: { ...uniforms, radius: { value: new Vector3(radius, least, most) } },
      transparent: glass,
      depthWrite: !glass,
    });
    this.mesh = new Mesh(this.instances.geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  set count(count: number) {
    this.instances.resize(count);
    this.mesh.visible = count > 0;
  }

  set(row: number, at: Vec3, look: SphereLook): void {
    this.instances.write(row, ...at, ...look.colour, look.size, look.cube ? 1 : 0);
  }

  place(row: number, at: Vec3): void {
    this.instances.patch(row, 0, ...at);
  }

  style(row: number, look: SphereLook): void {
    this.instances.patch(row, 3, ...look.colour, look.size, look.cube ? 1 : 0);
  }

  dispose(): void {
    this.instances.dispose();
    this.mesh.material.dispose();
  }
}
