import { create } from "zustand";
import type { DesignInput } from "../../generated/requests";
import type { DesignOpened, LookResponse, RecentEntry, Started, Unsaved, ViewChange } from "../../generated/responses";
import { type FileKind, platform } from "../../platform";
import { errorText } from "../../platform/error_text";
import { tell, told } from "../asking/problems";
import { asking } from "../asking/work";
import {
  applyChange,
  checkDesign,
  type DesignStore,
  edit,
  ofDesign,
  showDesign,
  useDesign,
  whyNoChange,
} from "../design/design";
import { select } from "../design/selection";
import { inTurn, replacingDesign, settled } from "../design/turns";
import { loadRunFile, openRunFile } from "../program/run_file";
import { useUi } from "../window/ui";
import { chooseStencil, chooseTool, useView } from "../window/view";
import { useExports } from "./exports";

/** What a file is opened for: as the design, or as the surface that is traced on. */
export type Purpose = "design" | "stencil" | "add";

/** A file that was looked into, and what is still open about it. */
/** What becomes of a program or of recorded moves. */
export type RunUse = "run" | "design";

export interface Opening {
  readonly path: string;
  readonly purpose: Purpose;
  readonly look: LookResponse;
  /** What is chosen first of a program or of recorded moves; run where nothing is said. */
  readonly use?: RunUse;
}

interface FilesStore {
  readonly version: string;
  readonly recent: readonly RecentEntry[];
  /** Designs that were open when the program or the computer stopped; empty once a person has chosen. */
  readonly unsaved: readonly Unsaved[];
  readonly opening: Opening | null;
  /** A changed design is about to be replaced: what the person says. */
  readonly leaving: ((say: "save" | "drop" | "stay") => void) | null;
  /** What is being read. */
  readonly busy: string | null;
  /** Whether something is dragged over the window. */
  readonly over: boolean;
  /** How many designs were opened: changes with each. */
  readonly opened: number;
}

export const useFiles = create<FilesStore>()(() => ({
  version: "",
  recent: [],
  unsaved: [],
  opening: null,
  leaving: null,
  busy: null,
  over: false,
  opened: 0,
}));

const MODELS: FileKind = { name: "Models", extensions: ["stl", "obj", "ply", "3mf", "glb", "gltf"] };
const DESIGNS: FileKind = { name: "WireBend documents", extensions: ["wirebend"] };
const DRAWINGS: FileKind = { name: "Drawings", extensions: ["svg", "dxf"] };
const TABLES: FileKind = {
  name: "Tables and programs",
  extensions: ["xyz", "csv", "tsv", "txt", "lra", "ybc", "pwf", "dsw", "diw", "json"],
};
const RUNS: FileKind = { name: "Jobs and recorded moves", extensions: ["wbjob", "wbmoves"] };
const ALL: FileKind = {
  name: "Everything that can be opened",
  extensions: [DESIGNS, MODELS, DRAWINGS, TABLES, RUNS].flatMap(({ extensions }) => extensions),
};

/** What a file of the design is called, without the folder and the extension of what it was read from. */
export function designStem(): string {
  const name = useDesign.getState().state?.name || "design";
  const extension = ALL.extensions.find((known) => name.toLowerCase().endsWith(`.${known}`));
  return extension ? name.slice(0, -extension.length - 1) || name : name;
}

export const baseName = (path: string): string => path.split(/[\\/]/).at(-1) ?? path;

/** Shows what the program has open. */
export async function start(): Promise<void> {
  await replacingDesign(async () => {
    const started = await told(platform.ask("start", {}));
    if (!started) return;
    const { version, recent, unsaved, design, warnings } = started;
    useFiles.setState({ version, recent, unsaved });
    for (const warning of warnings) tell("warning", errorText(warning), "start");
    await showDesign(design, []);
    await loadRunFile();
  });
  checkDesign();
}

