/** The surfaces that are traced, as one place to look for targets. */

import { Group } from "three";
import type { Shared } from "../drawing/shading";
import type { Theme } from "../drawing/theme";
import type { SceneStencil, Vec3 } from "../interface";
import { lifted } from "../picking/lift";
import type { StencilTargets, SurfaceTargets } from "../picking/snap";
import { type Candidate, nearestTargets } from "../picking/stencil_targets";
import { distance, dot, type Ray, scale } from "../vec";
import type { Projection } from "../view/projection";
import type { Held } from "./chosen";
import { depthMaterial, Surface } from "./surface";

/** Places of each that are looked at to see all of it. */
const SAMPLES = 1500;

/** Where a ray meets a surface; the normal of the face there, as that is wound. */
interface Hit {
  readonly surface: Surface;
  readonly at: Vec3;
  readonly normal: Vec3;
  /** Which way the ray went: in perspective one beside it may see the other side of a face. */
  readonly way: Vec3;
}

export class Stencils implements SurfaceTargets {
  readonly group = new Group();
  private readonly surfaces = new Map<number, Surface>();
  private readonly depth = depthMaterial();
  private stencils: readonly SceneStencil[] = [];
  private theme: Theme | null = null;
  private seen = 0.4;
  /** How far off the surface a place lies that is snapped to, on the side that is seen, mm. */
  offset = 0;

  constructor(private readonly uniforms: Shared) {}

  /** Shows these instead of those before; a surface that is still there is not built anew. */
  show(stencils: readonly SceneStencil[]): void {
    this.stencils = stencils;
    const kept = new Map(stencils.map((stencil) => [stencil.id, stencil] as const));
    for (const [id, surface] of this.surfaces) {
      if (kept.get(id)?.surface === surface.stencil.surface) continue;
      this.group.remove(surface.group);
      surface.dispose();
      this.surfaces.delete(id);
    }
    for (const stencil of stencils) {
      const known = this.surfaces.get(stencil.id);
      if (known) known.place(stencil);
      else if (stencil.surface.triangles.length > 0) {
        const surface = new Surface(stencil, this.uniforms, this.depth);
        this.surfaces.set(stencil.id, surface);
        this.group.add(surface.group);
      }
    }
    this.repaint();
  }

  /** Shows one elsewhere while it is in the hand; null: where it lies. */
  hold(id: number, held: Held | null): void {
    const stencil = this.stencils.find((known) => known.id === id);
    if (stencil) this.surfaces.get(id)?.place(stencil, held);
  }

  set opacity(opacity: number) {
    this.seen = opacity;
    this.repaint();
  }

  paint(theme: Theme): void {
    this.theme = theme;
    this.repaint();
  }

  /** Some corners of what is shown, mm, spread evenly enough to frame it. */
  get places(): Vec3[] {
    return this.shown.flatMap((surface) => surface.places(SAMPLES));
  }

  /** Whether there is nothing to trace on. */
  get empty(): boolean {
    return this.shown.length === 0;
  }

  near(projection: Projection, x: number, y: number, reach: number): StencilTargets {
    return this.nearOff(projection, x, y, reach, this.offset);
  }

  /** The stencils as they are, whatever the offset. */
  get bare(): SurfaceTargets {
    return {
      near: (projection, x, y, reach) => this.nearOff(projection, x, y, reach, 0),
      hides: (projection, at) => this.hides(projection, at),
    };
  }

  private nearOff(projection: Projection, x: number, y: number, reach: number, offset: number): StencilTargets {
    const hit = this.hit(projection.ray(x, y)) ?? this.hitAround(projection, x, y, reach);
    if (!hit) return { vertex: null, edge: null, side: null, surface: null };
    const triangles = hit.surface.fewTrianglesAround(hit.at, reach * projection.pixel(hit.at));
    const { vertex, edge, side: piece } = nearestTargets(triangles, projection, x, y, reach);
    if (offset === 0) return { vertex, edge, side: piece && hit.surface.whole(piece), surface: hit.at };
    const flipped = dot(hit.normal, hit.way) > 0;
    const side = flipped ? scale(hit.normal, -1) : hit.normal;
    const off = (at: Vec3 | null, on: readonly Candidate[]) => at && lifted(at, on, side, flipped, offset);
    return { vertex: off(vertex, triangles), edge: off(edge, triangles), side: null, surface: off(hit.at, []) };
  }

  hides(projection: Projection, at: Vec3): boolean {
    const seen = projection.seen(at);
    const ray = projection.ray(seen.x, seen.y);
    const hit = this.hit(ray);
    // A vertex that lies on the surface is not behind it: it may be a little below by rounding, or on a curve.
    return hit !== null && distance(ray.origin, at) - distance(ray.origin, hit.at) > hit.surface.radius * 0.04;
  }

  dispose(): void {
    this.show([]);
    this.depth.dispose();
  }

  private get shown(): Surface[] {
    return this.group.visible ? [...this.surfaces.values()].filter(({ group }) => group.visible) : [];
  }

  private repaint(): void {
    for (const { id, colour } of this.stencils) {
      if (this.theme) this.surfaces.get(id)?.paint(colour ?? this.theme.stencil, this.seen);
    }
  }

  /** The first surface that a ray meets, and where. */
  private hit(ray: Ray): Hit | null {
    let first: Hit | null = null;
    for (const surface of this.shown) {
      const met = surface.hit(ray);
      if (met && (!first || distance(ray.origin, met.at) < distance(ray.origin, first.at)))
        first = { surface, ...met, way: ray.direction };
    }
    return first;
  }

  /** Just beside the silhouette a surface is still meant: tries around the pointer, near before far. */
  private hitAround(projection: Projection, x: number, y: number, reach: number): Hit | null {
    for (const part of [0.35, 0.7, 1]) {
      for (let i = 0; i < 8; i += 1) {
        const angle = (i * Math.PI) / 4 + part;
        const hit = this.hit(projection.ray(x + Math.cos(angle) * reach * part, y + Math.sin(angle) * reach * part));
        if (hit) return hit;
      }
    }
    return null;
  }
}
