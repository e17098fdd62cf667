/** Flat signs of constant size that face the eye, on top of everything, in one draw call: rings, markers of snapping, the arrow of the start. */

import { Mesh, PlaneGeometry, ShaderMaterial, Vector3 } from "three";
import type { SnapKind, Vec3 } from "../interface";
import { Instances } from "./instances";
import { GLSL, type Shared } from "./shading";
import type { Rgb } from "./theme";

/** The number is what the shader knows it by. */
const SHAPES = { ring: 0, square: 1, diamond: 2, triangle: 3, target: 4, plus: 5, cross: 6, arrow: 7, dot: 8 } as const;

export type Shape = keyof typeof SHAPES;

/** A shape of its own for each, so that colour is not needed to tell them apart. */
export const SNAP_SHAPES: Readonly<Record<SnapKind, Shape>> = {
  vertex: "square",
  "stencil-vertex": "triangle",
  "stencil-edge": "cross",
  construction: "cross",
  "edge-middle": "diamond",
  edge: "diamond",
  surface: "target",
  angle: "dot",
  grid: "plus",
  plane: "dot",
};

const VERTEX = /* glsl */ `
attribute vec3 at;
attribute vec3 colour;
attribute vec3 look;
attribute vec3 towards;
varying vec2 vPlace;
varying vec3 vColour;
varying vec2 vLook;
${GLSL}
void main() {
  vec4 centre = projectionMatrix * modelViewMatrix * vec4(at, 1.0);
  vec2 turn = vec2(1.0, 0.0);
  vec2 shift = vec2(0.0);
  if (dot(towards, towards) > 0.0) {
    vec4 ahead = projectionMatrix * modelViewMatrix * vec4(at + towards, 1.0);
    vec2 way = (ahead.xy / ahead.w - centre.xy / centre.w) * size;
    if (dot(way, way) > 1e-8) turn = normalize(way);
    shift = turn * look.z;
  }
  vec2 place = position.xy * 2.0 * (look.y + 4.0);
  vec2 turned = vec2(place.x * turn.x - place.y * turn.y, place.x * turn.y + place.y * turn.x) + shift;
  vPlace = place;
  vColour = colour;
  vLook = look.xy;
  gl_Position = centre + vec4(turned * 2.0 / size * centre.w, 0.0, 0.0);
}`;

const FRAGMENT = /* glsl */ `
uniform vec3 halo;
varying vec2 vPlace;
varying vec3 vColour;
varying vec2 vLook;
${GLSL}
float polygon(vec2 p, float r, float corners, float turn) {
  float part = 6.2831853 / corners;
  float angle = atan(p.y, p.x) + turn;
  return cos(floor(0.5 + angle / part) * part - angle) * length(p) - r;
}
// Long and notched: a triangle with equal sides does not show which corner points the way.
float arrow(vec2 p, float r) {
  vec2 upper = vec2(p.x, abs(p.y));
  float side = dot(upper - vec2(r, 0.0), vec2(0.3162, 0.9487));
  float notch = dot(upper + vec2(r * 0.35, 0.0), vec2(-0.8, -0.6));
  return max(side, notch);
}
float bar(vec2 p, float r) {
  return min(max(abs(p.x) - r, abs(p.y)), max(abs(p.y) - r, abs(p.x)));
}
float distanceTo(vec2 p, float shape, float r) {
  float width = 1.1;
  if (shape < 0.5) return abs(length(p) - r) - width;
  if (shape < 1.5) return abs(max(abs(p.x), abs(p.y)) - r * 0.86) - width;
  if (shape < 2.5) return abs((abs(p.x) + abs(p.y)) * 0.7071 - r * 0.8) - width;
  if (shape < 3.5) return abs(polygon(p, r * 0.6, 3.0, -1.5707963)) - width;
  if (shape < 4.5) return min(abs(length(p) - r) - width, length(p) - 2.0);
  if (shape < 5.5) return bar(p, r) - width;
  if (shape < 6.5) return bar(vec2(p.x + p.y, p.x - p.y) * 0.7071, r) - width;
  if (shape < 7.5) return arrow(p, r);
  return length(p) - r * 0.5;
}
void main() {
  float d = distanceTo(vPlace, vLook.x, vLook.y);
  float fill = 1.0 - smoothstep(-0.5, 0.5, d * ratio);
  float rim = (1.0 - smoothstep(0.4, 1.6, d)) * 0.55;
  float alpha = max(fill, rim);
  if (alpha < 0.01) discard;
  gl_FragColor = vec4(mix(halo, vColour, fill), alpha);
}`;

export interface Sign {
  readonly at: Vec3;
  readonly shape: Shape;
  readonly colour: Rgb;
  /** CSS pixels. */
  readonly radius: number;
  /** The way an arrow points, any length. */
  readonly towards?: Vec3;
  /** How far that way the sign stands off, CSS pixels. */
  readonly off?: number;
}

export class Symbols {
  readonly mesh: Mesh<Instances["geometry"], ShaderMaterial>;
  private readonly instances = new Instances(new PlaneGeometry(1, 1), [
    ["at", 3],
    ["colour", 3],
    ["look", 3],
    ["towards", 3],
  ]);

  constructor(uniforms: Shared) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ...uniforms, halo: { value: new Vector3() } },
      transparent: true,
      depthTest: false,
      depthWrite: false,
    });
    this.mesh = new Mesh(this.instances.geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  set halo(colour: Rgb) {
    (this.mesh.material.uniforms.halo?.value as Vector3 | undefined)?.set(...colour);
  }

  show(signs: readonly Sign[]): void {
    this.instances.resize(signs.length);
    this.mesh.visible = signs.length > 0;
    signs.forEach((sign, row) => {
      this.instances.write(
        row,
        ...sign.at,
        ...sign.colour,
        SHAPES[sign.shape],
        sign.radius,
        sign.off ?? 0,
        ...(sign.towards ?? [0, 0, 0]),
      );
    });
  }

  dispose(): void {
    this.instances.dispose();
    this.mesh.material.dispose();
  }
}