/** Asks whether a changed design is saved. One question at a time: the one before is answered by staying. */
async function askLeaving(): Promise<"save" | "drop" | "stay"> {
  useFiles.getState().leaving?.("stay");
  let mine: FilesStore["leaving"] = null;
  const say = await new Promise<"save" | "drop" | "stay">((answer) => {
    mine = answer;
    useFiles.setState({ leaving: answer });
  });
  if (useFiles.getState().leaving === mine) useFiles.setState({ leaving: null });
  return say;
}

/** Whether something would be lost that a person has made: a machine that was chosen for an empty design is chosen again. */
function wouldLose(): boolean {
  const { state, vertices } = useDesign.getState();
  if (!state?.changed) return false;
  const { file, notes, stencils, construction_mm } = state;
  return file !== null || vertices.size > 0 || stencils.length > 0 || construction_mm.length > 0 || notes !== "";
}

/** True when the design may be replaced: it is saved, or the person gives it up. */
export async function mayLeave(): Promise<boolean> {
  for (;;) {
    // What is still on its way may be a change, also one that was made while it was saved.
    await settled();
    if (!wouldLose()) return true;
    const say = await askLeaving();
    if (say === "drop") return true;
    if (say === "stay" || !(await save())) return false;
  }
}

/** Shows that a file is being read; of several the last. */
async function reading<T>(name: string, does: () => Promise<T>): Promise<T> {
  useFiles.setState({ busy: name });
  try {
    return await does();
  } finally {
    useFiles.setState(({ busy }) => ({ busy: busy === name ? null : busy }));
  }
}

/** Puts another design in the place of the open one. It is asked for when everything before is done. */
async function opened(ask: () => Promise<DesignOpened>, name: string): Promise<boolean> {
  const done = await reading(name, () =>
    replacingDesign(async () => {
      const answer = await told(ask());
      if (!answer) return false;
      useFiles.setState(({ opened }) => ({ recent: answer.recent, opened: opened + 1 }));
      await showDesign(answer.design, answer.notes);
      return true;
    }),
  );
  checkDesign();
  return done;
}

/** How many files were looked into to be opened as designs. */
let looks = 0;

/**
 * Opens a file, or asks first how it is to be read. Of several designs that are opened at a time it is the last, however long another one
 * takes. What comes into a design comes into the one that it was picked for.
 */
export async function openPath(path: string, purpose: Purpose = "design", use: RunUse = "run"): Promise<void> {
  if (purpose === "design") looks += 1;
  const mine = looks;
  const look = await reading(baseName(path), () => told(asking("look", { design: { input: { file: path } } })));
  if (!look) return;
  if (mine !== looks) {
    if (purpose !== "design")
      tell("warning", `${baseName(path)} was not added: another design was opened meanwhile.`, "not-added");
    return;
  }
  if (look.seen === "job") {
    if (purpose === "design") await runFile(path);
    else if (purpose === "add")
      tell("error", `${baseName(path)} is a job: add the design that it was planned from.`, "is-a-job");
    else tell("error", `${baseName(path)} is a job, which has no surface to trace on.`, "is-a-job");
  } else if (needsAnswers(look, purpose)) {
    useFiles.setState({ opening: { path, purpose, look, use } });
  } else if (purpose === "add") {
    await reading(baseName(path), () => putInto("put-wireframe", { input: { file: path } }));
  } else if (await mayLeave()) {
    await opened(() => asking("open", { design: { input: { file: path } } }), baseName(path));
  }
}

/** Opens a file to be run: a job, a program of the machine's own format, or recorded moves. */
export async function runFile(path: string): Promise<boolean> {
  const opened = await reading(baseName(path), () => openRunFile(path));
  if (!opened) return false;
  useFiles.setState({ opening: null });
  useUi.getState().showSection("run");
  return true;
}

