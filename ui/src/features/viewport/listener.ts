import type { EditRequest } from "../../generated/requests";
import type { ViewChange } from "../../generated/responses";
import type { Moved, SceneListener, Stroke, Vec3 } from "../../scene/interface";
import { checkDesign, edit, useDesign } from "../../state/design/design";
import { moveBy, rotate } from "../../state/design/operations";
import { select } from "../../state/design/selection";
import { settled } from "../../state/design/turns";
import { placeStencil } from "../../state/parts/parts";
import { openMenu } from "../../state/window/context_menu";
import { takePlanePoints, useView } from "../../state/window/view";
import { useViewAxes } from "../../state/window/view_axes";

/** The stroke as a change. */
export function drawOf({
  from,
  through,
  to,
}: Pick<Stroke, "from" | "through" | "to">): Extract<EditRequest, { edit: "draw" }> {
  return { edit: "draw", from, through_mm: through.map((at) => [...at] as [number, number, number]), to };
}

/** The vertex that a strand continues from: where it ends, or its last new one. Ids ascend as they are given out. */
export function endOf(
  { to, through, from }: Pick<Stroke, "from" | "through" | "to">,
  added: readonly number[],
): number | null {
  if (to !== null) return null;
  return through.length > 0 ? (added.toSorted((a, b) => a - b).at(-1) ?? null) : from;
}

/** A stroke as one change, and its ends; an edge is split first where it begins or ends on one. `next` is the id that a new vertex gets. */
export function strokeOf(
  { from, through, to, split }: Stroke,
  next: number,
): { request: EditRequest; ends: Pick<Stroke, "from" | "through" | "to"> } {
  if (!split) return { request: drawOf({ from, through, to }), ends: { from, through, to } };
  const ends = split.end === "from" ? { from: next, through, to } : { from, through, to: next };
  const splits: EditRequest = { edit: "split", edge: split.edge, at: split.at };
  // One that only splits an edge continues from there.
  const draws = through.length > 0 || (ends.from !== null && ends.to !== null);
  return {
    request: draws ? { edit: "several", label: "draw", edits: [splits, drawOf(ends)] } : splits,
    ends: draws ? ends : { from: next, through, to: null },
  };
}

/** How many strands have ended: what was on its way for one of them opens none. */
let ended = 0;

/** Makes the stroke; the id of the vertex that the strand continues from, null where it is over. */
async function stroke(asked: Stroke): Promise<number | null> {
  const before = ended;
  // What is still on its way may take the next id.
  await settled();
  const { vertices, edges, state } = useDesign.getState();
  if (!state) return null;
  const { request, ends } = strokeOf(asked, state.next[0]);
  const change = await edit(request);
  if (!change) return null;
  const drawn =
    request.edit === "split" ? 0 : change.edges.filter(({ id }) => !edges.has(id)).length - (asked.split ? 1 : 0);
  const next = endOf(
    ends,
    change.vertices.filter(({ id }) => !vertices.has(id)).map(({ id }) => id),
  );
  if (before === ended) useView.setState(({ strand }) => ({ strand: next === null ? null : (strand ?? 0) + drawn }));
  return next;
}

/** Makes a construction line of a strand; whether it was made. */
async function line(from: Vec3, to: Vec3): Promise<boolean> {
  const before = ended;
  const through_mm = [from, to].map((at) => [...at] as [number, number, number]);
  const made = await edit({ edit: "construction", change: { make: "draw", through_mm } });
  if (made && before === ended) useView.setState(({ strand }) => ({ strand: (strand ?? 0) + 1 }));
  return made !== null;
}

/** What is done with what the view reports; `corner` is its own in the window, px. */
export function listenerOf(corner: () => { readonly left: number; readonly top: number }): SceneListener {
  return {
    selected: ({ vertices, edges, lines }) => select(vertices, edges, lines),
    hovered: (hovered) => useView.setState({ hovered }),
    dragging: (moved) => checkDesign(moved),
    dropped: (moved, lines, by) =>
      void orShowWhatIsThere(lines.length > 0 ? together(moved, lines, by) : placed(moved)),
    turned: (vertices, lines, axis, through, deg) =>
      void orShowWhatIsThere(rotate(axis, through, deg, vertices, lines)),
    dragCancelled: () => checkDesign(),
    stencilMoved,
    stencilTurned: async (stencil, axis, angle_deg) =>
      void (await edit({ edit: "turn-stencil", stencil, axis, angle_deg })),
    stroke,
    line,
    strandEnded: () => {
      ended += 1;
      useView.setState({ strand: null });
    },
    planePoints: takePlanePoints,
    measuring: (measuring) => useView.setState({ measuring }),
    viewChanged: (viewName) => useView.setState({ viewName }),
    viewTurned: (axes) => useViewAxes.setState({ axes }),
    menu: ({ x, y }) => {
      const { left, top } = corner();
      openMenu("design", { x: left + x, y: top + y });
    },
  };
}

async function stencilMoved(id: number, by: Vec3): Promise<void> {
  if (by.every((mm) => mm === 0)) return;
  await placeStencil(id, ({ shift_mm: [x, y, z] = [0, 0, 0] }) => ({ shift_mm: [x + by[0], y + by[1], z + by[2]] }));
}

const placed = (moved: readonly Moved[]): Promise<ViewChange | null> =>
  edit({
    edit: "place",
    positions: moved.map(({ vertex, at }) => ({ vertex, at_mm: [...at] as [number, number, number] })),
  });

const together = (moved: readonly Moved[], lines: readonly number[], by: Vec3): Promise<ViewChange | null> =>
  moveBy(
    by,
    moved.map(({ vertex }) => vertex),
    lines,
  );

async function orShowWhatIsThere(made: Promise<ViewChange | null>): Promise<void> {
  if (!(await made)) showWhatIsThere();
}

function showWhatIsThere(): void {
  // Refused: the view is given what is there, so that it shows no places that nothing has.
  useDesign.setState(({ vertices }) => ({ vertices: new Map(vertices) }));
  checkDesign();
}
