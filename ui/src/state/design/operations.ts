import type { EditRequest } from "../../generated/requests";
import type { ViewChange } from "../../generated/responses";
import type { Axis, SceneJoint, Vec3 } from "../../scene/interface";
import { tell } from "../asking/problems";
import { editLines, lines } from "../construction/lines";
import { chooseTool, useView } from "../window/view";
import { edit, editAsItIs, useDesign } from "./design";
import { AXES, axisIndex, axisUnit, type Bounds, boundsOf, degrees, lengthOf, type Matrix, turning } from "./geometry";
import { fromText, moved, pieceOf, toText } from "./piece";
import { edgesOf, select, useSelection, verticesOf } from "./selection";

/** Vertices that the selection has, in the order of selecting. */
export const selectedVertices = (): number[] => verticesOf(useSelection.getState(), useDesign.getState());
/** Edges that the selection has. */
export const selectedEdges = (): number[] => edgesOf(useSelection.getState(), useDesign.getState());

/** Where the selected vertices and the ends of the selected construction lines are. */
function selectedPlaces(): Vec3[] {
  const { vertices } = useDesign.getState();
  const drawn = lines();
  const ends = [...useSelection.getState().lines].flatMap((place) => drawn[place] ?? []);
  const at = selectedVertices().map((id) => vertices.get(id)?.at);
  return [...at.filter((place) => place !== undefined), ...ends];
}

/** The box around the selection; null where there is none. */
export const selectedBounds = (): Bounds | null => boundsOf(selectedPlaces());

/** A change of vertices and construction lines: those that are selected, unless others are named. */
function editSelected(
  request: (vertices: number[], lines: number[]) => EditRequest,
  vertices: readonly number[] = selectedVertices(),
  places: Iterable<number> = useSelection.getState().lines,
): Promise<ViewChange | null> {
  return editLines(places, (lines) => (vertices.length + lines.length > 0 ? request([...vertices], lines) : null));
}

/** Makes a change and selects what it has added. */
async function andSelect(made: () => Promise<ViewChange | null>): Promise<ViewChange | null> {
  const { vertices, edges } = useDesign.getState();
  const drawn = lines().length;
  const change = await made();
  if (!change) return null;
  const added = change.state.construction_mm.slice(drawn).map((_, index) => drawn + index);
  select(
    change.vertices.filter(({ id }) => !vertices.has(id)).map(({ id }) => id),
    change.edges.filter(({ id }) => !edges.has(id)).map(({ id }) => id),
    added,
  );
  return change;
}

/** Several changes as one thing to undo; one alone is asked for as it is. */
function together(label: string, edits: readonly EditRequest[]): EditRequest | null {
  const [first] = edits;
  return edits.length > 1 ? { edit: "several", label, edits: [...edits] } : (first ?? null);
}

export function remove(): void {
  const { vertices, edges, lines: places } = useSelection.getState();
  void editLines(places, (lines) => ({ edit: "delete", vertices: [...vertices], edges: [...edges], lines }));
}

/** Puts a vertex on each selected edge; `at` from 0 to 1 along it. */
export async function split(at = 0.5): Promise<void> {
  const request = together(
    "split edges",
    [...useSelection.getState().edges].map((edge) => ({ edit: "split" as const, edge, at })),
  );
  if (request) await andSelect(() => edit(request));
}

export async function merge(at: "first" | "last" | "centre" = "centre"): Promise<void> {
  const vertices = selectedVertices();
  const [first] = vertices;
  if ((await edit({ edit: "merge", vertices, at })) && first !== undefined) select([first]);
}

/** Edges between the selected vertices in the order in which they were selected. */
export async function connect(): Promise<void> {
  const ids = selectedVertices();
  const pairs = ids.slice(1).map((to, index) => ({ edit: "draw" as const, from: ids[index] ?? to, to }));
  const request = together("connect vertices", pairs);
  if (request) await edit(request);
}

/** The selected edges become lines to measure and to snap to, which are never bent; where only lines are selected, these become edges. */
export async function toConstruction(): Promise<void> {
  const edges = selectedEdges();
  if (edges.length > 0) await edit({ edit: "construction", change: { make: "lines", edges } });
  else await changeLines("edges", useSelection.getState().lines);
}