/** Picks a file to be run. */
export async function pickRunFile(): Promise<void> {
  const kinds = [{ name: "Jobs, programs and recorded moves", extensions: [...RUNS.extensions, "txt"] }, RUNS];
  const path = await told(platform.pickFile(kinds));
  if (path) await runFile(path);
}

/** Whether a person has to say how a file is read: its unit, or what becomes of its surface. */
function needsAnswers(
  { seen, runs, asks_units, format }: Pick<LookResponse, "seen" | "runs" | "asks_units" | "format">,
  purpose: Purpose,
): boolean {
  if (seen === "document") return purpose === "stencil";
  if (runs || seen === "moves") return true;
  return purpose === "stencil" || seen === "stencil" || seen === "both" || asks_units || isDrawing(format);
}

/** Formats that have layers, and curves that become straight edges. */
export function isDrawing(format: string): boolean {
  return format === "dxf" || format === "svg";
}

/** What becomes of a surface. */
export type Use = "stencil" | "edges" | "both";

/** Whether there is something that a stencil would come to: a wire, or another stencil. */
export const isBegun = ({ vertices, state }: Pick<DesignStore, "vertices" | "state">): boolean =>
  vertices.size > 0 || (state?.stencils.length ?? 0) > 0 || (state?.construction_mm.length ?? 0) > 0;

/** Adds the wireframe of what was looked into to the design that is open; false where it came to nothing, and the question stays. */
export async function addWireframe(design: DesignInput): Promise<boolean> {
  const { opening } = useFiles.getState();
  return reading(opening ? baseName(opening.path) : "", () => putInto("put-wireframe", design));
}

/** Opens what was looked into as the person says; false where it came to nothing, and the question stays. */
export async function openAs(design: DesignInput, use: Use | null): Promise<boolean> {
  const { opening } = useFiles.getState();
  const name = opening ? baseName(opening.path) : "";
  if (use === "stencil" && isBegun(useDesign.getState())) {
    // What is there is kept: the surface comes beside it.
    return reading(name, () => putInto("put-stencil", design));
  }
  if (!(await mayLeave())) return false;
  const done = await opened(
    () => asking("open", { design: { ...design, face_edges: use === "edges" || use === "both" } }),
    name,
  );
  if (!done) return false;
  useFiles.setState({ opening: null });
  if (use === "edges") {
    for (const { id } of useDesign.getState().state?.stencils ?? [])
      await edit({ edit: "remove-stencil", stencil: id });
  }
  return true;
}

/** Selects what a change has added, to be moved: it seldom lies where it is wanted. The tool stays for a stencil, which may be traced as it lies. */
function takeInHand(before: DesignStore, { vertices, edges, state }: ViewChange): void {
  const stencil = state.stencils.find(({ id }) => !before.state?.stencils.some((other) => other.id === id));
  if (stencil) {
    chooseStencil(stencil.id);
    return;
  }
  chooseTool("select");
  select(
    vertices.filter(({ id }) => !before.vertices.has(id)).map(({ id }) => id),
    edges.filter(({ id }) => !before.edges.has(id)).map(({ id }) => id),
  );
}

/** Changes that are made while the file is read wait for it. */
function putInto(ask: "put-stencil" | "put-wireframe", design: DesignInput): Promise<boolean> {
  return inTurn(async () => {
    const made = await told(asking(ask, { design }));
    if (!made?.change) return false;
    useFiles.setState({ opening: null });
    const before = useDesign.getState();
    useDesign.setState({ notes: made.notes });
    await applyChange(made.change);
    takeInHand(before, made.change);
    useView.getState().handle?.frame();
    return true;
  });
}

export async function pickDesign(): Promise<void> {
  const path = await told(platform.pickFile([ALL, DESIGNS, MODELS, DRAWINGS, TABLES, RUNS]));
  if (path) await openPath(path);
}

