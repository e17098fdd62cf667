/** Orders of building as files: kept, and read again. */

import { type FileKind, platform } from "../../platform";
import { tell, told } from "../asking/problems";
import { asking } from "../asking/work";
import { designStem } from "../files/files";
import { findSequence, orderOf, shownSequence, useSequence } from "./sequence";

const ORDERS: FileKind = { name: "Orders of building", extensions: ["json"] };
/** The frame with the step of each strut besides. */
const SAVED: FileKind = { name: "Orders of building, and VTK for ParaView", extensions: ["json", "vtk"] };

/** Picks a file with an order, and checks whether the design can be built so. `material`: what the machine builds with. */
export async function openOrder(material: string | null): Promise<void> {
  const file = await told(platform.pickFile([ORDERS]));
  if (file) await findSequence(material, file);
}

/** Picks a place, and writes the order there that is shown. */
export async function saveOrder(): Promise<void> {
  const { machine, epsilon, groupBy } = useSequence.getState();
  const sequence = shownSequence(useSequence.getState())?.sequence;
  if (machine === null || !sequence) return;
  const path = await told(platform.pickSave(`${designStem()}-order.json`, SAVED));
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
  if (saved?.sequence.feasible) tell("info", `The order is in ${path}.`, "order-saved");
  else if (saved) tell("error", "The order cannot be built any more: it was not saved.", "order-not-saved");
}
