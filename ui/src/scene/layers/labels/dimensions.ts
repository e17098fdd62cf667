/** The lengths of edges and the angles between them, as they are written beside the design. Pure. */

import type { LengthFormat, SceneDimensions, SceneLabel, Vec3 } from "../../interface";
import { add, direction, distance, length, scale, subtract } from "../../vec";
import type { DrawnDesign } from "../drawn_design";

export const NO_DIMENSIONS: SceneDimensions = { all: false, edges: [], corners: [], between: null, stays: null };

/** More labels than these are no help. */
const MAX_LABELS = 120;

/** Of those that are asked for by name first, which are always shown; then of all. */
export function dimensionLabels(design: DrawnDesign, asked: SceneDimensions, lengths: LengthFormat): SceneLabel[] {
  const labels: SceneLabel[] = [];
  const edge = (row: number, first: boolean): void => {
    const [a, b] = design.segment(row);
    const text = `${lengths.number(distance(a, b))} ${lengths.name}`;
    labels.push({ at: scale(add(a, b), 0.5), text, verdict: null, beside: [a, b], first });
  };
  const corner = (vertex: number, ends: readonly [number, number], first: boolean): void => {
    const [at, from, to] = [vertex, ends[0], ends[1]].map((id) => design.place(id));
    const label = at && from && to && angleLabel(at, from, to, lengths);
    if (label) labels.push({ ...label, first });
  };
  for (const id of asked.edges) {
    const row = design.edgeRow(id);
    if (row !== undefined) edge(row, true);
  }
  for (const { vertex, ends } of asked.corners) corner(vertex, ends, true);
  if (asked.between) {
    const [from, to] = asked.between;
    const text = `${lengths.number(distance(from, to))} ${lengths.name}`;
    labels.push({ at: scale(add(from, to), 0.5), text, verdict: null, beside: [from, to], first: true });
  }
  const stays = asked.stays === null ? null : design.place(asked.stays);
  if (stays) labels.push({ at: stays, text: "stays", verdict: null, first: true });
  if (!asked.all) return labels;
  const [edges, corners] = [new Set(asked.edges), new Set(asked.corners.map(({ vertex }) => vertex))];
  design.edges.forEach(({ id }, row) => {
    if (labels.length < MAX_LABELS && !edges.has(id)) edge(row, false);
  });
  design.vertices.forEach(({ id }, row) => {
    const [one, other, ...more] = design.edgesAt(row).map((at) => design.edges[at]);
    if (labels.length >= MAX_LABELS || !one || !other || more.length > 0 || corners.has(id)) return;
    corner(id, [one.a === id ? one.b : one.a, other.a === id ? other.b : other.a], false);
  });
  return labels;
}

/** The angle at a place between the ways to two others, which is written between them; null where one of them is there. */
function angleLabel(at: Vec3, from: Vec3, to: Vec3, lengths: LengthFormat): SceneLabel | null {
  const [a, b] = [direction(subtract(from, at)), direction(subtract(to, at))];
  if (!a || !b) return null;
  const between = add(a, b);
  const deg = (2 * Math.atan2(length(subtract(a, b)), length(between)) * 180) / Math.PI;
  const text = lengths.angle(deg);
  // Of edges in line nothing is between them.
  return { at, text, verdict: null, ...(length(between) > 0.02 ? { towards: add(at, between) } : {}) };
}
