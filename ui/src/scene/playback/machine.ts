/** The bodies of a machine. Frame: the origin is the bend point, +x the way the wire leaves, z the bend axis; mm. */

import {
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  CylinderGeometry,
  EdgesGeometry,
  Group,
  MathUtils,
  Matrix4,
  Mesh,
  Quaternion,
  Raycaster,
  ShaderMaterial,
  Vector3,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { GLSL, type Shared } from "../drawing/shading";
import type { Rgb, Theme } from "../drawing/theme";
import type { MachineBody, Vec3 } from "../interface";
import type { Ray } from "../vec";

const VERTEX = /* glsl */ `
attribute float marked;
varying float vMarked;
varying vec3 vNormal;
varying float vDepth;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  vNormal = normalMatrix * normal;
  vMarked = marked;
  vDepth = -seen.z;
  gl_Position = projectionMatrix * seen;
}`;

const FRAGMENT = /* glsl */ `
uniform vec3 colour;
uniform vec3 mark;
varying float vMarked;
varying vec3 vNormal;
varying float vDepth;
${GLSL}
void main() {
  gl_FragColor = vec4(faded(lit(mix(colour, mark, vMarked), normalize(vNormal)), vDepth, gl_FragCoord.xy), 1.0);
}`;

type Part = MachineBody["part"];

const PARTS: readonly Part[] = ["frame", "head", "peg"];

/** mm between the wire and a peg that is in. */
const CLEAR = 1;

export class Machine {
  readonly group = new Group();
  private readonly head = new Group();
  private readonly peg = new Group();
  /** mm along its own axis that the peg goes in by, so that the wire passes over it. */
  private stroke = 0;
  private readonly meshes: { part: Part; mesh: Mesh<BufferGeometry, ShaderMaterial> }[] = [];
  /** For each body, by its place in the profile, where its corners are in the attribute that says whether it is marked. */
  private readonly corners = new Map<number, { marks: BufferAttribute; from: number; to: number }>();
  private marked: readonly number[] = [];

  /** What is marked goes over into this colour, and how far, from 0 to 1. */
  constructor(
    private readonly uniforms: Shared,
    private readonly markColour: (theme: Theme) => Rgb = ({ error }) => error,
    private readonly markStrength = 1,
  ) {
    this.group.add(this.head);
    this.head.add(this.peg);
  }

  /** `orbit`: x of the axis that the peg turns about, `top`: how far it reaches beyond the wire's middle, `wire`: its diameter, mm. */
  show(bodies: readonly MachineBody[], orbit: number, top: number, wire: number, theme: Theme): void {
    this.clear();
    this.stroke = top + wire / 2 + CLEAR;
    this.peg.position.set(orbit, 0, 0);
    for (const part of PARTS) {
      const own = bodies.flatMap((body, index) => (body.part === part ? [{ body, index }] : []));
      const solids = own.map(({ body }) => solid(body, part === "peg" ? orbit : 0));
      if (solids.length === 0) continue;
      const merged = mergeGeometries(solids);
      const marks = new BufferAttribute(new Float32Array(merged.getAttribute("position").count), 1);
      merged.setAttribute("marked", marks);
      let from = 0;
      own.forEach(({ index }, place) => {
        const to = from + (solids[place]?.getAttribute("position").count ?? 0);
        this.corners.set(index, { marks, from, to });
        from = to;
      });
      const mesh = new Mesh(merged, this.material());
      mesh.name = part;
      for (const one of solids) one.dispose();
      (part === "frame" ? this.group : part === "peg" ? this.peg : this.head).add(mesh);
      this.meshes.push({ part, mesh });
    }
    this.paint(theme);
    this.paintMarks(this.marked, this.markStrength);
  }

  paint(theme: Theme): void {
    for (const { part, mesh } of this.meshes) {
      (mesh.material.uniforms.colour?.value as Vector3 | undefined)?.set(...theme.machine[part]);
      (mesh.material.uniforms.mark?.value as Vector3 | undefined)?.set(...this.markColour(theme));
    }
  }

  /** Marks bodies by their places in the profile, and no others. */
  mark(bodies: readonly number[]): void {
    if (bodies.join() === this.marked.join()) return;
    this.paintMarks(this.marked, 0);
    this.paintMarks(bodies, this.markStrength);
    this.marked = bodies;
  }

  /** The first body on a ray, by its place in the profile. */
  bodyOn({ origin, direction }: Ray): number | null {
    this.group.updateMatrixWorld(true);
    const ray = new Raycaster(new Vector3(...origin), new Vector3(...direction));
    const [hit] = ray.intersectObjects<Mesh<BufferGeometry>>(this.meshes.map(({ mesh }) => mesh));
    if (!hit?.face) return null;
    const marks = hit.object.geometry.getAttribute("marked");
    const { a } = hit.face;
    const found = [...this.corners].find(([, own]) => own.marks === marks && own.from <= a && a < own.to);
    return found?.[0] ?? null;
  }

  private paintMarks(bodies: readonly number[], value: number): void {
    for (const body of bodies) {
      const corners = this.corners.get(body);
      if (!corners) continue;
      corners.marks.array.fill(value, corners.from, corners.to);
      corners.marks.needsUpdate = true;
    }
  }

  /** Degrees: the head about +x, the bend axis about the head's z. `out`: of the peg, from 0 to 1. */
  pose(head: number, axis: number, out: number): void {
    this.head.rotation.x = MathUtils.degToRad(head);
    this.peg.rotation.z = MathUtils.degToRad(axis);
    this.peg.position.z = (out - 1) * this.stroke;
  }

  dispose(): void {
    this.clear();
  }

  private clear(): void {
    this.corners.clear();
    for (const { mesh } of this.meshes.splice(0)) {
      mesh.removeFromParent();
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
  }

  private material(): ShaderMaterial {
    return new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ...this.uniforms, colour: { value: new Vector3() }, mark: { value: new Vector3() } },
    });
  }
}

