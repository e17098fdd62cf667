/** Files of the loaded frame for other programs. */

import { create } from "zustand";
import type { FrameFiles } from "../../generated/requests";
import { type FileKind, Refused } from "../../platform";
import { errorText } from "../../platform/error_text";
import { asking } from "../asking/work";
import { designStem, pickPlace } from "../files/files";
import { movedOf, usualScale } from "./figures";
import { frameRequest, useFrame } from "./frame";
import { useShape } from "./shape";

export type FrameFile = "vtk" | "csv" | "glb" | "conmech";

interface FileSort extends FileKind {
  /** How its name ends. */
  readonly extension: string;
  /** Whether there are two, beside the one that was picked: the dialog of the system has not asked about those. */
  readonly several: boolean;
}

const SORTS: Readonly<Record<FrameFile, FileSort>> = {
  vtk: { name: "VTK, for ParaView", extensions: ["vtk"], extension: "vtk", several: false },
  csv: { name: "Tables", extensions: ["csv"], extension: "csv", several: true },
  glb: { name: "glTF models", extensions: ["glb"], extension: "glb", several: false },
  conmech: { name: "Frames of conmech", extensions: ["json"], extension: "json", several: true },
};

interface FrameFilesStore {
  readonly busy: boolean;
  readonly written: readonly string[];
  /** What is to be known of them. */
  readonly notes: readonly string[];
  /** Why they were not written, and what was to be. */
  readonly problem: { readonly message: string; readonly exists: boolean } | null;
  readonly asked: { readonly file: FrameFile; readonly path: string } | null;
}

const NOTHING: FrameFilesStore = { busy: false, written: [], notes: [], problem: null, asked: null };

export const useFrameFiles = create<FrameFilesStore>()(() => NOTHING);

/** Picks a place, and writes there. */
export async function saveFrame(file: FrameFile): Promise<void> {
  const sort = SORTS[file];
  const path = await pickPlace(`${designStem()}.${sort.extension}`, sort);
  if (path) await write(file, path, !sort.several);
}

/** A person agrees to replace what is there. */
export async function replaceFrameFile(): Promise<void> {
  const { asked } = useFrameFiles.getState();
  if (asked) await write(asked.file, asked.path, true);
}

/** What was written is of another design or of what is not shown any more. */
export function forgetFrameFiles(): void {
  useFrameFiles.setState(NOTHING);
}

/** By how much the view enlarges the loaded frame. */
function shownScale(): number {
  const { view, scale } = useShape.getState();
  const shown = useFrame.getState().answer?.value;
  const moved = shown ? movedOf(shown, { kind: "loaded" }) : null;
  if (!moved) return 1;
  return (view?.kind === "loaded" ? scale : null) ?? usualScale(moved);
}

async function write(file: FrameFile, path: string, force: boolean): Promise<void> {
  useFrameFiles.setState({ ...NOTHING, busy: true, asked: { file, path } });
  const files: FrameFiles = { [file]: { path, force }, displacement_scale: shownScale() };
  try {
    const saved = await asking("save-frame", { frame: frameRequest(useFrame.getState()), files });
    const notes = saved.notes.filter(({ code }) => ABOUT_FILES.has(code)).map(errorText);
    const problem =
      saved.files.length === 0 ? { message: notes[0] ?? "There is nothing to write.", exists: false } : null;
    useFrameFiles.setState({ busy: false, written: saved.files, notes: problem ? [] : notes, problem });
  } catch (error) {
    const exists = error instanceof Refused && error.refusal.code === "exists";
    const message = error instanceof Error ? error.message : String(error);
    useFrameFiles.setState({ busy: false, problem: { message, exists } });
  }
}

/** Notes that are about what is written; the others are said where the design is read. */
const ABOUT_FILES: ReadonlySet<string> = new Set(["not-written", "joints-as-forces", "yield-unknown", "drawn-round"]);
