/** A surface that is traced, where it lies in the design: drawn see-through, and asked for places to snap to. */

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  LessEqualDepth,
  Matrix4,
  Mesh,
  ShaderMaterial,
  Sphere,
  Ray as ThreeRay,
  Vector3,
} from "three";
import { MeshBVH } from "three-mesh-bvh";
import { GLSL, type Shared } from "../drawing/shading";
import type { Colour, SceneStencil, Vec3 } from "../interface";
import type { Line } from "../picking/snap";
import { type Candidate, wholeSide } from "../picking/stencil_targets";
import { AXES, cross, direction, ORIGIN, type Ray, subtract } from "../vec";
import type { Held } from "./chosen";

const VERTEX = /* glsl */ `
varying vec3 vPlace;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  vPlace = seen.xyz;
  gl_Position = projectionMatrix * seen;
}`;

const FRAGMENT = /* glsl */ `
uniform vec3 colour;
uniform float opacity;
varying vec3 vPlace;
${GLSL}
void main() {
  vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  vec3 eye = towardsEye(vPlace);
  float facing = abs(dot(normal, eye));
  // Where the surface turns away there is more of it to look through.
  float seen = opacity * mix(1.35, 1.0, smoothstep(0.0, 0.5, facing));
  gl_FragColor = vec4(faded(lit(colour, normal), -vPlace.z, gl_FragCoord.xy), min(seen, 1.0));
}`;

/** Triangles that are so near to a corner have it, as a share of how large the surface is. */
const TOUCHING = 1e-6;

/** Triangles that are looked at for one place. */
const MANY = 200;

export class Surface {
  readonly group = new Group();
  private readonly geometry = new BufferGeometry();
  private readonly bvh: MeshBVH;
  private readonly material: ShaderMaterial;
  private readonly inverse = new Matrix4();
  /** One mm of the surface, in mm of the design. */
  private scale = 1;
  /** The side that was looked at last, and all of it. */
  private last: { readonly name: string; readonly whole: Line } | null = null;

