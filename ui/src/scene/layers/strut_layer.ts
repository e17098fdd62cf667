/** Struts instead of the edges of the design: deformed and coloured, or as they are built, with the head that builds them. */

import { DoubleSide, Group, LatheGeometry, Mesh, ShaderMaterial, Vector2, Vector3 } from "three";
import { GLSL, type Shared } from "../drawing/shading";
import type { Sign } from "../drawing/symbols";
import type { Theme } from "../drawing/theme";
import { type TubeLook, Tubes } from "../drawing/tubes";
import type { SceneHead, SceneLine, SceneStruts, Vec3 } from "../interface";
import { along } from "../vec";

const VERTEX = /* glsl */ `
varying vec3 vNormal;
varying vec3 vSeen;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  vNormal = normalMatrix * normal;
  vSeen = seen.xyz;
  gl_Position = projectionMatrix * seen;
}`;

// Glass: it is seen by its outline, and what it covers is seen through its middle.
const FRAGMENT = /* glsl */ `
uniform vec3 colour;
varying vec3 vNormal;
varying vec3 vSeen;
${GLSL}
void main() {
  vec3 normal = normalize(gl_FrontFacing ? vNormal : -vNormal);
  float edge = 1.0 - abs(dot(normal, towardsEye(vSeen)));
  gl_FragColor = vec4(faded(lit(colour, normal), -vSeen.z, gl_FragCoord.xy), mix(0.14, 0.75, edge * edge));
}`;

/** Around the axis of the head. */
const SIDES = 32;
/** The sphere on which free directions are shown, as a part of the length of the head. */
const SPHERE = 0.45;
/** The edges of the design beside what is drawn. */
const GHOST = 0.8;

const UP = new Vector3(0, 1, 0);

export class StrutLayer {
  readonly group = new Group();
  private readonly tubes: Tubes;
  private readonly ghost: Tubes;
  private readonly head: Mesh<LatheGeometry, ShaderMaterial>;
  private outline: SceneHead["outline"] | null = null;
  private struts: SceneStruts | null = null;
  private scale = 1;

  constructor(
    uniforms: Shared,
    private theme: Theme,
  ) {
    this.tubes = new Tubes(uniforms, { radius: 0.9, least: 1.4, most: 2.8, sides: 8, round: true });
    this.ghost = new Tubes(uniforms, { radius: 0.4, least: 0.5, most: 0.9 });
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ...uniforms, colour: { value: new Vector3(...theme.machine.head) } },
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
    this.head = new Mesh(new LatheGeometry(), material);
    this.head.visible = false;
    this.head.renderOrder = 1;
    this.group.add(this.ghost.mesh, this.tubes.mesh, this.head);
    this.group.visible = false;
  }

  get shown(): boolean {
    return this.struts !== null;
  }

  show(struts: SceneStruts | null): void {
    this.struts = struts;
    this.draw();
  }

  /** By how much displacements are enlarged. */
  enlarge(scale: number): void {
    if (scale === this.scale) return;
    this.scale = scale;
    let row = 0;
    for (const line of this.struts?.lines ?? []) {
      const places = this.places(line);
      for (const [from, to] of pairs(places)) this.tubes.place(row++, from, to);
    }
  }

  paint(theme: Theme): void {
    this.theme = theme;
    (this.head.material.uniforms.colour?.value as Vector3 | undefined)?.set(...theme.machine.head);
    this.draw();
  }

  /** Rings and dots over it. */
  get signs(): Sign[] {
    const { struts, theme, scale } = this;
    if (!struts) return [];
    const { worst, head } = struts;
    const signs: Sign[] = [];
    if (worst) {
      const at = worst.by ? along(worst.at, worst.by, scale) : worst.at;
      signs.push({ at, shape: "ring", colour: theme.hovered, radius: 9 });
    }
    if (head) {
      const reach = SPHERE * (head.outline.at(-1)?.[0] ?? 0);
      for (const way of head.free)
        signs.push({ at: along(head.tip, way, reach), shape: "dot", colour: theme.acted, radius: 5 });
      // Where the axis that is taken meets the same sphere.
      signs.push({ at: along(head.tip, head.axis, reach), shape: "target", colour: theme.hovered, radius: 6 });
    }
    return signs;
  }

  dispose(): void {
    this.tubes.dispose();
    this.ghost.dispose();
    this.head.geometry.dispose();
    this.head.material.dispose();
  }

  private places({ at, by }: SceneLine): readonly Vec3[] {
    if (!by) return at;
    return at.map((place, index) => along(place, by[index] ?? [0, 0, 0], this.scale));
  }

  private draw(): void {
    const { struts, theme } = this;
    const lines = struts?.lines ?? [];
    this.tubes.count = lines.reduce((sum, line) => sum + Math.max(line.at.length - 1, 0), 0);
    this.ghost.count = struts?.ghost ? this.tubes.count : 0;
    let row = 0;
    for (const line of lines) {
      const straight = pairs(line.at);
      pairs(this.places(line)).forEach(([from, to], index) => {
        this.tubes.set(row, from, to, lookOf(line, index));
        const [begin, end] = straight[index] ?? [from, to];
        if (struts?.ghost) this.ghost.set(row, begin, end, { colour: theme.vertex, dim: GHOST });
        row += 1;
      });
    }
    this.drawHead(struts?.head ?? null);
  }

  private drawHead(head: SceneHead | null): void {
    this.head.visible = head !== null;
    if (!head) return;
    if (head.outline !== this.outline) {
      this.outline = head.outline;
      this.head.geometry.dispose();
      const points = head.outline.map(([z, r]) => new Vector2(r, z));
      // Closed behind.
      points.push(new Vector2(0, head.outline.at(-1)?.[0] ?? 0));
      this.head.geometry = new LatheGeometry(points, SIDES);
    }
    this.head.position.set(...head.tip);
    this.head.quaternion.setFromUnitVectors(UP, new Vector3(...head.axis));
  }
}

/** One after the other, each with the next. */
const pairs = (places: readonly Vec3[]): (readonly [Vec3, Vec3])[] =>
  places.slice(1).map((to, index) => [places[index] ?? to, to] as const);

function lookOf({ colours, width, dim }: SceneLine, segment: number): TubeLook {
  const first = colours[0] ?? [0.5, 0.5, 0.5];
  const [a, b] = colours.length > 1 ? [colours[segment] ?? first, colours[segment + 1] ?? first] : [first, first];
  return {
    colour: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2],
    width: width ?? 1,
    dim: dim ?? 0,
  };
}
