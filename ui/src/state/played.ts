/** A wire of a program as the scene plays it. */

import type { MachineViewResponse, MadeResponse, ProgramResponse, Shape } from "../generated/responses";
import type { MachineBody, Played, PlayedStep } from "../scene/interface";

/** Null where there is no such wire. */
export function playedWire(
  program: ProgramResponse,
  wire: number,
  machine: MachineViewResponse | null,
  made: MadeResponse | null,
): Played | null {
  const one = program.wires[wire];
  if (!one || one.steps.length === 0) return null;
  return {
    steps: one.steps.map(playedStep),
    path: one.corners_mm,
    made: made?.wires[wire]?.corners_mm ?? null,
    bodies: machine?.shapes.map(bodyOf) ?? [],
    wireDiameter: program.diameter_mm,
    orbitOffset: machine?.pivot_mm[0] ?? 0,
  };
}

function playedStep(step: ProgramResponse["wires"][number]["steps"][number]): PlayedStep {
  const { designed, told, seconds } = step;
  return {
    feed: designed.feed_mm,
    rotate: designed.rotate_deg,
    bend: designed.bend_deg,
    seconds,
    // Springback and setback are what the machine is told on top.
    bendAxis: (told ?? designed).bend_deg,
  };
}

/** A body of a profile: it names the whole head, pins included. */
export function bodyOf({ name, part, solid, at_mm, axis }: Shape): MachineBody {
  const shape: MachineBody["shape"] =
    "box" in solid
      ? { kind: "box", size: solid.box.size_mm }
      : { kind: "cylinder", radius: solid.cylinder.radius_mm, length: solid.cylinder.length_mm };
  return { name, part, shape, at: at_mm, axis };
}
