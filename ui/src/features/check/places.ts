/** Where findings are, and how a person is brought there. */

import type { DiagnosticReport } from "../../generated/responses";
import { select } from "../../state/design/selection";
import { showParts } from "../../state/parts/parts";
import { frame } from "../../state/window/view";
import { placesOf } from "../viewport/marks";

export function placesOfAll(reports: readonly DiagnosticReport[]): { vertices: number[]; edges: number[] } {
  const all = reports.map(placesOf);
  return { vertices: all.flatMap(({ vertices }) => vertices), edges: all.flatMap(({ edges }) => edges) };
}

/** Selects the places and brings them into view. */
export async function showPlaces(reports: readonly DiagnosticReport[]): Promise<void> {
  const { vertices, edges } = placesOfAll(reports);
  // What is hidden can neither be selected nor looked at.
  await showParts(vertices, edges);
  select(vertices, edges);
  if (vertices.length + edges.length > 0) frame(vertices, edges);
}
