import type { Vec3 } from "../../scene/interface";
import { linesOf } from "../construction/lines";
import { redo, undo, useDesign, whyNoChange } from "../design/design";
import * as operations from "../design/operations";
import { connected, inverted, isEmpty, NOTHING, select, useSelection } from "../design/selection";
import { isChanging } from "../design/turns";
import { quit } from "../files/closing";
import {
  isBegun,
  newDesign,
  pickAddition,
  pickDesign,
  pickStencil,
  save,
  saveAs,
  saveJob,
  saveWireframe,
  useFiles,
} from "../files/files";
import { setPicking, useFrame } from "../frame/frame";
import { showFrame, useShape } from "../frame/shape";
import { useMachines } from "../machine/machines";
import { isInWire } from "../machine/operator";
import { pauseByKey, stop, useRun } from "../machine/run";
import { shownDesign } from "../parts/parts";
import { showDesignAgain, togglePlay, usePlayback, useProgram, whyNoProgram } from "../program/program";
import { useRunFile } from "../program/run_file";
import { hideSequence, togglePlaySequence, useSequence } from "../sequence/sequence";
import { showHints } from "./hints";
import type { CommandId } from "./keys";
import { type DialogName, type OperationName, useUi } from "./ui";
import { useUnits } from "./units";
import {
  choosePlane,
  chooseStencil,
  chooseTool,
  drawnPlane,
  FACING,
  normalOf,
  planeOf,
  type Side,
  setAnnotations,
  setConstructing,
  setConstructionShown,
  setDimensions,
  shownLines,
  useView,
} from "./view";

/** What is done when a key is pressed or a menu or button chosen, and why it cannot be done just now: a sentence. */
interface Command {
  run(): void;
  why?(): string | null;
}

const NO_SELECTION = "Select vertices or edges first.";

const selected = () => (isEmpty(useSelection.getState()) ? NO_SELECTION : null);
/** Construction lines have no place on the clipboard. */
const wire = () => (operations.selectedVertices().length > 0 ? null : NO_SELECTION);
const vertices = (least: number, what: string) => () =>
  operations.selectedVertices().length >= least
    ? null
    : least === 1
      ? NO_SELECTION
      : `Select at least ${least} vertices to ${what}.`;
const edges = (what: string) => () =>
  operations.selectedEdges().length > 0 ? null : `Select the edges to ${what} first.`;
const anything = () => (useDesign.getState().vertices.size > 0 ? null : "The design is empty.");
const lines = () => (linesOf(useDesign.getState().state).length > 0 ? null : "There are no construction lines.");
const something = () => (shownLines().length > 0 ? null : anything());

const bends = (): boolean => {
  const { state } = useRun.getState();
  return state !== null && isInWire(state.phase);
};

/** Whether there is something to play: a design with a machine, or a file that is run. */
const playable = () => (useRunFile.getState().file ? null : (anything() ?? machine())) ?? whyNoProgram();
const machine = () => (useDesign.getState().state?.machine ? null : "Choose a machine first.");
const dialog = (name: DialogName) => () => useUi.getState().showDialog(name);
const operation = (name: OperationName) => () => useUi.getState().showOperation(name);
/** The same with the focus in its first figure, which is typed next. */
const figure = (name: OperationName) => () => {
  operation(name)();
  requestAnimationFrame(() =>
    document.querySelector<HTMLInputElement>(`#operation-${name} .number-field input`)?.focus(),
  );
};
/** The sine of 8°: a plane that is seen so nearly from its edge cannot be drawn on. */
const EDGE_ON = 0.14;

const isEdgeOn = (normal: Vec3, from: Vec3): boolean =>
  Math.abs(normal[0] * from[0] + normal[1] * from[1] + normal[2] * from[2]) < EDGE_ON * Math.hypot(...from);

