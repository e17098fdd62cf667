import { useMemo } from "react";
import type { SnapKind } from "../../scene/interface";
import { count } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { Mark } from "../../shared/lists/Mark";
import { linesOf } from "../../state/construction/lines";
import { useDesign } from "../../state/design/design";
import { distance } from "../../state/design/geometry";
import { useByHand } from "../../state/machine/by_hand";
import { usePlayback } from "../../state/program/program";
import { useContextMenu } from "../../state/window/context_menu";
import { useView } from "../../state/window/view";
import { marksOf } from "./marks";
import "./viewport.css";

/** What a click would snap to, as it is named before the click. */
const SNAP_NAMES: Readonly<Record<SnapKind, string>> = {
  vertex: "Vertex",
  "stencil-vertex": "Corner of the stencil",
  "stencil-edge": "Edge of the stencil",
  construction: "On a construction line",
  "edge-middle": "Middle of an edge: splits it",
  edge: "On an edge: splits it",
  surface: "On the stencil",
  angle: "Direction in steps of 15°",
  grid: "Grid",
  plane: "On the plane",
};

/** The same where nothing is split by a click. */
const WHOLE_NAMES: Readonly<Partial<Record<SnapKind, string>>> = {
  "edge-middle": "Middle of an edge",
  edge: "Edge",
  construction: "Construction line",
};

/** What is under the pointer, in words and figures. */
export function HoverCard() {
  const hovered = useView((view) => view.hovered);
  const splits = useView(({ tool, constructing }) => (tool === "trace" || tool === "draw") && !constructing);
  const played = usePlayback(({ played }) => played !== null);
  const menu = useContextMenu(({ opened }) => opened !== null);
  const byHand = useByHand(({ played }) => played !== null);
  const { vertices, edges, check, state } = useDesign();
  const { bare, name, length } = useLengths();
  const marks = useMemo(() => marksOf(check), [check]);
  if (!hovered || played || byHand || menu) return null;
  let title = "";
  let sub = "";
  let verdict = null;
  const at = (place: readonly [number, number, number]) =>
    `x ${bare(place[0])}   y ${bare(place[1])}   z ${bare(place[2])} ${name}`;
  if (hovered.kind === "vertex") {
    const vertex = vertices.get(hovered.id);
    if (!vertex) return null;
    let degree = 0;
    for (const { a, b } of edges.values()) degree += Number(a === hovered.id) + Number(b === hovered.id);
    title = [
      `Vertex ${hovered.id}`,
      count(degree, "edge"),
      degree % 2 === 1 && "odd corner",
      vertex.support && "support",
      vertex.joint && `${vertex.joint.kind} joint`,
    ]
      .filter(Boolean)
      .join(" · ");
    sub = at(vertex.at);
    verdict = marks.vertices.get(hovered.id) ?? null;
  } else if (hovered.kind === "edge") {
    const edge = edges.get(hovered.id);
    const [a, b] = [edge && vertices.get(edge.a), edge && vertices.get(edge.b)];
    if (!edge || !a || !b) return null;
    title = `Edge ${hovered.id} · ${length(distance(a.at, b.at))}`;
    sub = `vertex ${edge.a} to ${edge.b}${marks.doubled.has(hovered.id) ? " · doubled" : ""}`;
    verdict = marks.edges.get(hovered.id) ?? null;
  } else if (hovered.kind === "line") {
    const line = state && linesOf(state)[hovered.id];
    if (!line) return null;
    title = `Construction line ${hovered.id + 1} · ${length(distance(line[0], line[1]))}`;
    sub = "never bent";
  } else {
    title = (splits ? undefined : WHOLE_NAMES[hovered.snap]) ?? SNAP_NAMES[hovered.snap];
    sub = at(hovered.at);
  }
  return (
    <div className="hover-card" style={{ "--x": `${hovered.x}px`, "--y": `${hovered.y}px` } as Record<string, string>}>
      <strong>
        {(verdict === "error" || verdict === "warning") && <Mark tone={verdict} />}
        {title}
      </strong>
      <span className="muted">{sub}</span>
    </div>
  );
}
