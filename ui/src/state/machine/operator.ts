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

/** Whether something moves, or may move without being asked again. */
const UNDER_WAY: Readonly<Record<Phase, boolean>> = {
  connecting: false,
  connected: false,
  homing: true,
  ready: false,
  moving: true,
  armed: false,
  making: true,
  holding: true,
  stopping: true,
  stopped: false,
  failed: false,
  closed: false,
};

export const isUnderWay = (phase: Phase): boolean => UNDER_WAY[phase];

/** Whether the machine is in the middle of a wire. */
export const isInWire = (phase: Phase): boolean => phase === "making" || phase === "holding";
