/** The words of the connected machine, as the Rust side has them. */

import type { OperatorEvent, StepReport } from "../generated/tells";
import type { Told } from "../platform";

export type { Answer, MachineOrder as Order, Move } from "../generated/requests";
export type { Doubt, MachineState, News, OperatorEvent, OrderName, PartOfStep, Phase, Question, Unfinished, WireRun, WireState } from "../generated/tells";

/** Feed in mm, the others in degrees, in canonical signs. */
export type Axes = StepReport;

/** An event of the operator among what is told; null where it is something else. */
export function operatorEvent(told: Told): OperatorEvent | null {
  return told.tell === "operator" ? told.value : null;
}
