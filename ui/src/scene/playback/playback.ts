/** A wire while it is bent on a machine: the wire that is out, what is still behind the nozzle, and the machine around it. */

import { Group, Vector3 } from "three";
import type { Shared } from "../drawing/shading";
import type { Rgb, Theme } from "../drawing/theme";
import { Tubes } from "../drawing/tubes";
import type { Moment, Played, PlayedBall, PlayedPath, Shown, Touch, Vec3 } from "../interface";
import { SpreadLayer } from "../layers/spread";
import { along, distance, scale, subtract } from "../vec";
import { Machine, reach } from "./machine";
import { momentAt, stepAt } from "./moments";
import { placed, turned } from "./pose";

/** mm of wire that are drawn behind the nozzle. */
const BEHIND = 260;
/** mm by which two sums of the same lengths may differ. */
const NEAR = 1e-3;

/** One of the two wires: as designed, or as made. */
class Wire {
  readonly tubes: Tubes;
  private styled = "";

  constructor(
    uniforms: Shared,
    wireDiameter: number,
    private readonly path: PlayedPath,
  ) {
    this.tubes = new Tubes(uniforms, { radius: wireDiameter / 2, least: 1.1, most: 1000, sides: 10, round: true });
  }

  /** `made` steps of the program are really done already and coloured so; what touches something is red. */
  show(step: number, { fed, bent }: Moment, colour: Rgb, made: number, touches: readonly Touch[], theme: Theme): void {
    const { corners, poses } = this.path;
    const index = Math.min(step, poses.length - 1);
    const pose = poses[index];
    const [begin, end] = [corners[index], corners[index + 1]];
    if (!pose || !begin || !end) return;
    const turn = turned(pose, bent);
    const { tubes } = this;
    // Whole parts, the one that is being fed, and the wire behind the nozzle.
    const isFed = bent > 0 || fed >= 1;
    const here = isFed ? end : along(begin, subtract(end, begin), fed);
    const whole = isFed ? index + 1 : index;
    const partial = !isFed && fed > 0;
    tubes.count = whole + (partial ? 1 : 0) + 1;
    const touched = touches.map(({ leg, body }) => `${leg}/${body}`).join();
    const key = `${whole} ${partial} ${made} ${touched} ${theme.text} ${colour.join()}`;
    if (key !== this.styled) this.style(whole + (partial ? 1 : 0), colour, made, touches, theme);
    this.styled = key;
    if (partial) tubes.place(whole, begin, here);
    const behind = new Vector3(-1, 0, 0).applyQuaternion(turn.clone().invert());
    tubes.place(tubes.count - 1, here, along(here, [behind.x, behind.y, behind.z], BEHIND));
    tubes.mesh.quaternion.copy(turn);
    const shift = new Vector3(...scale(here, -1)).applyQuaternion(turn);
    tubes.mesh.position.copy(shift);
  }

  /** mm of wire that are out of the nozzle. */
  out(step: number, { fed }: Moment): number {
    const { corners } = this.path;
    const length = (to: number): number => {
      const [from, end] = [corners[to - 1], corners[to]];
      return from && end ? distance(from, end) : 0;
    };
    let sum = length(step + 1) * fed;
    for (let to = 1; to <= step; to += 1) sum += length(to);
    return sum;
  }

  /** Places of the path in the frame of the machine, half way and at the end. On its way a wire reaches farther, but seldom and not for long. */
  get places(): Vec3[] {
    const { corners, poses } = this.path;
    const ends = [...new Set([poses.length >> 1, poses.length - 1])];
    return ends.flatMap((index) => {
      const [pose, end] = [poses[index], corners[index + 1]];
      if (!pose || !end) return [];
      const turn = turned(pose, 0);
      return corners.slice(0, index + 2).map((at) => placed(turn, end, at));
    });
  }

  dispose(): void {
    this.tubes.dispose();
  }

  private style(segments: number, colour: Rgb, made: number, touches: readonly Touch[], theme: Theme): void {
    const { path, tubes } = this;
    const legs = new Set(touches.map(({ leg }) => leg));
    const toCome = touches.some(({ body }) => body === null);
    const madeUntil = Math.min(made, path.poses.length);
    for (let at = 0; at < segments; at += 1) {
      const [from, to] = [path.corners[at], path.corners[at + 1]];
      const own = at < madeUntil ? theme.fine : colour;
      if (from && to) tubes.set(at, from, to, { colour: legs.has(at) ? theme.error : own });
    }
    const end = path.corners[segments] ?? path.corners[0];
    if (end) tubes.set(segments, end, end, toCome ? { colour: theme.error } : { colour: theme.vertex, dim: 0.45 });
  }
}

