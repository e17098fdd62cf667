import type { DiagnosticReport } from "../../generated/responses";

/** Findings that only a check for collisions makes: each fix of them was tried with one. */
export const isCollision = (code: DiagnosticReport["code"]): boolean =>
  code === "meets_machine" || code === "meets_stock";

/** Whether it hits nothing, and only comes nearer than the clearance. */
export const isNear = ({ code, value }: Pick<DiagnosticReport, "code" | "value">): boolean =>
  isCollision(code) && (value ?? 0) < 0;