/** Construction lines become edges, or are deleted. */
export async function changeLines(make: "edges" | "nothing", places: Iterable<number>): Promise<void> {
  await editLines(places, (lines) => (lines.length > 0 ? { edit: "construction", change: { make, lines } } : null));
}

/** An edge from each selected vertex, mm along an axis; then they are moved by the pointer. */
export async function extrude(axis: Axis = "z", by = useView.getState().grid * 4, grab = true): Promise<void> {
  const { vertices } = useDesign.getState();
  const unit = axisUnit(axis);
  const draws = selectedVertices().flatMap((from) => {
    const at = vertices.get(from)?.at;
    return at
      ? [
          {
            edit: "draw" as const,
            from,
            through_mm: [at.map((value, k) => value + (unit[k] ?? 0) * by) as [number, number, number]],
          },
        ]
      : [];
  });
  const request = together("extrude", draws);
  if (!request) return;
  const change = await edit(request);
  if (!change) return;
  select(change.vertices.filter(({ id }) => !vertices.has(id)).map(({ id }) => id));
  if (!grab) return;
  chooseTool("select");
  // The view has the new vertices after this turn.
  setTimeout(() => useView.getState().handle?.startGrab());
}

/** Mirrors in a plane of an axis through a point; with `copy` the image is added. */
export async function mirror(axis: Axis, through: number, copy: boolean): Promise<void> {
  const point_mm: [number, number, number] = [0, 0, 0];
  point_mm[axisIndex(axis)] = through;
  const normal = [...axisUnit(axis)] as [number, number, number];
  const mirrored = () =>
    editSelected((vertices, lines) => ({ edit: "mirror", vertices, lines, point_mm, normal, copy }));
  await (copy ? andSelect(mirrored) : mirrored());
}

export async function array(step: Matrix, count: number): Promise<void> {
  await editSelected((vertices, lines) => ({ edit: "array", vertices, lines, step, count }));
}

export async function transform(matrix: Matrix): Promise<void> {
  await editSelected((vertices, lines) => ({ edit: "transform", vertices, lines, matrix }));
}

/** Turns vertices and construction lines, else the selection, right-handed by degrees about an axis through a point. */
export async function rotate(
  axis: Axis,
  through: Vec3,
  angle_deg: number,
  vertices?: readonly number[],
  places?: readonly number[],
): Promise<ViewChange | null> {
  const through_mm: [number, number, number] = [...through];
  return editSelected(
    (turned, lines) => ({ edit: "rotate", vertices: turned, lines, axis, through_mm, angle_deg }),
    vertices,
    places,
  );
}

/** Turns the selection by degrees about an edge, right-handed along it from its first vertex to its second. */
export async function rotateAbout(edge: number, angle_deg: number): Promise<void> {
  const { vertices, edges } = useDesign.getState();
  const axis = edges.get(edge);
  const [from, to] = [axis && vertices.get(axis.a)?.at, axis && vertices.get(axis.b)?.at];
  const matrix = from && to ? turning(from, to, angle_deg) : null;
  if (matrix) await transform(matrix);
}

/** Selected vertices with two edges. */
export function selectedCorners(): number[] {
  const meeting = degrees(useDesign.getState().edges);
  return selectedVertices().filter((id) => meeting.get(id) === 2);
}

/** Rounds the selected corners; which chords that has made, null where it could not be. */
export async function fillet(
  radius_mm: number,
  step_deg: number,
): Promise<{ readonly corners: number; readonly chords: number; readonly shortest: number } | null> {
  const { edges } = useDesign.getState();
  const vertices = selectedCorners();
  const change = await edit({ edit: "fillet", vertices, radius_mm, step_deg });
  if (!change) return null;
  const design = useDesign.getState();
  const chords = change.edges.filter(({ id }) => !edges.has(id)).map(({ id }) => lengthOf([id], design));
  const shortest = chords.reduce((least, mm) => Math.min(least, mm), Infinity);
  return { corners: vertices.length, chords: chords.length, shortest };
}

export type ShapeRequest = Extract<EditRequest, { edit: "circle" | "polygon" | "helix" }>;

/** Adds a shape, and selects it. */
export async function addShape(shape: ShapeRequest): Promise<void> {
  await andSelect(() => edit(shape));
}