/** Whether the plane that is drawn on would be seen from its edge. */
const hidesPlane = (from: Vec3): boolean => {
  const now = useView.getState();
  return now.tool === "draw" && isEdgeOn(normalOf(drawnPlane(now)), from);
};

/** Whether the view from a side goes with another plane than the one that is drawn on. */
function changesPlane(side: Side): boolean {
  const now = useView.getState();
  if (now.tool !== "draw" || now.ownPlane) return hidesPlane(normalOf(planeOf(FACING[side], 0)));
  return now.plane !== FACING[side];
}

/** Looks from a side. The plane that is drawn on goes with the view, which never shows it from its edge. */
function view(side: Side): Command {
  return {
    run: () => {
      useView.getState().handle?.view(side);
      if (changesPlane(side)) choosePlane(FACING[side]);
    },
    why: () =>
      changesPlane(side) && useView.getState().strand !== null
        ? "The plane would be seen from its edge: end the strand first, with Esc."
        : null,
  };
}

/** The same so that it is seen how the view turns; at once where the plane goes with it, which is faced at once. */
export function flyTo(side: Side): void {
  if (changesPlane(side)) run(`view-${side}`);
  else useView.getState().handle?.fly(side);
}

/** Why the view cannot look from where a direction points: a sentence. */
export const whyNotFrom = (direction: Vec3): string | null =>
  hidesPlane(direction) ? "The plane that is drawn on would be seen from its edge." : null;

function selectAll(): void {
  const design = shownDesign(useDesign.getState());
  select(design.vertices.keys(), design.edges.keys(), shownLines().keys());
}

function move(): void {
  chooseTool("select");
  useView.getState().handle?.startGrab();
}

/** Ends what is under way: a strand or a move, then a preview, then what is shown instead of the design, then the selection. */
function end(): void {
  const { handle, preview } = useView.getState();
  if (handle?.cancel()) return;
  if (preview) useView.setState({ preview: null });
  else if (usePlayback.getState().played && !usePlayback.getState().live) showDesignAgain();
  else if (useFrame.getState().picking) setPicking(false);
  else if (useShape.getState().view) showFrame(null);
  else if (useSequence.getState().shown) hideSequence();
  else if (useView.getState().tool !== "select") chooseTool("select");
  else if (isEmpty(useSelection.getState())) chooseStencil(null);
  else select([]);
}

/** What is shown, and no change of the design. */
function toggleUnits(): void {
  useUi.getState().setUnit(useUnits.getState().unit === "inch" ? "mm" : "inch");
}

/** A change of the design: not while the view shows how a machine bends it, nor while another one is being read. */
function change(run: () => void, why?: () => string | null): Command {
  return {
    run,
    why: () =>
      (usePlayback.getState().live ? "A machine is bending the wire." : null) ?? whyNoChange() ?? why?.() ?? null,
  };
}

