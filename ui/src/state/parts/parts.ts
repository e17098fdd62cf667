/** The parts of a design: struts that hang together. What they are called, their colours and whether they are hidden. */

import type { Colour, SceneDesign, SceneEdge } from "../../scene/interface";
import { type DesignState, type DesignStore, editAsItIs, useDesign } from "../design/design";

export type StencilView = DesignState["stencils"][number];
export type Look = StencilView["look"];
export type Placement = StencilView["placement"];

export interface Part {
  /** Its edge with the lowest id. */
  readonly id: number;
  readonly vertices: readonly number[];
  readonly edges: readonly number[];
  readonly look: Look;
}

const PLAIN: Look = { name: "", colour: null, hidden: false };

let known: { edges: DesignStore["edges"]; looks: DesignState["parts"]; parts: readonly Part[] } | null = null;

/** The parts, in the order in which they were drawn. */
export function partsOf({ edges, state }: Pick<DesignStore, "edges" | "state">): readonly Part[] {
  const looks = state?.parts ?? [];
  if (known?.edges === edges && known.looks === looks) return known.parts;
  const parts = found(edges, new Map(looks.map(({ edge, look }) => [edge, look] as const)));
  known = { edges, looks, parts };
  return parts;
}

function found(edges: ReadonlyMap<number, SceneEdge>, looks: ReadonlyMap<number, Look>): Part[] {
  const at = new Map<number, SceneEdge[]>();
  for (const edge of edges.values()) {
    for (const end of [edge.a, edge.b]) {
      const others = at.get(end);
      if (others) others.push(edge);
      else at.set(end, [edge]);
    }
  }
  const parts: Part[] = [];
  const seen = new Set<number>();
  for (const first of [...edges.values()].sort((a, b) => a.id - b.id)) {
    if (seen.has(first.id)) continue;
    seen.add(first.id);
    const [together, vertices] = [[first.id], new Set<number>()];
    const open = [first.a, first.b];
    for (let vertex = open.pop(); vertex !== undefined; vertex = open.pop()) {
      if (vertices.has(vertex)) continue;
      vertices.add(vertex);
      for (const edge of at.get(vertex) ?? []) {
        open.push(edge.a, edge.b);
        if (seen.has(edge.id)) continue;
        seen.add(edge.id);
        together.push(edge.id);
      }
    }
    // A part that was joined from several has the look of each: the first one counts.
    const named = together.filter((edge) => looks.has(edge)).sort((a, b) => a - b)[0];
    const look = (named === undefined ? null : looks.get(named)) ?? PLAIN;
    parts.push({ id: first.id, vertices: [...vertices], edges: together, look });
  }
  return parts;
}

/** What is left of a design without its hidden parts; the same one where none is hidden. */
export function shownDesign(design: Pick<DesignStore, "vertices" | "edges" | "state">): SceneDesign {
  if (!design.state?.parts.some(({ look }) => look.hidden)) return design;
  const hidden = partsOf(design).filter(({ look }) => look.hidden);
  const without = <T>(all: ReadonlyMap<number, T>, gone: readonly number[]) => {
    const left = new Map(all);
    for (const id of gone) left.delete(id);
    return left;
  };
  return {
    vertices: without(
      design.vertices,
      hidden.flatMap(({ vertices }) => vertices),
    ),
    edges: without(
      design.edges,
      hidden.flatMap(({ edges }) => edges),
    ),
  };
}

/** The colours of edges whose part has one. */
export function coloursOf(design: Pick<DesignStore, "edges" | "state">): ReadonlyMap<number, Colour> {
  const colours = new Map<number, Colour>();
  if (!design.state?.parts.some(({ look }) => look.colour)) return colours;
  for (const { edges, look } of partsOf(design)) {
    const colour = colourOf(look);
    if (colour) for (const edge of edges) colours.set(edge, colour);
  }
  return colours;
}

const colours = new Map<string, Colour>();

/** As the scene takes it: the same object for the same colour. */
export function colourOf({ colour }: Look): Colour | null {
  if (!colour) return null;
  const known = colours.get(colour);
  if (known) return known;
  const part = (at: number) => Number.parseInt(colour.slice(at, at + 2), 16) / 255;
  const made: Colour = [part(1), part(3), part(5)];
  colours.set(colour, made);
  return made;
}

/** Gives a part another look: only what is named changes. */
export const changePart = ({ id }: Part, change: Partial<Look>) =>
  editAsItIs((design) => {
    const part = partsOf(design).find(({ edges }) => edges.includes(id));
    return part ? { edit: "part-look", edge: id, look: { ...part.look, ...change } } : null;
  });

/** Shows the hidden parts that these places belong to. */
export async function showParts(vertices: readonly number[], edges: readonly number[]): Promise<void> {
  const hidden = partsOf(useDesign.getState()).filter(
    (part) =>
      part.look.hidden &&
      (vertices.some((id) => part.vertices.includes(id)) || edges.some((id) => part.edges.includes(id))),
  );
  for (const part of hidden) await changePart(part, { hidden: false });
}

const stencilOf = ({ state }: DesignStore, id: number) => state?.stencils.find((stencil) => stencil.id === id);

/** Gives a stencil another look. */
export const changeStencil = (id: number, change: Partial<Look>) =>
  editAsItIs((design) => {
    const stencil = stencilOf(design, id);
    return stencil ? { edit: "stencil-look", stencil: id, look: { ...stencil.look, ...change } } : null;
  });

/** Moves, turns or scales a stencil. */
export const placeStencil = (id: number, change: (before: Placement) => Partial<Placement>) =>
  editAsItIs((design) => {
    const before = stencilOf(design, id)?.placement;
    return before ? { edit: "place-stencil", stencil: id, placement: { ...before, ...change(before) } } : null;
  });
