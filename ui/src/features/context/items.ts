import type { MenuItem } from "../../shared/layers/Menu";
import { useDesign } from "../../state/design/design";
import { selectedEdges } from "../../state/design/operations";
import { isEmpty, useSelection } from "../../state/design/selection";
import { hideByHand, useByHand } from "../../state/machine/by_hand";
import { showDesignAgain, usePlayback } from "../../state/program/program";
import { run, whyNot } from "../../state/window/commands";
import type { MenuPlace } from "../../state/window/context_menu";
import { type CommandId, keyOf } from "../../state/window/keys";
import { fieldItems, textItems } from "./text_items";

const RULE: MenuItem = { kind: "rule" };

function item(label: string, command: CommandId): MenuItem {
  return { kind: "item", label, keys: keyOf(command), why: whyNot(command), run: () => run(command) };
}

/** Construction lines alone are selected. */
const makesEdges = (): boolean => useSelection.getState().lines.size > 0 && selectedEdges().length === 0;

/** What can be done with what is selected. */
const selected = (): MenuItem[] => [
  item("Move", "move"),
  item("Rotate…", "rotate"),
  item("Extrude an edge", "extrude"),
  item("Split", "split"),
  item("Connect", "connect"),
  item("Merge", "merge"),
  item(makesEdges() ? "Make edges" : "Make construction lines", "construction"),
  RULE,
  item("Mirror…", "mirror"),
  item("Array…", "array"),
  item("Scale…", "scale"),
  item("Straighten…", "straighten"),
  item("Round…", "round"),
  item("Fillet…", "fillet"),
  RULE,
  item("Cut", "cut"),
  item("Copy", "copy"),
  item("Paste", "paste"),
  item("Duplicate", "duplicate"),
  item("Delete", "delete"),
  RULE,
  item("Measure", "tool-measure"),
  item("Select connected", "select-connected"),
  item("Frame the selection", "frame"),
];

/** What can be done where nothing is selected. */
const beside = (): MenuItem[] => [
  item("Select all", "select-all"),
  item("Paste", "paste"),
  RULE,
  item("Select", "tool-select"),
  item("Trace on the stencil", "tool-trace"),
  item("Draw on a plane", "tool-draw"),
  item("Measure", "tool-measure"),
  RULE,
  item("Frame all", "frame-all"),
  {
    kind: "menu",
    label: "View",
    items: [
      item("Front", "view-front"),
      item("Back", "view-back"),
      item("Right", "view-right"),
      item("Left", "view-left"),
      item("Top", "view-top"),
      item("Bottom", "view-bottom"),
    ],
  },
];

const back = (run: () => void, why: string | null = null): MenuItem => ({
  kind: "item",
  label: "Back to the design",
  why,
  run,
});

/** What can be done while a program is shown. */
const played = (): MenuItem[] => [
  item("Play or pause", "play"),
  back(showDesignAgain, usePlayback.getState().live ? "A machine is bending the wire." : null),
  RULE,
  item("Frame all", "frame-all"),
];

/** What can be done while the wire is shown that moves by hand have bent. */
const movedByHand = (): MenuItem[] => [back(hideByHand), RULE, item("Frame all", "frame-all")];

function elsewhere(): MenuItem[] {
  const { state } = useDesign.getState();
  return [
    item(state?.undo ? `Undo ${state.undo}` : "Undo", "undo"),
    item(state?.redo ? `Redo ${state.redo}` : "Redo", "redo"),
    RULE,
    item("Frame all", "frame-all"),
    item("Keys", "keys"),
  ];
}

/** What the menu of a right click offers. */
export function itemsOf(place: MenuPlace): readonly MenuItem[] {
  if (place === "field") return fieldItems();
  if (place === "text") return textItems();
  if (place === "window") return elsewhere();
  if (usePlayback.getState().played) return played();
  if (useByHand.getState().played) return movedByHand();
  return isEmpty(useSelection.getState()) ? beside() : selected();
}
