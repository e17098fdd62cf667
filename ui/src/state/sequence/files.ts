/** Sequences as files: kept, and read again. The window goes on behind a dialog of files: what counts is how it stands after that. */

import { type FileKind, platform } from "../../platform";
import { tell, told } from "../asking/problems";
import { asking } from "../asking/work";
import { baseName, designStem } from "../files/files";
import { isSequenceStale, orderOf, shownSequence, underWay, useSequence } from "./sequence";

const SEQUENCES: FileKind = { name: "Sequences", extensions: ["json"] };
/** The frame with the step of each strut besides. */
const SAVED: FileKind = { name: "Sequences, and VTK for ParaView", extensions: ["json", "vtk"] };

/** Picks a file with a sequence; null where nobody has, or where something else is under way by then, which is said. */
export async function pickSequence(): Promise<string | null> {
  const file = await told(platform.pickFile([SEQUENCES]));
  const under = underWay(useSequence.getState());
  if (file === null || under === null) return file;
  tell("warning", `${baseName(file)} was not opened. ${under} Open it after that.`, "sequence-not-opened");
  return null;
}

/** Why the sequence that is shown cannot be saved; null where it can. */
export function whyNotSaved(): string | null {
  const state = useSequence.getState();
  const under = underWay(state);
  if (under !== null) return under;
  if (isSequenceStale()) return "Something was changed since.";
  return shownSequence(state)?.sequence.feasible ? null : "This sequence cannot be built.";
}

/** Picks a place, and writes the sequence there that is shown. */
export async function saveSequence(): Promise<void> {
  const path = await told(platform.pickSave(`${designStem()}-sequence.json`, SAVED));
  if (!path) return;
  const state = useSequence.getState();
  const { machine, epsilon, groupBy } = state;
  const sequence = shownSequence(state)?.sequence;
  const notSaved = (why: string) => tell("warning", `The sequence was not saved. ${why}`, "sequence-not-saved");
  if (machine === null || !sequence) return notSaved("It is not there any more.");
  const why = whyNotSaved();
  if (why !== null) return notSaved(why);
  useSequence.setState({ saving: true });
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
  useSequence.setState({ saving: false });
  if (saved?.sequence.feasible) tell("info", `The sequence is in ${path}.`, "sequence-saved");
  else if (saved) tell("error", "The sequence cannot be built any more: it was not saved.", "sequence-not-saved");
}
