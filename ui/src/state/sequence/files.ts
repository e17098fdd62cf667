/** Sequences as files: kept, and read again. */

import { type FileKind, platform } from "../../platform";
import { tell, told } from "../asking/problems";
import { asking } from "../asking/work";
import { designStem } from "../files/files";
import { findSequence, orderOf, shownSequence, useSequence } from "./sequence";

const SEQUENCES: FileKind = { name: "Sequences", extensions: ["json"] };
/** The frame with the step of each strut besides. */
const SAVED: FileKind = { name: "Sequences, and VTK for ParaView", extensions: ["json", "vtk"] };

/** Picks a file with a sequence, and checks whether the design can be built so. `material`: what the machine builds with. */
export async function openSequence(material: string | null): Promise<void> {
  const file = await told(platform.pickFile([SEQUENCES]));
  if (file) await findSequence(material, file);
}

/** Picks a place, and writes the sequence there that is shown. */
export async function saveSequence(): Promise<void> {
  const { machine, epsilon, groupBy } = useSequence.getState();
  const sequence = shownSequence(useSequence.getState())?.sequence;
  if (machine === null || !sequence) return;
  const path = await told(platform.pickSave(`${designStem()}-sequence.json`, SAVED));
  if (!path) return;
  const saved = await told(
    asking("sequence", {
      machine,
      material: sequence.material,
      epsilon_mm: epsilon,
      group_by: groupBy,
      order: orderOf(sequence.steps),
      output: { path, force: true },
      format: path.toLowerCase().endsWith(".vtk") ? "vtk" : "wirebend",
    }),
  );
  if (saved?.sequence.feasible) tell("info", `The sequence is in ${path}.`, "sequence-saved");
  else if (saved) tell("error", "The sequence cannot be built any more: it was not saved.", "sequence-not-saved");
}