/** Picks a file whose wireframe, or surface, comes into the design that is open. */
export async function pickAddition(): Promise<void> {
  const path = await told(platform.pickFile([ALL, DESIGNS, MODELS, DRAWINGS, TABLES]));
  if (path) await openPath(path, "add");
}

export async function pickStencil(): Promise<void> {
  const path = await told(platform.pickFile([MODELS]));
  if (path) await openPath(path, "stencil");
}

export async function newDesign(): Promise<boolean> {
  return (await mayLeave()) && opened(() => asking("new", {}), "new design");
}

export async function openExample(id: string, name: string): Promise<boolean> {
  return (await mayLeave()) && opened(() => asking("open-example", { id }), name);
}

/** Saves where it was saved before, or where the person says; false where it is not saved. */
export async function save(): Promise<boolean> {
  const { state } = useDesign.getState();
  return state?.file ? saveTo(null) : saveAs();
}

export async function saveAs(): Promise<boolean> {
  const path = await pickPlace(`${designStem()}.wirebend`, DESIGNS);
  return path !== null && saveTo(path);
}

/** Picks where something of the open design is saved. The window goes on behind the dialog: null, and said so, where another one was opened. */
export async function pickPlace(name: string, kind: FileKind): Promise<string | null> {
  const { opened: design } = useFiles.getState();
  const path = await told(platform.pickSave(name, kind));
  if (!path) return null;
  if (design === useFiles.getState().opened) return path;
  tell("warning", "Not saved: another design was opened meanwhile.", "not-saved");
  return null;
}

async function saveTo(path: string | null): Promise<boolean> {
  const why = whyNoChange();
  if (why) {
    tell("info", `${why} Nothing was saved: another design is being opened.`, "being-read");
    return false;
  }
  return inTurn(async () => {
    const answer = await told(platform.ask("save", { path }));
    if (!answer) return false;
    useFiles.setState({ recent: answer.recent });
    // Only name, file and what is saved have changed; the vertices and edges that are shown stay.
    useDesign.setState({ state: answer.design.state });
    return true;
  });
}

export async function restore(journal: string): Promise<void> {
  if (!(await mayLeave()) || !(await opened(() => asking("restore", { journal }), "unsaved design"))) return;
  useFiles.setState(({ unsaved }) => ({ unsaved: unsaved.filter((other) => other.journal !== journal) }));
}

function took(started: Started | null): void {
  if (started) useFiles.setState({ unsaved: started.unsaved, recent: started.recent });
}

export async function discard(journal: string): Promise<void> {
  took(await told(platform.ask("discard", { journal })));
}

export async function clearRecent(): Promise<void> {
  const started = await told(platform.ask("clear-recent", {}));
  if (started) useFiles.setState({ recent: started.recent });
}

/** The design is given up or saved: nothing of it is kept for the next time. An empty one takes its place. */
export async function closeDesign(): Promise<void> {
  await opened(() => platform.ask("close", {}), "new design");
}

/** Plans the design and writes it as a job; a design that cannot be made is refused, with the reason. */
export async function saveJob(): Promise<void> {
  const path = await pickPlace(`${designStem()}.wbjob`, { name: "Jobs", extensions: ["wbjob"] });
  if (!path) return;
  const { despiteErrors } = useExports.getState();
  const asked = asking("save-job", { output: { path, force: true }, despite_errors: despiteErrors });
  const saved = await told(ofDesign(asked));
  if (!saved) return;
  tell("info", `The job is in ${saved.file}.`, "job-saved");
  for (const note of saved.notes) tell("warning", errorText(note), note.code);
}

/** Writes the wires as lines for another program. */
export async function saveWireframe(): Promise<void> {
  const path = await pickPlace(`${designStem()}.obj`, { name: "Models", extensions: ["obj"] });
  if (!path) return;
  const saved = await told(asking("save-wireframe", { output: { path, force: true } }));
  if (saved) tell("info", `The wireframe is in ${saved.file}.`, "wireframe-saved");
}
