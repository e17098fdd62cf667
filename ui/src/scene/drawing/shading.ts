/** What all materials of the scene share: sizes on the screen, light, and fading into the backdrop with depth. */

import { Vector2, Vector3 } from "three";
import type { Theme } from "./theme";

/** One object for all materials: written once a frame, not once an object. Colours are as the screen takes them. */
export interface Shared {
  /** mm that a CSS pixel covers: `x * depth + y`. Perspective has y = 0, orthographic x = 0. */
  readonly pixel: { readonly value: Vector2 };
  /** Of the viewport, CSS pixels. */
  readonly size: { readonly value: Vector2 };
  /** Device pixels in a CSS pixel. */
  readonly ratio: { value: number };
  /** Depth in mm at which fading begins, at which it is full, and how much that is. */
  readonly fade: { readonly value: Vector3 };
  readonly backCentre: { readonly value: Vector3 };
  readonly backEdge: { readonly value: Vector3 };
  readonly light: { readonly value: Vector3 };
}

export function shared(): Shared {
  return {
    pixel: { value: new Vector2(0.001, 0) },
    size: { value: new Vector2(1, 1) },
    ratio: { value: 1 },
    fade: { value: new Vector3(0, 1, 0) },
    backCentre: { value: new Vector3() },
    backEdge: { value: new Vector3() },
    light: { value: new Vector3() },
  };
}

export function paint(uniforms: Shared, theme: Theme): void {
  uniforms.backCentre.value.set(...theme.backCentre);
  uniforms.backEdge.value.set(...theme.backEdge);
  uniforms.light.value.set(...theme.light);
  uniforms.fade.value.z = theme.fade;
}

/** Begins every shader of the scene. Depth is mm in front of the eye, normals are in the frame of the eye. */
export const GLSL = /* glsl */ `
uniform vec2 pixel;
uniform vec2 size;
uniform float ratio;
uniform vec3 fade;
uniform vec3 backCentre;
uniform vec3 backEdge;
uniform vec3 light;

float pixelAt(float depth) {
  return pixel.x * max(depth, 1e-3) + pixel.y;
}

vec3 towardsEye(vec3 at) {
  return pixel.x > 0.0 ? normalize(-at) : vec3(0.0, 0.0, 1.0);
}

vec3 backdrop(vec2 fragment) {
  vec2 off = fragment / (size * ratio) - vec2(0.5, 0.55);
  return mix(backCentre, backEdge, smoothstep(0.0, 0.72, length(off)));
}

vec3 faded(vec3 colour, float depth, vec2 fragment) {
  float far = clamp((depth - fade.x) / max(fade.y - fade.x, 1e-3), 0.0, 1.0);
  return mix(colour, backdrop(fragment), far * fade.z);
}

vec3 lit(vec3 colour, vec3 normal) {
  float key = max(dot(normal, normalize(vec3(-0.35, 0.55, 0.76))), 0.0);
  return colour * (light.x + light.y * key + light.z * (0.5 + 0.5 * normal.y));
}
`;
