/** Where to go with a problem that no change of the design fixes by itself. */

import { useDesign } from "../../state/design/design";
import { select } from "../../state/design/selection";
import { shownDesign } from "../../state/parts/parts";
import { run } from "../../state/window/commands";
import { useUi } from "../../state/window/ui";
import { frame } from "../../state/window/view";
import { smallerParts } from "./parts";

interface WayOut {
  readonly label: string;
  readonly title: string;
  readonly go: () => void;
}

const toMachine = () => useUi.getState().showSection("machine");

function selectSmaller(): void {
  const { vertices, edges } = smallerParts(shownDesign(useDesign.getState()));
  select(vertices, edges);
  frame(vertices, edges);
}

/** Null where there is no other place to go to. `stencil`: whether there is one to trace on. */
export function wayOut(code: string, stencil: boolean): WayOut | null {
  switch (code) {
    case "wire_does_not_fit":
      return {
        label: "Choose a wire",
        title: "Wires that fit the machine, and machines that take this wire",
        go: toMachine,
      };
    case "stock_too_long":
      return { label: "Machines", title: "Another machine may hold longer stock", go: toMachine };
    case "no_edges":
      return stencil
        ? { label: "Trace", title: "Place vertices on the stencil with clicks", go: () => run("tool-trace") }
        : { label: "Draw", title: "Draw edges on a plane with clicks", go: () => run("tool-draw") };
    case "several_wires":
      return {
        label: "Select the smaller",
        title: "All parts but the largest: delete them, or connect them with C",
        go: selectSmaller,
      };
    default:
      return null;
  }
}
