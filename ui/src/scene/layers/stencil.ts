/** The surface that is traced: drawn see-through, and asked for places to snap to. */

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  LessEqualDepth,
  Mesh,
  ShaderMaterial,
  Sphere,
  Ray as ThreeRay,
  Vector3,
} from "three";
import { MeshBVH } from "three-mesh-bvh";
import { GLSL, type Shared } from "../drawing/shading";
import type { Theme } from "../drawing/theme";
import type { SceneStencil, Vec3 } from "../interface";
import type { SurfaceTargets } from "../picking/snap";
import { type Candidate, nearestTargets } from "../picking/stencil_targets";
import { along, cross, direction, distance, type Ray, subtract } from "../vec";
import type { Projection } from "../view/projection";

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

/** Triangles that are looked at for one place. */
const MANY = 200;

/** Places of it that are looked at to see all of it. */
const SAMPLES = 1500;

export class Stencil implements SurfaceTargets {
  readonly group = new Group();
  private geometry: BufferGeometry | null = null;
  private bvh: MeshBVH | null = null;
  private readonly colour: ShaderMaterial;
  private readonly depth: ShaderMaterial;
  private size = 1;

  constructor(uniforms: Shared) {
    const own = { colour: { value: new Vector3() }, opacity: { value: 0.4 } };
    // First the nearest depth alone, then the colour there: so one layer is seen and not the back and the inside through it.
    // The wire is drawn before, and is seen through that layer.
    this.depth = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: "void main() { gl_FragColor = vec4(1.0); }",
      side: DoubleSide,
      transparent: true,
      colorWrite: false,
    });
    this.colour = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ...uniforms, ...own },
      side: DoubleSide,
      transparent: true,
      depthWrite: false,
      depthFunc: LessEqualDepth,
    });
  }

  /** Triangles are kept in the order of the index, which is rearranged: a copy is made. */
  show(stencil: SceneStencil | null): void {
    this.clear();
    if (!stencil || stencil.triangles.length === 0) return;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(stencil.positions, 3));
    geometry.setIndex(new BufferAttribute(stencil.triangles.slice(), 1));
    this.bvh = new MeshBVH(geometry);
    geometry.computeBoundingSphere();
    this.size = geometry.boundingSphere?.radius ?? 1;
    this.geometry = geometry;
    const [depth, colour] = [new Mesh(geometry, this.depth), new Mesh(geometry, this.colour)];
    // After the wires, which have to be there to be seen through it, and after the grid.
    [depth.renderOrder, colour.renderOrder] = [20, 21];
    this.group.add(depth, colour);
  }

  set opacity(opacity: number) {
    (this.colour.uniforms.opacity as { value: number }).value = opacity;
  }

  paint(theme: Theme): void {
    (this.colour.uniforms.colour?.value as Vector3 | undefined)?.set(...theme.stencil);
  }

  /** Some of its corners, mm, spread evenly enough to frame it. */
  get places(): Vec3[] {
    const positions = this.geometry?.getAttribute("position");
    const count = positions?.count ?? 0;
    const every = Math.max(Math.ceil(count / SAMPLES), 1);
    return Array.from({ length: Math.floor(count / every) }, (_, i): Vec3 => {
      const at = i * every;
      return [positions?.getX(at) ?? 0, positions?.getY(at) ?? 0, positions?.getZ(at) ?? 0];
    });
  }

  /** A ball around it, mm; null where there is no stencil. */
  get ball(): { centre: Vec3; radius: number } | null {
    const sphere = this.geometry?.boundingSphere;
    return sphere ? { centre: [sphere.center.x, sphere.center.y, sphere.center.z], radius: sphere.radius } : null;
  }

  near(
    projection: Projection,
    x: number,
    y: number,
    reach: number,
  ): { vertex: Vec3 | null; edge: Vec3 | null; surface: Vec3 | null } {
    const hit = this.hit(projection.ray(x, y)) ?? this.hitAround(projection, x, y, reach);
    if (!hit) return { vertex: null, edge: null, surface: null };
    // Where triangles are smaller than the pointer's reach, a smaller one finds the same as quickly as anywhere.
    let radius = reach * projection.pixel(hit);
    let triangles = this.trianglesAround(hit, radius);
    for (let halved = 0; triangles.length > MANY && halved < 6; halved += 1) {
      radius *= 0.5;
      triangles = this.trianglesAround(hit, radius);
    }
    return { ...nearestTargets(triangles, projection, x, y, reach), surface: hit };
  }

  hides(projection: Projection, at: Vec3): boolean {
    const seen = projection.seen(at);
    const ray = projection.ray(seen.x, seen.y);
    const hit = this.hit(ray);
    // A vertex that lies on the surface is not behind it: it may be a little below by rounding, or on a curve.
    return hit !== null && distance(ray.origin, at) - distance(ray.origin, hit) > this.size * 0.04;
  }

  dispose(): void {
    this.clear();
    this.colour.dispose();
    this.depth.dispose();
  }

  private clear(): void {
    this.group.clear();
    this.geometry?.dispose();
    this.geometry = null;
    this.bvh = null;
  }

  private hit({ origin, direction }: Ray): Vec3 | null {
    if (!this.group.visible) return null;
    const found = this.bvh?.raycastFirst(new ThreeRay(new Vector3(...origin), new Vector3(...direction)), DoubleSide);
    return found ? along(origin, direction, found.distance) : null;
  }

  /** Just beside the silhouette the surface is still meant: tries around the pointer, near before far. */
  private hitAround(projection: Projection, x: number, y: number, reach: number): Vec3 | null {
    for (const part of [0.35, 0.7, 1]) {
      for (let i = 0; i < 8; i += 1) {
        const angle = (i * Math.PI) / 4 + part;
        const hit = this.hit(projection.ray(x + Math.cos(angle) * reach * part, y + Math.sin(angle) * reach * part));
        if (hit) return hit;
      }
    }
    return null;
  }

  /** Corners of all triangles within `radius` mm of a place, or of more than `MANY` of them. */
  private trianglesAround(centre: Vec3, radius: number): Candidate[] {
    const found: Candidate[] = [];
    const nearest = new Vector3();
    const ball = new Sphere(new Vector3(...centre), radius);
    this.bvh?.shapecast({
      intersectsBounds: (box) => ball.intersectsBox(box),
      intersectsTriangle: (triangle) => {
        if (triangle.closestPointToPoint(ball.center, nearest).distanceTo(ball.center) > radius) return false;
        const [a, b, c] = [triangle.a, triangle.b, triangle.c].map(
          (corner): Vec3 => [corner.x, corner.y, corner.z],
        ) as [Vec3, Vec3, Vec3];
        found.push({ corners: [a, b, c], normal: normal(a, b, c) });
        return found.length > MANY;
      },
    });
    return found;
  }
}

function normal(a: Vec3, b: Vec3, c: Vec3): Vec3 {
  return direction(cross(subtract(b, a), subtract(c, a))) ?? [0, 0, 0];
}
