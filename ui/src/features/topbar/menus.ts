import type { DisplayUnit } from "../../shared/figures/format";
import type { MenuItem } from "../../shared/layers/Menu";
import { useDesign } from "../../state/design/design";
import { clearRecent, openPath, useFiles } from "../../state/files/files";
import { run, whyNot } from "../../state/window/commands";
import { type CommandId, keyOf } from "../../state/window/keys";
import { type Theme, useUi } from "../../state/window/ui";
import { useUnits } from "../../state/window/units";
import { useView } from "../../state/window/view";

const RULE: MenuItem = { kind: "rule" };

function item(label: string, command: CommandId): MenuItem {
  return { kind: "item", label, keys: keyOf(command), why: whyNot(command), run: () => run(command) };
}

function recent(): MenuItem {
  const entries = useFiles.getState().recent;
  if (entries.length === 0) return { kind: "menu", label: "Open recent", items: [], why: "No recent files" };
  const items: MenuItem[] = entries.map(({ name, path, there }) => ({
    kind: "item",
    label: name,
    why: there ? null : `${path} is no longer there`,
    run: () => void openPath(path),
  }));
  return {
    kind: "menu",
    label: "Open recent",
    items: [...items, RULE, { kind: "item", label: "Clear the list", run: () => void clearRecent() }],
  };
}

const file = (): MenuItem[] => [
  item("New", "new"),
  item("Open…", "open"),
  item("Add to this design…", "add"),
  item("Open stencil…", "open-stencil"),
  recent(),
  item("Examples…", "examples"),
  RULE,
  item("Save", "save"),
  item("Save as…", "save-as"),
  item("Save wireframe (OBJ)…", "save-wireframe"),
  item("Save job…", "save-job"),
  RULE,
  item("Quit", "quit"),
];

function editing(): MenuItem[] {
  const { state } = useDesign.getState();
  return [
    item(state?.undo ? `Undo ${state.undo}` : "Undo", "undo"),
    item(state?.redo ? `Redo ${state.redo}` : "Redo", "redo"),
    RULE,
    item("Cut", "cut"),
    item("Copy", "copy"),
    item("Paste", "paste"),
    item("Duplicate", "duplicate"),
    item("Delete", "delete"),
    RULE,
    item("Select all", "select-all"),
    item("Select connected", "select-connected"),
    item("Invert selection", "invert"),
    RULE,
    item("Straighten…", "straighten"),
    item("Round…", "round"),
    item("Fillet…", "fillet"),
    item("Rotate…", "rotate"),
    item("Mirror…", "mirror"),
    item("Array…", "array"),
    item("Scale…", "scale"),
  ];
}

function viewing(): MenuItem[] {
  const { theme, setTheme, setUnit } = useUi.getState();
  const shown = useUnits.getState().unit;
  const themed = (value: Theme, label: string): MenuItem => ({
    kind: "item",
    label,
    checked: theme === value,
    radio: true,
    run: () => setTheme(value),
  });
  const unit = (value: DisplayUnit, label: string): MenuItem => ({
    kind: "item",
    label,
    checked: shown === value,
    radio: true,
    run: () => setUnit(value),
  });
  return [
    item("Front", "view-front"),
    item("Back", "view-back"),
    item("Right", "view-right"),
    item("Left", "view-left"),
    item("Top", "view-top"),
    item("Bottom", "view-bottom"),
    item(useView.getState().viewName === "Perspective" ? "Parallel" : "Perspective", "view-perspective"),
    RULE,
    item("Frame the selection", "frame"),
    item("Frame all", "frame-all"),
    RULE,
    { kind: "item", label: "Annotations", checked: useView.getState().annotations, run: () => run("annotations") },
    {
      kind: "item",
      label: "Dimensions",
      keys: keyOf("dimensions"),
      checked: useView.getState().dimensions,
      run: () => run("dimensions"),
    },
    {
      kind: "item",
      label: "Construction lines",
      checked: useView.getState().constructionShown,
      why: whyNot("construction-shown"),
      run: () => run("construction-shown"),
    },
    {
      kind: "menu",
      label: "Theme",
      items: [themed("system", "As the system"), themed("dark", "Dark"), themed("light", "Light")],
    },
    { kind: "menu", label: "Lengths", items: [unit("mm", "Millimetres"), unit("inch", "Inches")] },
  ];
}

const help = (): MenuItem[] => [
  item("Keys", "keys"),
  item("First steps", "hints"),
  RULE,
  item("About WireBend-kit", "about"),
];

export const menus = [
  { label: "File", items: file },
  { label: "Edit", items: editing },
  { label: "View", items: viewing },
  { label: "Help", items: help },
];
