import type { DiagnosticReport } from "../../generated/responses";

/** Findings that only a check for collisions makes: each fix of them was tried with one. */
export const isCollision = (code: DiagnosticReport["code"]): boolean =>
  code === "meets_machine" || code === "meets_stock";
