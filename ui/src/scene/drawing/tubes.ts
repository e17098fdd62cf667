/** Straight pieces of wire, all in one draw call. */

import { BackSide, BufferAttribute, BufferGeometry, FrontSide, Mesh, ShaderMaterial, Vector3 } from "three";
import type { Vec3 } from "../interface";
import { Instances } from "./instances";
import { GLSL, type Shared } from "./shading";
import type { Rgb } from "./theme";

const VERTEX = /* glsl */ `
attribute float end;
attribute vec3 from;
attribute vec3 to;
attribute vec3 colour;
attribute vec3 look;
uniform vec3 radius;
uniform float outline;
varying vec3 vNormal;
varying vec3 vColour;
varying float vDepth;
varying float vDim;
varying float vAlong;
${GLSL}
void main() {
  vec3 a = (modelViewMatrix * vec4(from, 1.0)).xyz;
  vec3 b = (modelViewMatrix * vec4(to, 1.0)).xyz;
  if (pixel.x > 0.0) {
    // What is behind the eye has no width on the screen: cut there, at the near plane.
    float near = projectionMatrix[3][2] / (projectionMatrix[2][2] - 1.0);
    vec3 whole = b - a;
    if (-a.z < near && -b.z > near) a += whole * ((a.z + near) / (a.z - b.z));
    else if (-b.z < near && -a.z > near) b -= whole * ((b.z + near) / (b.z - a.z));
  }
  float span = distance(a, b);
  vec3 way = span > 1e-9 ? (b - a) / span : vec3(1.0, 0.0, 0.0);
  vec3 centre = end < 0.5 ? a : b;
  float px = pixelAt(-centre.z);
  vec3 side = cross(way, towardsEye(centre));
  side = dot(side, side) > 1e-8 ? normalize(side) : normalize(cross(way, vec3(0.31, 0.95, 0.02)));
  vec3 normal = side * position.x + cross(way, side) * position.y + way * position.z;
  float thick = clamp(radius.x, radius.y * px, radius.z * px) * look.x + outline * px;
  vec3 at = centre + side * look.y * px + normal * thick;
  vNormal = normal;
  vColour = colour;
  vDepth = -at.z;
  vDim = look.z;
  vAlong = end * span / pixelAt(-0.5 * (a.z + b.z));
  gl_Position = projectionMatrix * vec4(at, 1.0);
}`;

const FRAGMENT = /* glsl */ `
uniform float dash;
uniform float flatness;
varying vec3 vNormal;
varying vec3 vColour;
varying float vDepth;
varying float vDim;
varying float vAlong;
${GLSL}
void main() {
  if (dash > 0.0 && fract(vAlong / dash) > 0.6) discard;
  vec3 shaded = faded(lit(vColour, normalize(vNormal)), vDepth, gl_FragCoord.xy);
  gl_FragColor = vec4(mix(mix(shaded, vColour, flatness), backdrop(gl_FragCoord.xy), vDim), 1.0);
}`;

export interface TubeStyle {
  /** mm, kept between `least` and `most` CSS pixels on the screen. */
  readonly radius: number;
  readonly least: number;
  readonly most: number;
  readonly sides?: number;
  /** Ends are half balls, so that bends have no notch. */
  readonly round?: boolean;
  /** CSS pixels from dash to dash; 0 for none. */
  readonly dash?: number;
  /** Shown only around what is in front of it: that much wider, CSS pixels. */
  readonly outline?: number;
  /** Without shading, and as clear far away as near. */
  readonly flat?: boolean;
  /** On top of everything. */
  readonly above?: boolean;
}

/** How one tube differs from the others. */
export interface TubeLook {
  readonly colour: Rgb;
  /** Factor on the radius. */
  readonly width?: number;
  /** CSS pixels to the side, as seen. */
  readonly offset?: number;
  /** 0 to 1: how much of it goes over into the backdrop. */
  readonly dim?: number;
}

/** A line over the picture: a rubber band, an axis that is locked, the side of a box. */
export interface Guide {
  readonly from: Vec3;
  readonly to: Vec3;
  readonly look: TubeLook;
}

/** Lines over everything, of one width however far away they are. */
export const GUIDE_STYLE: TubeStyle = { radius: 100, least: 0.9, most: 0.9, flat: true, above: true };

export class Tubes {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly instances: Instances;

  constructor(uniforms: Shared, style: TubeStyle) {
    this.instances = new Instances(shape(style.sides ?? 6, style.round ?? false), [
      ["from", 3],
      ["to", 3],
      ["colour", 3],
      ["look", 3],
    ]);
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        ...uniforms,
        radius: { value: new Vector3(style.radius, style.least, style.most) },
        outline: { value: style.outline ?? 0 },
        dash: { value: style.dash ?? 0 },
        flatness: { value: style.flat ? 1 : 0 },
      },
      side: style.outline ? BackSide : FrontSide,
      depthTest: !style.above,
      depthWrite: !style.above,
    });
    this.mesh = new Mesh(this.instances.geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  get count(): number {
    return this.instances.count;
  }

  set count(count: number) {
    this.instances.resize(count);
    this.mesh.visible = count > 0;
  }

  /** mm. */
  set radius(radius: number) {
    (this.mesh.material.uniforms.radius?.value as Vector3).x = radius;
  }

  set(row: number, from: Vec3, to: Vec3, look: TubeLook): void {
    this.instances.write(row, ...from, ...to, ...look.colour, look.width ?? 1, look.offset ?? 0, look.dim ?? 0);
  }

  /** These lines and no others. */
  show(lines: readonly Guide[]): void {
    this.count = lines.length;
    lines.forEach(({ from, to, look }, row) => this.set(row, from, to, look));
  }

  place(row: number, from: Vec3, to: Vec3): void {
    this.instances.patch(row, 0, ...from, ...to);
  }

  style(row: number, look: TubeLook): void {
    this.instances.patch(row, 6, ...look.colour, look.width ?? 1, look.offset ?? 0, look.dim ?? 0);
  }

  dispose(): void {
    this.instances.dispose();
    this.mesh.material.dispose();
  }
}

/** A tube of radius 1: x and y across, z along, which is 0 but in the half balls; `end` 0 where it begins. */
function shape(sides: number, round: boolean): BufferGeometry {
  const cap = round
    ? ([
        [0, 1],
        [Math.SQRT1_2, Math.SQRT1_2],
      ] as const)
    : [];
  const rings: { end: number; across: number; along: number }[] = [
    ...cap.map(([across, along]) => ({ end: 0, across, along: -along })),
    { end: 0, across: 1, along: 0 },
    { end: 1, across: 1, along: 0 },
    ...cap.toReversed().map(([across, along]) => ({ end: 1, across, along })),
  ];
  const positions: number[] = [];
  const ends: number[] = [];
  const index: number[] = [];
  rings.forEach((ring, level) => {
    for (let side = 0; side < sides; side += 1) {
      const angle = (2 * Math.PI * side) / sides;
      positions.push(Math.cos(angle) * ring.across, Math.sin(angle) * ring.across, ring.along);
      ends.push(ring.end);
      if (level === 0) continue;
      const [here, next] = [level * sides + side, level * sides + ((side + 1) % sides)];
      index.push(here - sides, next - sides, here, here, next - sides, next);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute("end", new BufferAttribute(new Float32Array(ends), 1));
  geometry.setIndex(index);
  return geometry;
}