/** Moves vertices and construction lines, else the selection, mm. */
export async function moveBy(
  by: Vec3,
  vertices?: readonly number[],
  places?: readonly number[],
): Promise<ViewChange | null> {
  const by_mm: [number, number, number] = [...by];
  return editSelected((moving, lines) => ({ edit: "move", vertices: moving, lines, by_mm }), vertices, places);
}

/** Puts a vertex elsewhere along one axis, mm. Along the others it stays where it is by then: they may have been asked for just before. */
export async function placeAlong(vertex: number, axis: Axis, mm: number): Promise<void> {
  await editAsItIs(({ vertices }) => {
    const at = vertices.get(vertex)?.at;
    if (!at) return null;
    const at_mm: [number, number, number] = [...at];
    at_mm[axisIndex(axis)] = mm;
    return { edit: "place", positions: [{ vertex, at_mm }] };
  });
}

export async function support(fixed: boolean): Promise<void> {
  await edit({ edit: "support", vertices: selectedVertices(), support: fixed });
}

/** Puts a joint at the selected vertices; null takes theirs away. */
export async function setJoint(joint: SceneJoint | null): Promise<void> {
  await edit({ edit: "joint", vertices: selectedVertices(), joint });
}

export async function detach(): Promise<void> {
  await edit({ edit: "detach", edges: selectedEdges() });
}

/** Makes a change that may find nothing to change, which would look as if the button did not work. */
async function orTell(request: EditRequest, nothing: string): Promise<void> {
  const change = await edit(request);
  if (
    change &&
    change.vertices.length + change.edges.length + change.gone_vertices.length + change.gone_edges.length === 0
  )
    tell("info", nothing, request.edit);
}

export async function straighten(tolerance_mm: number): Promise<void> {
  await orTell(
    { edit: "straighten", edges: selectedEdges(), tolerance_mm },
    "No vertex of the chain is that close to a straight line: give a larger tolerance.",
  );
}

export async function round(tolerance_mm: number, step_deg: number): Promise<void> {
  await orTell(
    { edit: "round", edges: selectedEdges(), tolerance_mm, step_deg },
    "No arc is that close to the chain: give a larger tolerance.",
  );
}

/** What was copied last in this window, for where the clipboard may not be read. */
let kept = "";

/** The selection as text for the clipboard; null of nothing. */
export function copied(): string | null {
  const piece = pieceOf(useSelection.getState(), useDesign.getState());
  if (!piece) return null;
  kept = toText(piece);
  return kept;
}

/** Copies without an event of the browser, such as from a menu. */
export function copy(): void {
  const text = copied();
  // Where the clipboard may not be written, what was kept serves within this window.
  if (text) void navigator.clipboard?.writeText(text).catch(() => {});
}

export function cut(): void {
  copy();
  remove();
}

/** Pastes text of the clipboard, a step of the grid beside where it was copied. */
export async function pasteText(text: string): Promise<void> {
  const piece = fromText(text);
  if (typeof piece === "string") return tell("info", piece, "paste");
  const { grid } = useView.getState();
  await andSelect(() => edit(moved(piece, [grid, grid, 0])));
}

export async function paste(): Promise<void> {
  const text = await navigator.clipboard?.readText().catch(() => null);
  await pasteText(text ?? kept);
}

export async function duplicate(): Promise<void> {
  const piece = pieceOf(useSelection.getState(), useDesign.getState());
  if (!piece) return;
  const { grid } = useView.getState();
  if (!(await andSelect(() => edit(moved(piece, [grid, grid, 0]))))) return;
  chooseTool("select");
  setTimeout(() => useView.getState().handle?.startGrab());
}

/** The axis along which the selection is largest, and how far that is, mm; null of nothing that has a size. */
export function largest(): { axis: Axis; size: number; centre: Vec3 } | null {
  const bounds = selectedBounds();
  if (!bounds) return null;
  const [axis, size] = AXES.map((axis) => [axis, bounds.size[axisIndex(axis)]] as const).reduce((a, b) =>
    b[1] > a[1] ? b : a,
  );
  return size > 0 ? { axis, size, centre: bounds.centre } : null;
}
