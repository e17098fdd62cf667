/** The grid on the ground, on the plane of an axis view, or on the plane that is drawn on; with weak lines for the axes. One draw call. */

import { DoubleSide, Mesh, PlaneGeometry, ShaderMaterial, Vector2, Vector3 } from "three";
import { GLSL, type Shared } from "../drawing/shading";
import type { Theme } from "../drawing/theme";
import type { DrawingPlane, Vec3 } from "../interface";
import { cross, dot, subtract } from "../vec";
import type { Spacing } from "./grid_spacing";

const VERTEX = /* glsl */ `
uniform vec3 origin;
uniform vec3 u;
uniform vec3 v;
uniform vec2 centre;
uniform float reach;
varying vec2 vPlace;
${GLSL}
void main() {
  vPlace = centre + position.xy * 2.0 * reach;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(origin + u * vPlace.x + v * vPlace.y, 1.0);
}`;

const FRAGMENT = /* glsl */ `
uniform vec2 centre;
uniform float reach;
uniform float spacing;
uniform float fine;
uniform float strength;
uniform vec3 colour;
uniform vec3 uColour;
uniform vec3 vColour;
varying vec2 vPlace;
${GLSL}
float line(vec2 cell, float width) {
  vec2 change = fwidth(cell);
  vec2 off = abs(fract(cell - 0.5) - 0.5) / max(change, 1e-6);
  vec2 seen = (1.0 - smoothstep(width - 0.5, width + 0.5, off / ratio)) * (1.0 - smoothstep(0.15, 0.5, change * ratio));
  return max(seen.x, seen.y);
}
void main() {
  float far = distance(vPlace, centre) / reach;
  float fadeOut = 1.0 - smoothstep(0.25, 1.0, far);
  float minor = line(vPlace / spacing, 0.5) * fine * 0.45;
  float major = line(vPlace / (spacing * 10.0), 0.5) * mix(0.45, 1.0, fine);
  float grid = max(minor, major) * strength;
  vec2 axis = 1.0 - smoothstep(0.1, 1.1, abs(vPlace) / max(fwidth(vPlace), 1e-6) / ratio);
  vec3 mixed = mix(colour, mix(uColour, vColour, step(axis.y, axis.x)), max(axis.x, axis.y));
  float alpha = max(grid, max(axis.x, axis.y) * 0.38) * fadeOut;
  if (alpha < 0.004) discard;
  gl_FragColor = vec4(mixed, alpha);
}`;

export class Grid {
  readonly mesh: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly own = {
    origin: { value: new Vector3() },
    u: { value: new Vector3() },
    v: { value: new Vector3() },
    centre: { value: new Vector2() },
    reach: { value: 1 },
    spacing: { value: 10 },
    fine: { value: 1 },
    strength: { value: 0.3 },
    colour: { value: new Vector3() },
    uColour: { value: new Vector3() },
    vColour: { value: new Vector3() },
  };

  constructor(uniforms: Shared) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ...uniforms, ...this.own },
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
    this.mesh = new Mesh(new PlaneGeometry(1, 1), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -5;
  }

  /** `strong` for a plane that is drawn on. Axes are coloured after the world's axis that they are nearest to. */
  show(plane: DrawingPlane, around: Vec3, reach: number, spacing: Spacing, theme: Theme, strong: boolean): void {
    const { own } = this;
    own.origin.value.set(...plane.origin);
    own.u.value.set(...plane.u);
    own.v.value.set(...plane.v);
    const off = subtract(around, plane.origin);
    own.centre.value.set(dot(off, plane.u), dot(off, plane.v));
    own.reach.value = reach;
    own.spacing.value = spacing.mm;
    own.fine.value = spacing.fine;
    own.strength.value = strong ? 0.42 : 0.2;
    own.colour.value.set(...theme.grid);
    own.uColour.value.set(...theme.axes[mostlyAlong(plane.u)]);
    own.vColour.value.set(...theme.axes[mostlyAlong(plane.v)]);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

function mostlyAlong(way: Vec3): 0 | 1 | 2 {
  const [x, y, z] = way.map(Math.abs) as unknown as [number, number, number];
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

export const GROUND: DrawingPlane = { origin: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0] };

/** The plane through the origin that an axis view looks at; the ground for any other. `back` points to the eye. */
export function facing(back: Vec3, orthographic: boolean): DrawingPlane {
  if (orthographic && Math.abs(back[0]) > 0.999) return { origin: [0, 0, 0], u: [0, 1, 0], v: [0, 0, 1] };
  if (orthographic && Math.abs(back[1]) > 0.999) return { origin: [0, 0, 0], u: [1, 0, 0], v: [0, 0, 1] };
  return GROUND;
}

export const normalOf = (plane: DrawingPlane): Vec3 => cross(plane.u, plane.v);
