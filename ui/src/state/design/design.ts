import { create } from "zustand";
import type { EditRequest } from "../../generated/requests";
import type { DesignView, EditMade, LiveCheck, NoteReport, ViewChange } from "../../generated/responses";
import { platform } from "../../platform";
import type { Moved, SceneDesign, SceneEdge, SceneStencil, SceneVertex } from "../../scene/interface";
import { tell, told } from "../asking/problems";
import { inTurn, isBeingReplaced } from "./turns";

/** All of the design but vertices, edges and the stencil. */
export type DesignState = DesignView["state"];

/** The open design as the window has it: a copy of what the Rust side has. */
export interface DesignStore extends SceneDesign {
  readonly state: DesignState | null;
  readonly stencil: SceneStencil | null;
  /** What the checks say of it as it is, or of where it is dragged to. Null before the first answer, or without a machine. */
  readonly check: LiveCheck | null;
  /** What was merged, ignored or assumed while the file was read. */
  readonly notes: readonly NoteReport[];
}

export const useDesign = create<DesignStore>()(() => ({
  vertices: new Map<number, SceneVertex>(),
  edges: new Map<number, SceneEdge>(),
  state: null,
  stencil: null,
  check: null,
  notes: [],
}));

/** How many designs were shown: what was asked of one is no answer for another. */
let shown = 0;

/** Shows a design that was opened. It is called in its turn, see `turns.ts`; the caller has it checked afterwards. */
export async function showDesign(view: DesignView, notes: readonly NoteReport[]): Promise<void> {
  const vertices = new Map(view.vertices.map(({ id, at_mm, support }) => [id, { id, at: at_mm, support }] as const));
  const edges = new Map(view.edges.map((edge) => [edge.id, edge] as const));
  shown += 1;
  useDesign.setState({ vertices, edges, state: view.state, notes, check: null, stencil: null });
  // What was dragged was of the design before.
  wanted = null;
  if (view.stencil) await readStencil();
}

/** Brings the copy up to date with a change; what is not named in it stays the same object. It is called in its turn. */
export async function applyChange(change: ViewChange): Promise<void> {
  const { vertices, edges } = useDesign.getState();
  const seen = change.vertices.map(({ id, at_mm, support }) => ({ id, at: at_mm, support }));
  const newVertices = withChanges(vertices, seen, change.gone_vertices);
  const newEdges = withChanges(edges, change.edges, change.gone_edges);
  useDesign.setState({ vertices: newVertices, edges: newEdges, state: change.state });
  if (change.stencil) await readStencil();
  checkDesign();
}

/** The same map where nothing is different: so it is known that a program is still that of the design. */
function withChanges<T extends { readonly id: number }>(
  before: ReadonlyMap<number, T>,
  changed: readonly T[],
  gone: readonly number[],
): ReadonlyMap<number, T> {
  if (changed.length + gone.length === 0) return before;
  const after = new Map(before);
  for (const id of gone) after.delete(id);
  for (const one of changed) after.set(one.id, one);
  return after;
}

async function readStencil(): Promise<void> {
  const bytes = await told(platform.stencilMesh());
  useDesign.setState({ stencil: bytes && stencilOf(bytes) });
}

/** The layout is that of `Workspace::stencil_mesh`. */
function stencilOf(bytes: ArrayBuffer): SceneStencil | null {
  if (bytes.byteLength === 0) return null;
  const [corners = 0, triangles = 0] = new Uint32Array(bytes, 0, 2);
  return {
    positions: new Float32Array(bytes, 8, corners * 3),
    triangles: new Uint32Array(bytes, 8 + corners * 12, triangles * 3),
  };
}

/** Why nothing can be changed just now; null where it can. */
export const whyNoChange = (): string | null => (isBeingReplaced() ? "A file is being read." : null);

/** Makes a change in its turn. While another design is on its way it is not made: it is not meant for that one. */
async function changed(ask: () => Promise<EditMade>): Promise<ViewChange | null> {
  const why = whyNoChange();
  if (why) {
    tell("info", `${why} Nothing was changed: another design is being opened.`, "being-read");
    return null;
  }
  return inTurn(async () => {
    const made = await told(ask());
    if (!made?.change) return null;
    await applyChange(made.change);
    return made.change;
  });
}

/** Makes a change; null where it was refused, which the person has been shown. */
export function edit(request: EditRequest): Promise<ViewChange | null> {
  return changed(() => platform.ask("edit", { request }));
}

export async function undo(): Promise<void> {
  await changed(() => platform.ask("undo", {}));
}

export async function redo(): Promise<void> {
  await changed(() => platform.ask("redo", {}));
}

let checking = false;
let wanted: readonly Moved[] | null = null;
let answered: Promise<void> = Promise.resolve();

/**
 * Asks for the checks, with some vertices elsewhere while they are dragged. One question is on its way at a time; of those
 * that come meanwhile only the last is asked.
 */
export function checkDesign(moved: readonly Moved[] = []): void {
  // No checks while the design is being replaced: whoever replaces it asks for those of the new one.
  if (isBeingReplaced()) return;
  wanted = moved;
  if (!checking) answered = checkWanted();
}

/** Waits until what was asked of the checks is answered. */
export const checked = (): Promise<void> => answered;

async function checkWanted(): Promise<void> {
  checking = true;
  try {
    while (wanted) {
      const moved = wanted.map(({ vertex, at }) => ({ vertex, at_mm: [...at] as [number, number, number] }));
      wanted = null;
      if (isBeingReplaced()) continue;
      const { state, vertices } = useDesign.getState();
      // Of an empty design there is nothing to say that a person does not see.
      if (!state?.machine || vertices.size === 0) {
        useDesign.setState({ check: null });
        continue;
      }
      const design = shown;
      const isGone = () => design !== shown || isBeingReplaced();
      const asked = platform
        .ask("check", { moved })
        .catch((error: unknown) => (isGone() ? null : Promise.reject(error)));
      const check = await told(asked);
      if (!isGone()) useDesign.setState({ check });
    }
  } finally {
    checking = false;
  }
}
