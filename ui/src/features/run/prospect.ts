import { useDesign } from "../../state/design/design";
import { useRunFile } from "../../state/program/run_file";
import type { Prospect } from "./buttons";

/**
 * What there is to bend of the open design, as far as the checks know. Collisions are no reason to refuse: they are named before
 * a person says yes.
 */
export function useProspect(): Prospect {
  const { limits, edges } = useDesign();
  const file = useRunFile((run) => run.file);
  if (file) return { program: file.kind !== "moves", feasible: file.feasible || file.kind === "job", file: file.kind };
  return {
    program: edges.size > 0 && (limits?.wires.some(({ time_s }) => time_s !== null) ?? false),
    feasible: limits?.feasible ?? false,
    file: null,
  };
}
