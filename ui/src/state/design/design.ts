import { create } from "zustand";
import type { EditRequest } from "../../generated/requests";
import type {
  Collisions,
  DesignView,
  DiagnosticReport,
  EditMade,
  LiveCheck,
  NoteReport,
  ViewChange,
} from "../../generated/responses";
import { platform, Refused } from "../../platform";
import type { Moved, SceneDesign, SceneEdge, SceneSurface, SceneVertex } from "../../scene/interface";
import { dismissAll, tell, told } from "../asking/problems";
import { inTurn, isBeingReplaced } from "./turns";

/** All of the design but vertices, edges and surfaces. */
export type DesignState = DesignView["state"];

/** The open design as the window has it: a copy of what the Rust side has. */
export interface DesignStore extends SceneDesign {
  readonly state: DesignState | null;
  /** Of the stencils of `state`, by id. */
  readonly surfaces: ReadonlyMap<number, SceneSurface>;
  /** What the checks say of it as it is, or of where it is dragged to, collisions included as far as they are known. Null before the first answer, or without a machine. */
  readonly check: LiveCheck | null;
  /** The same without collisions, and which vertices were dragged for it. */
  readonly limits: LiveCheck | null;
  readonly dragged: readonly Moved[];
  /** The collisions that are shown; null where they are not known. */
  readonly collisions: CollisionsOf | null;
  /** How often the design was changed or another one opened. */
  readonly version: number;
  /** The version that was refused since it cannot be bent: whoever is asked to write or bend it looks for collisions too. */
  readonly refused: number | null;
  /** What was merged, ignored or assumed while the file was read. */
  readonly notes: readonly NoteReport[];
}

const UNCHECKED = { check: null, limits: null, dragged: [], collisions: null } as const;

/** Where the wires hit the machine or themselves, and in which version of the design, with which profiles. */
export interface CollisionsOf {
  readonly found: Collisions;
  readonly version: number;
  /** How often profiles were changed by then. */
  readonly profiles: number;
  /** Whether vertices were being dragged. */
  readonly dragged: boolean;
}

export const useDesign = create<DesignStore>()(() => ({
  vertices: new Map<number, SceneVertex>(),
  edges: new Map<number, SceneEdge>(),
  state: null,
  surfaces: new Map<number, SceneSurface>(),
  ...UNCHECKED,
  version: 0,
  refused: null,
  notes: [],
}));

/** Whether the design as it is cannot be bent, by the checks or by whoever was asked to write or bend it. */
export const isRefused = ({ check, version, refused }: DesignStore): boolean =>
  check?.feasible === false || refused === version;

/** What decides how the wires of a design run, beside its edges, wherever they may hit something: the same text where it is the same. */
export function wiresOf(state: DesignState | null): string {
  const { machine, material, doublings, start, wires, closed, reversed, walks } = state ?? {};
  return JSON.stringify([machine, material, doublings, start, wires, closed, reversed, walks]);
}

/** The same with what is to be said of what they hit. */
export const choicesOf = (state: DesignState | null): string =>
  wiresOf(state) + JSON.stringify(state?.collisions ?? null);

/** How often refusals were forgotten. */
let forgotten = 0;

/** What was refused with another profile need not be with this one. */
export function forgetRefusal(): void {
  forgotten += 1;
  useDesign.setState({ refused: null });
}

/** Waits for what is asked of the open design, and keeps it where the design is refused: checks that were stopped do not know. */
export async function ofDesign<T>(asked: Promise<T>): Promise<T> {
  const { version } = useDesign.getState();
  const before = forgotten;
  try {
    return await asked;
  } catch (error) {
    const isRefusal = error instanceof Refused && error.refusal.code === "not-feasible";
    if (isRefusal && before === forgotten) useDesign.setState({ refused: version });
    throw error;
  }
}

/** How many designs were shown: what was asked of one is no answer for another. */
let shown = 0;

/** A vertex as the scene has it. */
function seen({ id, at_mm, support, joint }: DesignView["vertices"][number]): SceneVertex {
  return { id, at: at_mm, support, ...(joint ? { joint } : {}) };
}

/** Shows a design that was opened. It is called in its turn, see `turns.ts`; the caller has it checked afterwards. */
export async function showDesign(view: DesignView, notes: readonly NoteReport[]): Promise<void> {
  const vertices = new Map(view.vertices.map((vertex) => [vertex.id, seen(vertex)] as const));
  const edges = new Map(view.edges.map((edge) => [edge.id, edge] as const));
  shown += 1;
  const version = useDesign.getState().version + 1;
  useDesign.setState({ vertices, edges, state: view.state, notes, surfaces: new Map(), version, ...UNCHECKED });
  // What was dragged was of the design before.
  wanted = null;
  await readSurfaces();
}