export class Playback {
  readonly group = new Group();
  private readonly machine: Machine;
  private played: Played | null = null;
  private designed: Wire | null = null;
  private made: Wire | null = null;
  private time = 0;
  private shown: Shown = "designed";
  private progress = 0;
  private touches: readonly Touch[] = [];
  private readonly spread: SpreadLayer;
  /** It lies where the wire as designed does. */
  private readonly scattered = new Group();
  private balls: readonly PlayedBall[] = [];

  constructor(
    private readonly uniforms: Shared,
    private theme: Theme,
  ) {
    this.machine = new Machine(uniforms);
    this.spread = new SpreadLayer(uniforms);
    this.scattered.add(this.spread.mesh);
    this.group.add(this.machine.group, this.scattered);
    this.group.visible = false;
  }

  /** What there is to see, in the frame of the machine; null where nothing is played. */
  get places(): Vec3[] | null {
    if (!this.played) return null;
    return [...(this.designed?.places ?? []), ...this.played.bodies.flatMap(reach)];
  }

  /** z of the ground that the machine stands on, mm. */
  get ground(): number {
    return Math.min(0, ...(this.played?.bodies.flatMap(reach) ?? []).map((at) => at[2]));
  }

  play(played: Played | null): void {
    for (const wire of [this.designed, this.made]) {
      wire?.tubes.mesh.removeFromParent();
      wire?.dispose();
    }
    const before = this.played;
    this.played = played;
    this.group.visible = played !== null;
    this.designed = null;
    this.made = null;
    if (!played) return;
    const { designed, made, bodies, wireDiameter, orbitOffset, pegTop } = played;
    this.designed = new Wire(this.uniforms, wireDiameter, designed);
    if (made) this.made = new Wire(this.uniforms, wireDiameter, made);
    for (const wire of [this.designed, this.made]) if (wire) this.group.add(wire.tubes.mesh);
    const same =
      before && before.bodies === bodies && before.orbitOffset === orbitOffset && before.wireDiameter === wireDiameter;
    if (!same) this.machine.show(bodies, orbitOffset, pegTop, wireDiameter, this.theme);
    this.update();
  }

  /** Step with its fraction, from 0 to the number of steps. */
  setTime(time: number, shown: Shown): void {
    this.time = time;
    this.shown = shown;
    this.update();
  }

  /** So many steps have really been done; 0 for none. */
  setProgress(steps: number): void {
    this.progress = steps;
    this.update();
  }

  /** What touches what, drawn red. */
  setTouches(touches: readonly Touch[]): void {
    this.touches = touches;
    this.machine.mark(touches.flatMap(({ body }) => (body === null ? [] : [body])));
    this.update();
  }

  /** Balls around places of the wire as designed, in its order: each is seen once its place is out of the nozzle. */
  setSpread(balls: readonly PlayedBall[]): void {
    this.balls = balls;
    this.spread.show(balls);
    this.update();
  }

  paint(theme: Theme): void {
    this.theme = theme;
    this.machine.paint(theme);
    this.update();
  }

  dispose(): void {
    this.play(null);
    this.machine.dispose();
    this.spread.dispose();
  }

  private update(): void {
    const { played, theme } = this;
    const at = played && stepAt(played.steps.length, this.time);
    const now = at && momentAt(played.steps[at.step]?.moments ?? [], at.fraction);
    if (!at || !now) return;
    const showMade = this.made !== null && this.shown !== "designed";
    const showDesigned = !showMade || this.shown === "both";
    this.designed?.show(at.step, now, theme.edge, this.progress, this.touches, theme);
    this.made?.show(at.step, now, theme.made, showDesigned ? 0 : this.progress, this.touches, theme);
    if (this.designed) {
      const { mesh } = this.designed.tubes;
      mesh.visible = showDesigned;
      this.scattered.visible = showDesigned;
      this.scattered.quaternion.copy(mesh.quaternion);
      this.scattered.position.copy(mesh.position);
      const out = this.designed.out(at.step, now) + NEAR;
      this.spread.keep(this.balls.filter(({ along }) => along <= out).length);
    }
    if (this.made) this.made.tubes.mesh.visible = showMade;
    this.machine.pose(now.head, now.bendAxis, now.pegOut);
  }
}
