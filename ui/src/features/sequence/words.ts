import type { DrawnSequence } from "../../generated/responses";
import { count, number } from "../../shared/figures/format";

export const KINDS: Readonly<Record<"ground" | "create" | "connect", string>> = {
  ground: "on the ground",
  create: "into the open",
  connect: "between vertices",
};

/** The same in a narrow column. */
export const SHORT_KINDS: typeof KINDS = { ground: "ground", create: "into the open", connect: "between" };

export const STRATEGIES: Readonly<
  Record<"from-ground" | "stiffness-plan" | "restart" | "backtracking" | "paper-cost", string>
> = {
  "from-ground": "what is farthest from the ground comes last",
  "stiffness-plan": "what keeps the frame stiffest comes first",
  restart: "what was in the way comes later",
  backtracking: "found by going back from dead ends",
  "paper-cost": "layer by layer, by the cost of FrameFab",
};

/** What a step places. */
export const placedName = ({ edge, edges }: DrawnSequence["sequence"]["steps"][number]): string =>
  edges && edges.length > 1 ? `edge ${edge} and ${edges.length - 1} more` : `edge ${edge}`;

/** What the header of the section says. */
export function phraseOf({ sequence }: DrawnSequence): string {
  if (sequence.steps.length === 0) return sequence.proved ? "cannot be built" : "not found";
  const wrong = sequence.diagnostics.length;
  return sequence.feasible
    ? count(sequence.steps.length, "step")
    : `${count(sequence.steps.length, "step")} · ${number(wrong, 0)} wrong`;
}
