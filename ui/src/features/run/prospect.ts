import { isRefused, useDesign } from "../../state/design/design";
import { useRunFile, useRunMachine } from "../../state/program/run_file";
import type { Prospect } from "./buttons";

/** What there is to bend of the open design, as far as the checks know: a collision that is an error there is one here. */
export function useProspect(): Prospect {
  const design = useDesign();
  const { limits, check, edges } = design;
  const file = useRunFile((run) => run.file);
  const machine = useRunMachine();
  if (file)
    return { machine, program: file.kind !== "moves", feasible: file.feasible || file.kind === "job", file: file.kind };
  return {
    machine,
    program: edges.size > 0 && (limits?.wires.some(({ time_s }) => time_s !== null) ?? false),
    feasible: check !== null && !isRefused(design),
    file: null,
  };
}
