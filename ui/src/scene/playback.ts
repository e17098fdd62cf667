/** A wire while it is made on a machine: the wire that is out, what is still behind the nozzle, and the machine around it. */

import { Group, type Quaternion, Vector3 } from "three";
import type { Played, PlayedStep, Shown, Vec3 } from "./interface";
import { Machine, reach } from "./machine";
import { bendTurn, corners, type Run, runs } from "./poses";
import type { Shared } from "./shading";
import type { Rgb, Theme } from "./theme";
import { phase, stepAt, waitsForPeg } from "./timing";
import { Tubes } from "./tubes";
import { along, distance, scale } from "./vec";

/** mm of wire that are drawn behind the nozzle. */
const BEHIND = 260;
const RADIANS = Math.PI / 180;

/** One of the two wires: as designed, or as made. */
class Wire {
  readonly tubes: Tubes;
  private readonly runs: readonly Run[];
  private styled = "";

  constructor(
    uniforms: Shared,
    private readonly path: readonly Vec3[],
    steps: readonly PlayedStep[],
    at: readonly number[],
    diameter: number,
  ) {
    this.runs = runs(path, steps, at);
    this.tubes = new Tubes(uniforms, { radius: diameter / 2, least: 1.1, most: 1000, sides: 10, round: true });
  }

  /** `steps` of the program that are really made already are coloured so. */
  show(step: number, feed: number, bend: number, colour: Rgb, made: number, theme: Theme): void {
    const run = this.runs[Math.min(step, this.runs.length - 1)];
    if (!run) return;
    const out = run.length * feed;
    const turn = bendTurn(run.bendAxis, run.bendAngle * bend).multiply(run.turn);
    const { tubes, path } = this;
    // Whole segments, the one that is being fed, and the wire behind the nozzle.
    let whole = run.first;
    let left = out;
    for (; whole < run.last; whole += 1) {
      const size = distance(path[whole] ?? run.way, path[whole + 1] ?? run.way);
      if (left < size) break;
      left -= size;
    }
    const here = bend > 0 || feed >= 1 ? path[run.last] : along(path[run.first] ?? run.way, run.way, out);
    if (!here) return;
    const partial = whole < run.last && left > 0;
    tubes.count = whole + (partial ? 1 : 0) + 1;
    const key = `${whole} ${partial} ${made} ${theme.text} ${colour.join()}`;
    if (key !== this.styled) this.style(whole + (partial ? 1 : 0), colour, made, theme);
    this.styled = key;
    if (partial) tubes.place(whole, path[whole] ?? here, here);
    const inverse = turn.clone().invert();
    const behind = new Vector3(-1, 0, 0).applyQuaternion(inverse);
    tubes.place(tubes.count - 1, here, along(here, [behind.x, behind.y, behind.z], BEHIND));
    tubes.mesh.quaternion.copy(turn);
    const shift = new Vector3(...scale(here, -1)).applyQuaternion(turn);
    tubes.mesh.position.copy(shift);
  }

  /** Places of the path in the frame of the machine, half way and at the end. On its way a wire reaches farther, but seldom and not for long. */
  get places(): Vec3[] {
    return [this.runs[this.runs.length >> 1], this.runs.at(-1)].flatMap((run) => {
      const end = run && this.path[run.last];
      return run && end ? this.path.slice(0, run.last + 1).map((at) => placed(run.turn, end, at)) : [];
    });
  }

  dispose(): void {
    this.tubes.dispose();
  }

  private style(segments: number, colour: Rgb, made: number, theme: Theme): void {
    const { path, tubes } = this;
    const madeUntil = made > 0 ? (this.runs[Math.min(made, this.runs.length) - 1]?.last ?? 0) : 0;
    for (let at = 0; at < segments; at += 1) {
      const [from, to] = [path[at], path[at + 1]];
      if (from && to) tubes.set(at, from, to, { colour: at < madeUntil ? theme.fine : colour });
    }
    const end = path[segments] ?? path[0];
    if (end) tubes.set(segments, end, end, { colour: theme.vertex, dim: 0.45 });
  }
}

function placed(turn: Quaternion, origin: Vec3, at: Vec3): Vec3 {
  const moved = new Vector3(at[0] - origin[0], at[1] - origin[1], at[2] - origin[2]).applyQuaternion(turn);
  return [moved.x, moved.y, moved.z];
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

  constructor(
    private readonly uniforms: Shared,
    private theme: Theme,
  ) {
    this.machine = new Machine(uniforms);
    this.group.add(this.machine.group);
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
    const { steps, path, made, bodies, wireDiameter } = played;
    const at = corners(path, steps.length);
    this.designed = new Wire(this.uniforms, path, steps, at, wireDiameter);
    // The same corners where the two have the same points; a wire as made may have bends where none were asked for.
    if (made)
      this.made = new Wire(this.uniforms, made, steps, made.length === path.length ? at : corners(made, steps.length), wireDiameter);
    for (const wire of [this.designed, this.made]) if (wire) this.group.add(wire.tubes.mesh);
    const same = before && before.bodies === bodies && before.orbitOffset === played.orbitOffset && before.wireDiameter === wireDiameter;
    if (!same) this.machine.show(bodies, played.orbitOffset ?? 0, wireDiameter, this.theme);
    this.update();
  }

  /** Step with its fraction, from 0 to the number of steps. */
  setTime(time: number, shown: Shown): void {
    this.time = time;
    this.shown = shown;
    this.update();
  }

  /** So many steps have really been made; 0 for none. */
  setProgress(steps: number): void {
    this.progress = steps;
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
  }

  private update(): void {
    const { played, theme } = this;
    const at = played && stepAt(played.steps.length, this.time);
    const step = at && played.steps[at.step];
    if (!played || !at || !step) return;
    const { feed, rotate, bend, axis, out } = phase(step, at.fraction);
    const showMade = this.made !== null && this.shown !== "designed";
    const showDesigned = !showMade || this.shown === "both";
    this.designed?.show(at.step, feed, bend, theme.edge, this.progress, theme);
    this.made?.show(at.step, feed, bend, theme.made, showDesigned ? 0 : this.progress, theme);
    if (this.designed) this.designed.tubes.mesh.visible = showDesigned;
    if (this.made) this.made.tubes.mesh.visible = showMade;
    const before = played.steps.slice(0, at.step).reduce((sum, one) => sum + one.rotate, 0);
    // Right-handed about the direction of travel, which is -x.
    this.machine.pose(-(before + step.rotate * rotate) * RADIANS, step.bendAxis * axis * RADIANS, waitsForPeg(played.steps) ? out : 1);
  }
}
