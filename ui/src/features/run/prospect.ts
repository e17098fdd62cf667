import { useDesign } from "../../state/design/design";
import type { Prospect } from "./buttons";

/** What there is to bend of the open design, as far as the checks know. */
export function useProspect(): Prospect {
  const { check, edges } = useDesign();
  return {
    program: edges.size > 0 && (check?.wires.some(({ time_s }) => time_s !== null) ?? false),
    feasible: check?.feasible ?? false,
  };
}
