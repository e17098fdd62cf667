/** What is said of a collision while a program is played. */

import type { ContactReport } from "../../generated/responses";
import { count, type DisplayUnit, meetingText } from "../../shared/figures/format";
import type { Met } from "../../state/program/contacts";

type Hit = Pick<ContactReport, "step" | "body" | "finding" | "depth_mm">;

/** "Step 5 hits the head", "Step 5: the wire comes near itself". */
export function hitOf({ step, body, finding, depth_mm }: Hit): string {
  const hits = depth_mm < 0 ? "comes near" : "hits";
  if (body === null) return `Step ${step + 1}: the wire ${hits} itself`;
  return `Step ${step + 1} ${hits} the ${finding.body ?? "machine"}`;
}

/** "2 collisions and 1 place nearer than the clearance, of other wires"; null where they have none. */
export function elsewhereOf({ hits, near }: Met): string | null {
  const all = [
    hits > 0 ? count(hits, "collision") : null,
    near > 0 ? `${count(near, "place")} nearer than the clearance` : null,
  ].filter(Boolean);
  return all.length > 0 ? `${all.join(" and ")}, of other wires` : null;
}

/** "2.1 mm deep, in 3 more steps; estimate", "within 0.4 mm". */
export function depthOf(
  { depth_mm, later, estimated }: Pick<ContactReport, "depth_mm" | "later" | "estimated">,
  unit: DisplayUnit,
): string {
  const again = later > 0 ? `, in ${count(later, "more step")}` : "";
  return `${meetingText(depth_mm, unit)}${again}${estimated ? "; estimate" : ""}`;
}
