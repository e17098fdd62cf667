/** Arrows and squares at the selection, always as large on the screen, to drag along an axis or in a plane. One draw call. */

import {
  BufferAttribute,
  type BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  DoubleSide,
  Matrix4,
  Mesh,
  PlaneGeometry,
  Quaternion,
  ShaderMaterial,
  Vector3,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { GLSL, type Shared } from "../drawing/shading";
import type { Theme } from "../drawing/theme";
import type { Vec3 } from "../interface";
import { ARROW, acrossOf, HANDLES, type Handle, SQUARE } from "../tools/gizmo_parts";
import { AXES, add, scale } from "../vec";

const VERTEX = /* glsl */ `
attribute float part;
uniform vec3 centre;
uniform float chosen;
uniform vec3 axisColours[3];
uniform vec3 lift;
varying vec3 vColour;
varying vec3 vNormal;
varying float vFlat;
${GLSL}
void main() {
  float px = pixelAt(-(viewMatrix * vec4(centre, 1.0)).z);
  int axis = int(mod(part + 0.5, 3.0));
  vFlat = step(2.5, part);
  vColour = axisColours[axis];
  if (abs(part - chosen) < 0.5) vColour = lift;
  vNormal = mat3(viewMatrix) * normal;
  gl_Position = projectionMatrix * viewMatrix * vec4(centre + position * px, 1.0);
}`;

const FRAGMENT = /* glsl */ `
varying vec3 vColour;
varying vec3 vNormal;
varying float vFlat;
${GLSL}
void main() {
  vec3 shaded = vFlat > 0.5 ? vColour : vColour * (0.78 + 0.22 * max(normalize(vNormal).z, 0.0));
  gl_FragColor = vec4(shaded, mix(1.0, 0.7, vFlat));
}`;

export class Gizmo {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly own = {
    centre: { value: new Vector3() },
    chosen: { value: -1 },
    axisColours: { value: [new Vector3(), new Vector3(), new Vector3()] },
    lift: { value: new Vector3() },
  };

  constructor(uniforms: Shared) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ...uniforms, ...this.own },
      transparent: true,
      side: DoubleSide,
    });
    const parts = HANDLES.map((handle, number) =>
      numbered(handle.kind === "axis" ? arrow(AXES[handle.axis]) : square(handle.normal), number),
    );
    this.mesh = new Mesh(mergeGeometries(parts), material);
    for (const part of parts) part.dispose();
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  /** mm; null hides it. */
  show(centre: Vec3 | null, active: Handle | null): void {
    this.mesh.visible = centre !== null;
    if (centre) this.own.centre.value.set(...centre);
    this.own.chosen.value = active
      ? HANDLES.findIndex((handle) => JSON.stringify(handle) === JSON.stringify(active))
      : -1;
  }

  paint(theme: Theme): void {
    this.own.axisColours.value.forEach((colour, axis) => colour.set(...(theme.axes[axis] ?? theme.edge)));
    this.own.lift.value.set(...theme.selected);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

function arrow(axis: Vec3): BufferGeometry {
  const head = 13;
  const size = ARROW.to - ARROW.from - head;
  const shaft = new CylinderGeometry(1.1, 1.1, size, 8).translate(0, ARROW.from + size / 2, 0);
  const tip = new ConeGeometry(4.6, head, 16).translate(0, ARROW.to - head / 2, 0);
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...axis));
  const made = mergeGeometries([shaft, tip]).applyMatrix4(new Matrix4().makeRotationFromQuaternion(turn));
  shaft.dispose();
  tip.dispose();
  return made;
}

function square(normal: "x" | "y" | "z"): BufferGeometry {
  const [u, v] = acrossOf(normal).map((axis) => AXES[axis]) as [Vec3, Vec3];
  const size = SQUARE.to - SQUARE.from;
  const centre = scale(add(u, v), (SQUARE.from + SQUARE.to) / 2);
  const place = new Matrix4()
    .makeBasis(new Vector3(...u), new Vector3(...v), new Vector3(...AXES[normal]))
    .setPosition(...centre);
  return new PlaneGeometry(size, size).applyMatrix4(place);
}

function numbered(geometry: BufferGeometry, number: number): BufferGeometry {
  const count = geometry.getAttribute("position").count;
  return geometry.setAttribute("part", new BufferAttribute(new Float32Array(count).fill(number), 1));
}
