import { edit, redo, undo, useDesign } from "./design";
import { newDesign, pickDesign, pickStencil, quit, save, saveAs, saveJob } from "./files";
import { showHints } from "./hints";
import type { CommandId } from "./keys";
import * as operations from "./operations";
import { showDesignAgain, togglePlay, usePlayback } from "./program";
import { stop } from "./run";
import { connected, inverted, isEmpty, NOTHING, select, useSelection } from "./selection";
import { type DialogName, type OperationName, useUi } from "./ui";
import { chooseTool, setAnnotations, useView } from "./view";

/** What is done when a key is pressed or a menu or button chosen, and why it cannot be done just now. */
interface Command {
  run(): void;
  why?(): string | null;
}

const NO_SELECTION = "Select vertices or edges first";

const selected = () => (isEmpty(useSelection.getState()) ? NO_SELECTION : null);
const vertices = (least: number, what: string) => () =>
  operations.selectedVertices().length >= least ? null : least === 1 ? NO_SELECTION : `Select at least ${least} vertices to ${what}`;
const edges = (what: string) => () => (operations.selectedEdges().length > 0 ? null : `Select the edges to ${what} first`);
const anything = () => (useDesign.getState().vertices.size > 0 ? null : "There is nothing in the design yet");
const machine = () => (useDesign.getState().state?.machine ? null : "Choose a machine first");
const dialog = (name: DialogName) => () => useUi.getState().showDialog(name);
const operation = (name: OperationName) => () => useUi.getState().showOperation(name);
const view = (name: "front" | "right" | "top") => () => useView.getState().handle?.view(name);

function selectAll(): void {
  const design = useDesign.getState();
  select(design.vertices.keys(), design.edges.keys());
}

function move(): void {
  chooseTool("select");
  useView.getState().handle?.startGrab();
}

/** Ends what is going on: a strand or a move, then a preview, then playing, then the selection. */
function end(): void {
  const { handle, preview } = useView.getState();
  if (handle?.cancel()) return;
  if (preview) useView.setState({ preview: null });
  else if (usePlayback.getState().played && !usePlayback.getState().live) showDesignAgain();
  else if (useView.getState().tool !== "select") chooseTool("select");
  else select([]);
}

function toggleUnits(): void {
  void edit({ edit: "units", units: useDesign.getState().state?.units === "inch" ? "mm" : "inch" });
}

export const COMMANDS: Readonly<Record<CommandId, Command>> = {
  new: { run: () => void newDesign() },
  open: { run: () => void pickDesign() },
  "open-stencil": { run: () => void pickStencil() },
  examples: { run: dialog("examples") },
  save: { run: () => void save() },
  "save-as": { run: () => void saveAs() },
  "save-job": { run: () => void saveJob(), why: () => anything() ?? machine() },
  quit: { run: () => void quit() },
  undo: { run: () => void undo(), why: () => (useDesign.getState().state?.undo ? null : "There is nothing to undo") },
  redo: { run: () => void redo(), why: () => (useDesign.getState().state?.redo ? null : "There is nothing to do again") },
  cut: { run: operations.cut, why: selected },
  copy: { run: operations.copy, why: selected },
  paste: { run: () => void operations.paste() },
  duplicate: { run: () => void operations.duplicate(), why: selected },
  delete: { run: operations.remove, why: selected },
  "select-all": { run: selectAll, why: anything },
  "select-connected": {
    run: () => {
      const all = connected(useSelection.getState(), useDesign.getState());
      select(all.vertices, all.edges);
    },
    why: selected,
  },
  invert: {
    run: () => {
      const others = inverted(useSelection.getState(), useDesign.getState());
      select(others.vertices, others.edges);
    },
    why: anything,
  },
  straighten: { run: operation("straighten"), why: edges("straighten") },
  round: { run: operation("round"), why: edges("round") },
  mirror: { run: operation("mirror"), why: selected },
  array: { run: operation("array"), why: selected },
  scale: { run: operation("scale"), why: () => selected() ?? (operations.largest() ? null : "Select more than one vertex to scale") },
  "tool-select": { run: () => chooseTool("select") },
  "tool-trace": { run: () => chooseTool("trace") },
  "tool-draw": { run: () => chooseTool("draw") },
  move: { run: move, why: selected },
  extrude: { run: () => void operations.extrude(), why: vertices(1, "extrude") },
  split: { run: () => void operations.split(), why: () => (useSelection.getState().edges.size > 0 ? null : "Select the edges to split first") },
  merge: { run: () => void operations.merge(), why: vertices(2, "merge") },
  connect: { run: () => void operations.connect(), why: vertices(2, "connect") },
  "view-front": { run: view("front") },
  "view-right": { run: view("right") },
  "view-top": { run: view("top") },
  "view-perspective": { run: () => useView.getState().handle?.toggleParallel() },
  frame: {
    run: () => {
      const { vertices: some, edges: more } = useSelection.getState();
      const all = isEmpty({ vertices: some, edges: more });
      useView.getState().handle?.frame(all ? undefined : { vertices: some, edges: more });
    },
  },
  "frame-all": { run: () => useView.getState().handle?.frame() },
  annotations: { run: () => setAnnotations(!useView.getState().annotations) },
  units: { run: toggleUnits },
  play: { run: togglePlay, why: () => anything() ?? machine() },
  stop: { run: stop },
  end: { run: end },
  keys: { run: dialog("keys") },
  about: { run: dialog("about") },
  hints: { run: showHints },
};

/** Does it, where it can be done; whether it could. */
export function run(id: CommandId): boolean {
  const command = COMMANDS[id];
  if (command.why?.()) return false;
  command.run();
  return true;
}

export function whyNot(id: CommandId): string | null {
  return COMMANDS[id].why?.() ?? null;
}

/** The same for a component, which is drawn anew when the answer may be another. */
export function useWhyNot(id: CommandId): string | null {
  useDesign();
  useSelection(({ vertices: some }) => some);
  useSelection(({ edges: some }) => some);
  return whyNot(id);
}

/** Forgets what was of the design before. */
export function designReplaced(): void {
  useSelection.setState({ ...NOTHING, highlight: NOTHING });
  useView.setState({ preview: null, strand: null });
}
