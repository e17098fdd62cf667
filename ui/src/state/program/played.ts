/** A wire of a program as the scene plays it. */

import type {
  MachineViewResponse,
  MadeResponse,
  MomentReport,
  PlayedWire,
  PoseReport,
  ProgramResponse,
  Shape,
} from "../../generated/responses";
import type { MachineBody, Moment, Played, PlayedStep, Pose } from "../../scene/interface";

/** Null where there is no such wire. */
export function playedWire(
  { wires, diameter_mm }: ProgramResponse,
  wire: number,
  machine: MachineViewResponse | null,
  made: MadeResponse | null,
): Played | null {
  const one = wires[wire];
  if (!one || one.steps.length === 0) return null;
  const asMade = made?.wires[wire];
  return {
    ...playedDesign(one, machine, diameter_mm),
    made: asMade ? { corners: asMade.corners_mm, poses: asMade.poses.map(poseOf) } : null,
  };
}

/** A wire as designed, on its machine. */
export function playedDesign(wire: PlayedWire, machine: MachineViewResponse | null, diameter_mm: number): Played {
  return {
    steps: wire.steps.map(playedStep),
    designed: { corners: wire.corners_mm, poses: wire.steps.map(({ pose }) => poseOf(pose)) },
    made: null,
    bodies: machine ? bodiesOf(machine) : [],
    wireDiameter: diameter_mm,
    orbitOffset: machine?.pivot_mm[0] ?? 0,
    pegTop: machine?.peg_top_mm ?? 0,
  };
}

/** Of each machine the same ones: it is not built anew for each wire that it bends. */
const bodies = new WeakMap<MachineViewResponse, Played["bodies"]>();

function bodiesOf(machine: MachineViewResponse): Played["bodies"] {
  const known = bodies.get(machine) ?? machine.shapes.map(bodyOf);
  bodies.set(machine, known);
  return known;
}

const poseOf = ({ turn, bend_axis, bend_deg }: PoseReport): Pose => ({ turn, bendAxis: bend_axis, bend: bend_deg });

function playedStep({ seconds, moments }: PlayedWire["steps"][number]): PlayedStep {
  return { seconds, moments: moments.map(momentOf) };
}

function momentOf({ at, fed, bent, head_deg, bend_axis_deg, peg_out }: MomentReport): Moment {
  return { at, fed, bent, head: head_deg, bendAxis: bend_axis_deg, pegOut: peg_out };
}

/** A body of a profile: it names the whole head, pins included. */
export function bodyOf({ name, part, solid, at_mm, axis }: Shape): MachineBody {
  const shape: MachineBody["shape"] =
    "box" in solid
      ? { kind: "box", size: solid.box.size_mm }
      : { kind: "cylinder", radius: solid.cylinder.radius_mm, length: solid.cylinder.length_mm };
  return { name, part, shape, at: at_mm, axis };
}
