/** What is said of a collision while a program is played. */

import type { ContactReport } from "../../generated/responses";
import { count, type DisplayUnit, length } from "../../shared/figures/format";

/** "Step 5 hits the head", "Step 5: the wire hits itself". */
export function hitOf({ step, body, finding }: Pick<ContactReport, "step" | "body" | "finding">): string {
  if (body === null) return `Step ${step + 1}: the wire hits itself`;
  return `Step ${step + 1} hits the ${finding.body ?? "machine"}`;
}

/** "2.1 mm deep, in 3 more steps; estimate". */
export function depthOf(
  { depth_mm, later, estimated }: Pick<ContactReport, "depth_mm" | "later" | "estimated">,
  unit: DisplayUnit,
): string {
  const again = later > 0 ? `, in ${count(later, "more step")}` : "";
  return `${length(depth_mm, unit)} deep${again}${estimated ? "; estimate" : ""}`;
}
