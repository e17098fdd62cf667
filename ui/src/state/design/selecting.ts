import type { SceneDesign, Selection, WireSelection } from "../../scene/interface";

export const NOTHING: Selection = { vertices: new Set(), edges: new Set(), lines: new Set() };

export function isEmpty({ vertices, edges, lines }: Selection): boolean {
  return vertices.size + edges.size + lines.size === 0;
}

/** The selected vertices and the ends of the selected edges, in the order in which they were selected. */
export function verticesOf({ vertices, edges }: WireSelection, design: SceneDesign): number[] {
  const all = new Set(vertices);
  for (const id of edges) {
    const edge = design.edges.get(id);
    if (edge) all.add(edge.a).add(edge.b);
  }
  return [...all].filter((id) => design.vertices.has(id));
}

/** The selected edges and those with both ends selected. */
export function edgesOf(selection: WireSelection, design: SceneDesign): number[] {
  const inside = new Set(verticesOf(selection, design));
  return [...design.edges.values()]
    .filter(({ id, a, b }) => selection.edges.has(id) || (inside.has(a) && inside.has(b)))
    .map(({ id }) => id);
}

/** Everything that hangs together with what is selected. */
export function connected(selection: WireSelection, design: SceneDesign): WireSelection {
  const near = new Map<number, number[]>();
  for (const { a, b } of design.edges.values()) {
    near.set(a, [...(near.get(a) ?? []), b]);
    near.set(b, [...(near.get(b) ?? []), a]);
  }
  const vertices = new Set(verticesOf(selection, design));
  const open = [...vertices];
  for (let id = open.pop(); id !== undefined; id = open.pop()) {
    for (const next of near.get(id) ?? []) {
      if (vertices.has(next)) continue;
      vertices.add(next);
      open.push(next);
    }
  }
  const edges = [...design.edges.values()].filter(({ a }) => vertices.has(a)).map(({ id }) => id);
  return { vertices, edges: new Set(edges) };
}

/** What is not selected. */
export function inverted(selection: WireSelection, design: SceneDesign): WireSelection {
  const without = (all: Iterable<number>, some: ReadonlySet<number>) => new Set([...all].filter((id) => !some.has(id)));
  return {
    vertices: without(design.vertices.keys(), selection.vertices),
    edges: without(design.edges.keys(), selection.edges),
  };
}

/** What of a selection is still there; the same object where all of it is. */
export function stillThere(selection: WireSelection, design: SceneDesign): WireSelection {
  const gone =
    [...selection.vertices].some((id) => !design.vertices.has(id)) ||
    [...selection.edges].some((id) => !design.edges.has(id));
  if (!gone) return selection;
  return {
    vertices: new Set([...selection.vertices].filter((id) => design.vertices.has(id))),
    edges: new Set([...selection.edges].filter((id) => design.edges.has(id))),
  };
}

/** The vertices of a selection, and those that an edge leads to from there. */
export function surroundings(selection: WireSelection, design: SceneDesign): Set<number> {
  const own = new Set(verticesOf(selection, design));
  const all = new Set(own);
  for (const { a, b } of design.edges.values()) {
    if (own.has(a)) all.add(b);
    if (own.has(b)) all.add(a);
  }
  return all;
}
