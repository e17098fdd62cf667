import type { DiagnosticCode, DiagnosticReport, LiveCheck } from "../../generated/responses";
import type { SceneDesign, SceneLabel, SceneMarks, Vec3, Verdict } from "../../scene/interface";

/** What a diagnostic is about: of a step it names both, the vertex of its bend and the edges of its feed. */
const ABOUT_EDGES: ReadonlySet<DiagnosticCode> = new Set([
  "edge_too_short",
  "edge_near_limit",
  "feed_too_short",
  "feed_near_limit",
  "feed_too_long",
  "arcs_overlap",
  "zero_length_edge",
  "parallel_edges",
  "edges_meet",
  "meets_machine",
  "meets_stock",
  "strut_overstressed",
  "strut_near_buckling",
  "strut_floating",
  "no_head_direction",
]);
const ABOUT_VERTICES: ReadonlySet<DiagnosticCode> = new Set([
  "bend_too_sharp",
  "bend_near_limit",
  "bend_out_of_reach",
  "bend_too_small",
  "lead_too_short",
  "corner_too_near",
  "corner_within_reach",
  "fold_back",
  "bend_in_scatter",
  "corner_not_made",
  "rotation_out_of_range",
  "coincident_vertices",
  "isolated_vertex",
  "no_euler_path",
  "frame_unsupported",
  "frame_mechanism",
  "frame_too_soft",
  "out_of_workspace",
]);

/** The vertices and edges that a diagnostic is about. */
export function placesOf(report: Pick<DiagnosticReport, "code" | "vertex" | "vertices" | "edge" | "edges">): {
  vertices: number[];
  edges: number[];
} {
  const all = (one: number | null | undefined, many: readonly number[] | undefined) => [
    ...new Set([...(one === null || one === undefined ? [] : [one]), ...(many ?? [])]),
  ];
  const [vertices, edges] = [all(report.vertex, report.vertices), all(report.edge, report.edges)];
  if (ABOUT_EDGES.has(report.code) && edges.length > 0) return { vertices: [], edges };
  if (ABOUT_VERTICES.has(report.code) && vertices.length > 0) return { vertices, edges: [] };
  return { vertices, edges };
}

function worse(marks: Map<number, Verdict>, id: number, verdict: Verdict): void {
  if (marks.get(id) !== "error") marks.set(id, verdict);
}

/**
 * Whether every wire went through all of the checks: without a route no check has looked at bends and rotations, and what is not named
 * is not known to be fine. Stock is known of compensated wires alone.
 */
export function isCompensated({ wires }: LiveCheck): boolean {
  return wires.length > 0 && wires.every(({ stock_mm }) => stock_mm !== null);
}

/** What the view shows of the checks: the worst that is said of each place. */
export function marksOf(check: LiveCheck | null): SceneMarks {
  const vertices = new Map<number, Verdict>();
  const edges = new Map<number, Verdict>();
  const odd = new Set<number>();
  const doubled = new Set<number>();
  for (const report of check?.diagnostics ?? []) {
    const places = placesOf(report);
    if (report.code === "doubled_edge") places.edges.forEach((id) => doubled.add(id));
    if (report.severity === "info") continue;
    if (report.code === "no_euler_path") places.vertices.forEach((id) => odd.add(id));
    places.vertices.forEach((id) => worse(vertices, id, report.severity === "error" ? "error" : "warning"));
    places.edges.forEach((id) => worse(edges, id, report.severity === "error" ? "error" : "warning"));
  }
  const [vertex, towards] = check?.wires.find(({ route }) => route.length > 1)?.route ?? [];
  const start = vertex === undefined || towards === undefined ? null : { vertex, towards };
  return { vertices, edges, odd, doubled, colours: new Map(), start, checked: check !== null && isCompensated(check) };
}

/** More labels than these are no help. */
const MAX_LABELS = 60;

/** What is written on in the view: the figure that is wrong, where it is wrong; errors first. `figure` says a measured value. */
export function labelsOf(
  check: LiveCheck | null,
  { vertices, edges }: SceneDesign,
  figure: (report: DiagnosticReport) => string | null,
): SceneLabel[] {
  const labels: SceneLabel[] = [];
  const at = (report: DiagnosticReport): Vec3 | null => {
    const places = placesOf(report);
    const vertex = places.vertices[0];
    if (vertex !== undefined) return vertices.get(vertex)?.at ?? null;
    const edge = edges.get(places.edges[0] ?? -1);
    const [a, b] = [edge && vertices.get(edge.a)?.at, edge && vertices.get(edge.b)?.at];
    return a && b ? [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2] : null;
  };
  for (const report of check?.diagnostics ?? []) {
    if (report.severity === "info" || labels.length >= MAX_LABELS) continue;
    const [place, text] = [at(report), figure(report)];
    // A count is about many places at once, none of which it belongs to.
    if (place && text) labels.push({ at: place, text, verdict: report.severity });
  }
  return labels;
}
