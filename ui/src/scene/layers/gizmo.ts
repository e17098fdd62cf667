/** Arrows, squares and arcs at the selection, always as large on the screen, to drag along an axis, in a plane or around one. One draw call. */

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
  TorusGeometry,
  Vector3,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { GLSL, type Shared } from "../drawing/shading";
import type { Theme } from "../drawing/theme";
import type { Axis, Vec3 } from "../interface";
import { ARC, ARROW, acrossOf, EDGE_ON, HANDLES, type Handle, SQUARE } from "../tools/gizmo_parts";
import { AXES, add, scale } from "../vec";

const VERTEX = /* glsl */ `
attribute float part;
uniform vec3 centre;
uniform float chosen;
uniform float turns;
uniform vec3 axisColours[3];
uniform vec3 lift;
varying vec3 vColour;
varying vec3 vNormal;
varying float vFlat;
${GLSL}
void main() {
  float px = pixelAt(-(viewMatrix * vec4(centre, 1.0)).z);
  int axis = int(mod(part + 0.5, 3.0));
  vFlat = step(2.5, part) * step(part, 5.5);
  vColour = axisColours[axis];
  if (abs(part - chosen) < 0.5) vColour = lift;
  vNormal = mat3(viewMatrix) * normal;
  gl_Position = projectionMatrix * viewMatrix * vec4(centre + position * px, 1.0);
  if (part > 5.5) {
    vec3 about = vec3(axis == 0, axis == 1, axis == 2);
    // Beside what is seen: those seen edge on, too, which would lie on arrows.
    if (turns < 0.5 || abs((viewMatrix * vec4(about, 0.0)).z) < ${EDGE_ON}) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  }
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
    turns: { value: 0 },
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
    const parts = HANDLES.map((handle, number) => numbered(partOf(handle), number));
    this.mesh = new Mesh(mergeGeometries(parts), material);
    for (const part of parts) part.dispose();
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  /** mm; null hides it. `turns`: whether it has arcs. */
  show(centre: Vec3 | null, active: Handle | null, turns: boolean): void {
    this.own.turns.value = turns ? 1 : 0;
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

function partOf(handle: Handle): BufferGeometry {
  if (handle.kind === "axis") return arrow(AXES[handle.axis]);
  return handle.kind === "plane" ? square(handle.normal) : arc(handle.axis);
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

function arc(axis: Axis): BufferGeometry {
  const rad = Math.PI / 180;
  const [u, v] = acrossOf(axis).map((name) => AXES[name]) as [Vec3, Vec3];
  const place = new Matrix4().makeBasis(new Vector3(...u), new Vector3(...v), new Vector3(...AXES[axis]));
  return new TorusGeometry(ARC.radius, 1.6, 8, 32, (ARC.to_deg - ARC.from_deg) * rad)
    .rotateZ(ARC.from_deg * rad)
    .applyMatrix4(place);
}

function numbered(geometry: BufferGeometry, number: number): BufferGeometry {
  const count = geometry.getAttribute("position").count;
  return geometry.setAttribute("part", new BufferAttribute(new Float32Array(count).fill(number), 1));
}