  /** `depth`: what is drawn first of every surface; see `depthMaterial`. */
  constructor(
    readonly stencil: SceneStencil,
    uniforms: Shared,
    depth: ShaderMaterial,
  ) {
    const { positions, triangles } = stencil.surface;
    this.geometry.setAttribute("position", new BufferAttribute(positions, 3));
    // Triangles are kept in the order of the index, which is rearranged: a copy is made.
    this.geometry.setIndex(new BufferAttribute(triangles.slice(), 1));
    this.bvh = new MeshBVH(this.geometry);
    this.geometry.computeBoundingSphere();
    this.material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ...uniforms, colour: { value: new Vector3() }, opacity: { value: 0.4 } },
      side: DoubleSide,
      transparent: true,
      depthWrite: false,
      depthFunc: LessEqualDepth,
    });
    const [first, second] = [new Mesh(this.geometry, depth), new Mesh(this.geometry, this.material)];
    // After the wires, which have to be there to be seen through it, and after the grid.
    [first.renderOrder, second.renderOrder] = [20, 21];
    this.group.add(first, second);
    this.group.matrixAutoUpdate = false;
    this.place(stencil);
  }

  /** Where it lies, and whether it is seen; `held`: where its places are while it is in the hand. */
  place({ matrix, hidden }: Pick<SceneStencil, "matrix" | "hidden">, held: Held | null = null): void {
    const [x, y, z] = matrix;
    this.group.matrix.set(...x, ...y, ...z, 0, 0, 0, 1);
    if (held) this.group.matrix.premultiply(matrixOf(held));
    this.group.matrixWorldNeedsUpdate = true;
    this.inverse.copy(this.group.matrix).invert();
    this.scale = Math.hypot(x[0], y[0], z[0]);
    this.group.visible = !hidden;
    this.last = null;
  }

  paint(colour: Colour, opacity: number): void {
    (this.material.uniforms.colour?.value as Vector3 | undefined)?.set(...colour);
    (this.material.uniforms.opacity as { value: number }).value = opacity;
  }

  /** Some of its corners, mm, spread evenly enough to frame it. */
  places(most: number): Vec3[] {
    const positions = this.geometry.getAttribute("position");
    const every = Math.max(Math.ceil(positions.count / most), 1);
    return Array.from({ length: Math.floor(positions.count / every) }, (_, i) =>
      this.inDesign(new Vector3().fromBufferAttribute(positions, i * every)),
    );
  }

  /** Of a ball around it, mm. */
  get radius(): number {
    return (this.geometry.boundingSphere?.radius ?? 0) * this.scale;
  }

  /** Where a ray of the design meets it first, and the normal of the face there, as that is wound. */
  hit({ origin, direction }: Ray): { at: Vec3; normal: Vec3 } | null {
    if (!this.group.visible) return null;
    const ray = new ThreeRay(new Vector3(...origin), new Vector3(...direction)).applyMatrix4(this.inverse);
    const found = this.bvh.raycastFirst(ray, DoubleSide);
    if (!found?.face) return null;
    const { x, y, z } = found.face.normal.clone().transformDirection(this.group.matrix);
    return { at: this.inDesign(found.point), normal: [x, y, z] };
  }

  /** Corners of all triangles within `radius` mm of a place, or of more than `MANY` of them. */
  trianglesAround(centre: Vec3, radius: number): Candidate[] {
    const found: Candidate[] = [];
    const nearest = new Vector3();
    const ball = new Sphere(new Vector3(...centre).applyMatrix4(this.inverse), radius / this.scale);
    this.bvh.shapecast({
      intersectsBounds: (box) => ball.intersectsBox(box),
      intersectsTriangle: (triangle) => {
        if (triangle.closestPointToPoint(ball.center, nearest).distanceTo(ball.center) > ball.radius) return false;
        const corners = [triangle.a, triangle.b, triangle.c].map((corner) => this.inDesign(corner.clone()));
        const [a, b, c] = corners as [Vec3, Vec3, Vec3];
        found.push({ corners: [a, b, c], normal: normal(a, b, c) });
        return found.length > MANY;
      },
    });
    return found;
  }

  /** The same, of a smaller place where triangles are smaller than that: there is found the same as anywhere near. */
  fewTrianglesAround(centre: Vec3, within: number): Candidate[] {
    let radius = within;
    let triangles = this.trianglesAround(centre, radius);
    for (let halved = 0; triangles.length > MANY && halved < 6; halved += 1) {
      radius *= 0.5;
      triangles = this.trianglesAround(centre, radius);
    }
    return triangles;
  }

  /** A side of a triangle with all that goes on straight from its ends, found once for the side that the pointer is on. */
  whole(side: Line): Line {
    const name = side.flat().join();
    if (this.last?.name !== name) {
      const whole = wholeSide(side, (corner) => this.trianglesAround(corner, this.radius * TOUCHING));
      this.last = { name, whole };
    }
    return this.last.whole;
  }

  dispose(): void {
    this.group.clear();
    this.geometry.dispose();
    this.material.dispose();
  }

  private inDesign(at: Vector3): Vec3 {
    const { x, y, z } = at.applyMatrix4(this.group.matrix);
    return [x, y, z];
  }
}

/**
 * First the nearest depth alone, then the colour there: so one layer is seen and not the back and the inside through it. The wire is drawn
 * before, and is seen through that layer.
 */
export function depthMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: "void main() { gl_FragColor = vec4(1.0); }",
    side: DoubleSide,
    transparent: true,
    colorWrite: false,
  });
}

function normal(a: Vec3, b: Vec3, c: Vec3): Vec3 {
  return direction(cross(subtract(b, a), subtract(c, a))) ?? [0, 0, 0];
}

function matrixOf(held: Held): Matrix4 {
  const origin = held(ORIGIN);
  const axis = (along: Vec3) => new Vector3(...subtract(held(along), origin));
  return new Matrix4().makeBasis(axis(AXES.x), axis(AXES.y), axis(AXES.z)).setPosition(...origin);
}
