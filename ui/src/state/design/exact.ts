/** What of the selection has a length or an angle that can be typed, and what stays where it is when one is. */

import { create } from "zustand";
import type { SceneDesign, WireSelection } from "../../scene/interface";
import { drawnPlane, normalOf, useView } from "../window/view";
import { edit, useDesign } from "./design";
import { angleAt, distance } from "./geometry";
import { edgesOf, useSelection, verticesOf } from "./selection";

/** Which of the two stays, and whether what is connected beyond the other follows: as a person has chosen last. */
interface ExactStore {
  readonly end: 0 | 1;
  readonly side: 0 | 1;
  readonly follows: boolean;
}

export const useExact = create<ExactStore>()(() => ({ end: 0, side: 0, follows: true }));

/** An edge whose length can be typed. */
export interface ExactEdge {
  readonly id: number;
  /** Its vertices. */
  readonly ends: readonly [number, number];
  readonly mm: number;
}

/** Two edges that meet, whose angle can be typed. */
export interface ExactCorner {
  readonly vertex: number;
  readonly edges: readonly [number, number];
  /** The vertices that they lead to. */
  readonly ends: readonly [number, number];
  readonly deg: number;
}

/** The one edge of a selection; a sentence where there is not just one. */
export function edgeOf(selection: WireSelection, design: SceneDesign): ExactEdge | string {
  const none = "Select one edge";
  const [id, ...others] = edgesOf(selection, design);
  const edge = id === undefined || others.length > 0 ? undefined : design.edges.get(id);
  if (!edge || verticesOf(selection, design).length > 2) return none;
  const [a, b] = [design.vertices.get(edge.a), design.vertices.get(edge.b)];
  return a && b ? { id: edge.id, ends: [edge.a, edge.b], mm: distance(a.at, b.at) } : none;
}

/** The corner of a selection: a vertex with two edges, or two edges that meet; a sentence where it has none. */
export function cornerOf(selection: WireSelection, design: SceneDesign): ExactCorner | string {
  const vertices = verticesOf(selection, design);
  const [vertex] = vertices;
  if (vertices.length === 1 && vertex !== undefined) {
    const at = [...design.edges.values()].filter(({ a, b }) => a === vertex || b === vertex);
    const [one, other, ...more] = at;
    if (one && other && more.length === 0) return corner(vertex, [one.id, other.id], design);
    return at.length > 2 ? `Select two of its ${at.length} edges` : "The vertex has no corner";
  }
  const chosen = edgesOf(selection, design).flatMap((id) => design.edges.get(id) ?? []);
  const [one, other] = chosen;
  if (!one || !other || chosen.length > 2 || vertices.length !== 3) return "Select a vertex or two edges";
  const met = [one.a, one.b].find((end) => end === other.a || end === other.b);
  return met === undefined ? "The edges do not meet" : corner(met, [one.id, other.id], design);
}

function corner(vertex: number, edges: readonly [number, number], design: SceneDesign): ExactCorner | string {
  const [a, b] = edges.map((id) => {
    const edge = design.edges.get(id);
    return edge ? (edge.a === vertex ? edge.b : edge.a) : vertex;
  }) as [number, number];
  const [at, from, to] = [vertex, a, b].map((id) => design.vertices.get(id)?.at);
  const deg = at && from && to ? angleAt(at, from, to) : null;
  return deg === null ? "An edge has no length" : { vertex, edges, ends: [a, b], deg };
}

/** Whether there is a way from one vertex to another that neither runs along an edge nor through a vertex that are left out. */
function joined(
  design: SceneDesign,
  from: number,
  to: number,
  without: { readonly edge?: number; readonly vertex?: number },
): boolean {
  const near = new Map<number, number[]>();
  for (const { id, a, b } of design.edges.values()) {
    if (id === without.edge || a === without.vertex || b === without.vertex) continue;
    near.set(a, [...(near.get(a) ?? []), b]);
    near.set(b, [...(near.get(b) ?? []), a]);
  }
  const found = new Set([from]);
  const open = [from];
  for (let id = open.pop(); id !== undefined; id = open.pop()) {
    if (id === to) return true;
    for (const next of near.get(id) ?? []) {
      if (found.has(next)) continue;
      found.add(next);
      open.push(next);
    }
  }
  return false;
}

/** Whether the rest beyond an edge, or a side of a corner, can follow: not in a closed loop, where it is connected to both ends. */
export function canFollow(what: ExactEdge | ExactCorner, design: SceneDesign): boolean {
  const [a, b] = what.ends;
  return !joined(design, a, b, "vertex" in what ? { vertex: what.vertex } : { edge: what.id });
}

function rest(what: ExactEdge | ExactCorner): "follows" | "stays" {
  return useExact.getState().follows && canFollow(what, useDesign.getState()) ? "follows" : "stays";
}

const current = () => [useSelection.getState(), useDesign.getState()] as const;

export async function setLength(mm: number): Promise<void> {
  const edge = edgeOf(...current());
  if (typeof edge === "string") return;
  const stays = edge.ends[useExact.getState().end];
  await edit({ edit: "length", edge: edge.id, length_mm: mm, stays, rest: rest(edge) });
}

export async function setAngle(deg: number): Promise<void> {
  const at = cornerOf(...current());
  if (typeof at === "string") return;
  const { side } = useExact.getState();
  const normal = [...normalOf(drawnPlane(useView.getState()))] as [number, number, number];
  const between: [number, number] = side === 0 ? [...at.edges] : [at.edges[1], at.edges[0]];
  await edit({ edit: "angle", vertex: at.vertex, between, angle_deg: deg, normal, rest: rest(at) });
}