const COMMANDS: Readonly<Record<CommandId, Command>> = {
  new: { run: () => void newDesign() },
  open: { run: () => void pickDesign() },
  add: change(
    () => void pickAddition(),
    () => (isBegun(useDesign.getState()) ? null : "There is no design yet: open the file."),
  ),
  "open-stencil": { run: () => void pickStencil() },
  examples: { run: dialog("examples") },
  save: { run: () => void save() },
  "save-as": { run: () => void saveAs() },
  "save-wireframe": { run: () => void saveWireframe(), why: anything },
  "save-job": { run: () => void saveJob(), why: () => anything() ?? machine() },
  quit: { run: () => void quit() },
  undo: change(
    () => void undo(),
    // A change that is on its way can be taken back as soon as it is made.
    () => (useDesign.getState().state?.undo || isChanging() ? null : "There is nothing to undo."),
  ),
  redo: change(
    () => void redo(),
    () => (useDesign.getState().state?.redo || isChanging() ? null : "There is nothing to redo."),
  ),
  cut: change(operations.cut, wire),
  copy: { run: operations.copy, why: wire },
  paste: change(() => void operations.paste()),
  duplicate: change(() => void operations.duplicate(), wire),
  delete: change(operations.remove, selected),
  "select-all": { run: selectAll, why: something },
  "select-connected": {
    run: () => {
      const selection = useSelection.getState();
      const all = connected(selection, useDesign.getState());
      select(all.vertices, all.edges, selection.lines);
    },
    why: selected,
  },
  invert: {
    run: () => {
      const selection = useSelection.getState();
      const others = inverted(selection, shownDesign(useDesign.getState()));
      const lines = [...shownLines().keys()].filter((place) => !selection.lines.has(place));
      select(others.vertices, others.edges, lines);
    },
    why: something,
  },
  straighten: change(operation("straighten"), edges("straighten")),
  round: change(operation("round"), edges("round")),
  fillet: change(
    figure("fillet"),
    () => selected() ?? (operations.selectedCorners().length > 0 ? null : "Select corners: vertices with two edges."),
  ),
  rotate: change(figure("rotate"), selected),
  mirror: change(operation("mirror"), selected),
  array: change(operation("array"), selected),
  scale: change(
    operation("scale"),
    () =>
      selected() ?? (operations.largest() ? null : "Select more than one vertex, or a construction line, to scale."),
  ),
  "tool-select": { run: () => chooseTool("select") },
  "tool-trace": { run: () => chooseTool("trace") },
  "tool-draw": { run: () => chooseTool("draw") },
  "tool-measure": { run: () => chooseTool("measure") },
  move: change(move, selected),
  extrude: change(() => void operations.extrude(), vertices(1, "extrude")),
  split: change(
    () => void operations.split(),
    () => (useSelection.getState().edges.size > 0 ? null : "Select the edges to split first."),
  ),
  merge: change(() => void operations.merge(), vertices(2, "merge")),
  construction: change(
    () => void operations.toConstruction(),
    () => (useSelection.getState().lines.size > 0 ? null : edges("make construction lines of")()),
  ),
  "draw-construction": { run: () => setConstructing(!useView.getState().constructing) },
  connect: change(() => void operations.connect(), vertices(2, "connect")),
  "view-front": view("front"),
  "view-back": view("back"),
  "view-right": view("right"),
  "view-left": view("left"),
  "view-top": view("top"),
  "view-bottom": view("bottom"),
  "view-perspective": { run: () => useView.getState().handle?.toggleParallel() },
  frame: {
    run: () => {
      const selection = useSelection.getState();
      useView.getState().handle?.frame(isEmpty(selection) ? undefined : selection);
    },
  },
  "frame-all": { run: () => useView.getState().handle?.frame() },
  annotations: { run: () => setAnnotations(!useView.getState().annotations) },
  dimensions: { run: () => setDimensions(!useView.getState().dimensions) },
  "construction-shown": { run: () => setConstructionShown(!useView.getState().constructionShown), why: lines },
  units: { run: toggleUnits },
  play: {
    run: () => {
      if (bends()) pauseByKey();
      else if (useSequence.getState().shown) togglePlaySequence();
      else togglePlay();
    },
    why: () => (useSequence.getState().shown || bends() ? null : playable()),
  },
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
  useSelection(({ lines: some }) => some);
  usePlayback(({ live }) => live);
  useProgram(({ basis }) => basis);
  useMachines(({ changes }) => changes);
  useRunFile(({ file }) => file);
  useFiles(({ busy }) => busy);
  useView(({ tool }) => tool);
  useView(({ plane }) => plane);
  useView(({ strand }) => strand);
  return whyNot(id);
}

/** Forgets what was of the design before, also what is being drawn or moved. */
export function designReplaced(): void {
  useView.getState().handle?.cancel();
  useSelection.setState({ ...NOTHING, highlight: NOTHING });
  useView.setState({
    preview: null,
    strand: null,
    ownPlane: null,
    planeOffset: 0,
    chosenStencil: null,
    constructing: false,
    constructionShown: true,
  });
}
