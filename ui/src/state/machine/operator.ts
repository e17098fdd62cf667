/** The words of the connected machine, as the Rust side has them. */

import type { JobStep, Phase } from "../../generated/responses";

export type { Answer, Move, Order } from "../../generated/requests";
export type {
  Because,
  Doubt,
  MachineState,
  OperatorEvent,
  OrderName,
  PartOfStep,
  Phase,
  Question,
  Unfinished,
  WireRun,
  WireState,
} from "../../generated/responses";

/** Feed in mm, the others in degrees, in canonical signs. */
export type Axes = JobStep;

/** Whether the machine is in the middle of a wire. */
export const isInWire = (phase: Phase): boolean => phase === "making" || phase === "holding";