/** Brings the copy up to date with a change; what is not named in it stays the same object. It is called in its turn. */
export async function applyChange(change: ViewChange): Promise<void> {
  const { vertices, edges, version } = useDesign.getState();
  const newVertices = withChanges(vertices, change.vertices.map(seen), change.gone_vertices);
  const newEdges = withChanges(edges, change.edges, change.gone_edges);
  useDesign.setState({ vertices: newVertices, edges: newEdges, state: change.state, version: version + 1 });
  await readSurfaces();
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

/** Reads the surfaces that are new, and forgets those that are gone: an id that comes back may be another surface. */
async function readSurfaces(): Promise<void> {
  const { state, surfaces } = useDesign.getState();
  const there = state?.stencils.filter(({ surface }) => surface !== null) ?? [];
  if (there.length === surfaces.size && there.every(({ id }) => surfaces.has(id))) return;
  const read = new Map<number, SceneSurface>();
  for (const { id } of there) {
    const known = surfaces.get(id);
    const surface = known ?? (await told(platform.stencilMesh(id).then(surfaceOf)));
    if (surface) read.set(id, surface);
  }
  useDesign.setState({ surfaces: read });
}

/** The layout is that of `Workspace::stencil_mesh`. */
function surfaceOf(bytes: ArrayBuffer): SceneSurface | null {
  if (bytes.byteLength === 0) return null;
  const [corners = 0, triangles = 0] = new Uint32Array(bytes, 0, 2);
  return {
    positions: new Float32Array(bytes, 8, corners * 3),
    triangles: new Uint32Array(bytes, 8 + corners * 12, triangles * 3),
  };
}

/** Why nothing can be changed just now; null where it can. */
export const whyNoChange = (): string | null => (isBeingReplaced() ? "A file is being read." : null);

const GIVEN_UP = "order-given-up";

/** An order of the bends may have been searched for long: says where an edit of something else has given it up. */
function tellGivenUp(before: DesignState | null, after: DesignState): void {
  const wires = before?.walks.length ?? 0;
  if (wires === 0 || after.walks.length > 0) return;
  const what =
    wires === 1
      ? "The chosen order of the bends is given up: it was for the route before. Undo brings it back."
      : `The chosen orders of the bends of ${wires} wires are given up: they were for the routes before. Undo brings them back.`;
  tell("info", what, GIVEN_UP);
}

/**
 * Makes a change in its turn, and says what it has given up unless that is what was asked for. While another design is on its way it is
 * not made: it is not meant for that one.
 */
async function changed(ask: () => Promise<EditMade>, tellsGivenUp = true): Promise<ViewChange | null> {
  const why = whyNoChange();
  if (why) {
    tell("info", `${why} Nothing was changed: another design is being opened.`, "being-read");
    return null;
  }
  return inTurn(async () => {
    const before = useDesign.getState().state;
    const made = await told(ask());
    if (!made?.change) return null;
    await applyChange(made.change);
    // Of the changes before nothing is said any more: undo may have brought it back.
    dismissAll(GIVEN_UP);
    if (tellsGivenUp) tellGivenUp(before, made.change.state);
    return made.change;
  });
}

/** Makes a change; null where it was refused, which the person has been shown. */
export function edit(request: EditRequest): Promise<ViewChange | null> {
  return changed(() => platform.ask("edit", { request }), request.edit !== "walks");
}

/** The same with a change that depends on how the design is when its turn comes; none where that is null. */
export function editAsItIs(request: (design: DesignStore) => EditRequest | null): Promise<ViewChange | null> {
  return changed(async () => {
    const made = request(useDesign.getState());
    return made ? platform.ask("edit", { request: made }) : { change: null, notes: [] };
  });
}

export async function undo(): Promise<void> {
  await changed(() => platform.ask("undo", {}), false);
}

export async function redo(): Promise<void> {
  await changed(() => platform.ask("redo", {}), false);
}

/** As the Rust side takes them. */
export const movedOf = (moved: readonly Moved[]) =>
  moved.map(({ vertex, at }) => ({ vertex, at_mm: [...at] as [number, number, number] }));

/** Errors first, as everywhere. */
const ORDER: readonly DiagnosticReport["severity"][] = ["error", "warning", "info"];

function withCollisions(limits: LiveCheck | null, collisions: CollisionsOf | null): LiveCheck | null {
  if (!limits || !collisions || collisions.found.contacts.length === 0) return limits;
  const findings = collisions.found.contacts.map(({ finding }) => finding);
  const all = [...limits.diagnostics, ...findings];
  return {
    ...limits,
    feasible: limits.feasible && !findings.some(({ severity }) => severity === "error"),
    diagnostics: all.toSorted((a, b) => ORDER.indexOf(a.severity) - ORDER.indexOf(b.severity)),
  };
}

/** Shows where the wires hit something, or that it is not known. */
export function showCollisions(collisions: CollisionsOf | null): void {
  const { limits, collisions: before } = useDesign.getState();
  if (collisions !== before) useDesign.setState({ collisions, check: withCollisions(limits, collisions) });
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
      const dragged = wanted;
      wanted = null;
      if (isBeingReplaced()) continue;
      const { state, vertices } = useDesign.getState();
      // Of an empty design there is nothing to say that a person does not see.
      if (!state?.machine || vertices.size === 0) {
        useDesign.setState(UNCHECKED);
        continue;
      }
      const design = shown;
      const isGone = () => design !== shown || isBeingReplaced();
      const asked = platform
        .ask("check", { moved: movedOf(dragged) })
        .catch((error: unknown) => (isGone() ? null : Promise.reject(error)));
      const limits = await told(asked);
      if (isGone()) continue;
      const { collisions } = useDesign.getState();
      useDesign.setState({ limits, dragged, check: withCollisions(limits, collisions) });
    }
  } finally {
    checking = false;
  }
}