function solid({ shape, at, axis }: MachineBody, orbit: number): BufferGeometry {
  const made = shape.kind === "box" ? new BoxGeometry(...shape.size) : cylinder(shape.radius, shape.length);
  return made.applyMatrix4(
    new Matrix4().compose(new Vector3(at[0] - orbit, at[1], at[2]), towards(axis), new Vector3(1, 1, 1)),
  );
}

/** Along z; three.js makes it along y. */
function cylinder(radius: number, length: number): BufferGeometry {
  return new CylinderGeometry(radius, radius, length, 40).rotateX(Math.PI / 2);
}

/** The edges of a body, where it is at its reference. */
export function edgesOf(body: MachineBody): (readonly [Vec3, Vec3])[] {
  const made = solid(body, 0);
  const edges = new EdgesGeometry(made, 30);
  made.dispose();
  const places = edges.getAttribute("position");
  const at = (index: number): Vec3 => [places.getX(index), places.getY(index), places.getZ(index)];
  const lines = Array.from({ length: places.count / 2 }, (_, line) => [at(2 * line), at(2 * line + 1)] as const);
  edges.dispose();
  return lines;
}

/** The eight corners of the box around a body, where it is at its reference. */
export function reach({ shape, at, axis }: MachineBody): Vec3[] {
  const turn = towards(axis);
  const half =
    shape.kind === "box" ? shape.size.map((size) => size / 2) : [shape.radius, shape.radius, shape.length / 2];
  const signs = [-1, 1];
  return signs.flatMap((x) =>
    signs.flatMap((y) =>
      signs.map((z): Vec3 => {
        const corner = new Vector3(x * (half[0] ?? 0), y * (half[1] ?? 0), z * (half[2] ?? 0)).applyQuaternion(turn);
        return [at[0] + corner.x, at[1] + corner.y, at[2] + corner.z];
      }),
    ),
  );
}

/** Takes z to `axis` the shortest way. */
function towards(axis: Vec3): Quaternion {
  const way = new Vector3(...axis);
  return way.lengthSq() > 0
    ? new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), way.normalize())
    : new Quaternion();
}
