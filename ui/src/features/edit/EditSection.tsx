import { useMemo } from "react";
import { apartPhrase } from "../../shared/figures/apart";
import { count } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { lengthOfLines, linesOf } from "../../state/construction/lines";
import { useDesign } from "../../state/design/design";
import { lengthOf } from "../../state/design/geometry";
import { measured } from "../../state/design/measure";
import { edgesOf, isEmpty, useSelection, verticesOf } from "../../state/design/selection";
import { Part, Section } from "../panel/Section";
import { AddVertex } from "./AddVertex";
import { Exact } from "./Exact";
import { Operations } from "./Operations";
import { Position } from "./Position";
import { Route } from "./Route";
import { Shapes } from "./Shapes";
import { VertexTable } from "./VertexTable";
import "./edit.css";

function Selected() {
  const design = useDesign();
  const selection = useSelection();
  const { length } = useLengths();
  const text = useMemo(() => {
    if (isEmpty(selection)) return null;
    const [vertices, edges] = [verticesOf(selection, design), edgesOf(selection, design)];
    return [
      vertices.length > 0 && count(vertices.length, "vertex", "vertices"),
      vertices.length > 0 && count(edges.length, "edge"),
      edges.length > 0 && length(lengthOf(edges, design)),
      selection.lines.size > 0 && count(selection.lines.size, "construction line"),
      vertices.length === 0 && length(lengthOfLines(selection.lines, linesOf(design.state))),
    ]
      .filter(Boolean)
      .join(" · ");
  }, [selection, design, length]);
  return (
    <p role="status" className="selected">
      {text ?? <span className="muted">Nothing selected. Click in the view, or drag a box.</span>}
    </p>
  );
}

/** How far two selected things are apart, in as much room without them. */
function Distance() {
  const design = useDesign();
  const selection = useSelection();
  const { length, bare, name } = useLengths();
  const text = useMemo(() => {
    const found = measured(selection, design, linesOf(design.state));
    return found && apartPhrase(found, { length, bare, name });
  }, [selection, design, length, bare, name]);
  return (
    <p className="measured">{text ?? <span className="muted">Select two things to measure between them.</span>}</p>
  );
}

/** What is selected, in figures that can be typed over, and what can be done with it. */
export function EditSection() {
  const vertices = useDesign((design) => design.vertices.size);
  const edges = useDesign((design) => design.edges.size);
  const phrase = vertices === 0 ? "empty" : `${count(vertices, "vertex", "vertices")} · ${count(edges, "edge")}`;
  return (
    <Section id="edit" title="Edit" phrase={phrase}>
      <Part title="Selection">
        <Selected />
        <Distance />
        <Exact />
        <Position />
      </Part>
      <Part title="Operations">
        <Operations />
      </Part>
      <Part title="Wire">
        <Route />
      </Part>
      <Part title="Shapes">
        <Shapes />
      </Part>
      <Part title="Vertices">
        {vertices > 0 && <VertexTable />}
        <AddVertex />
      </Part>
    </Section>
  );
}
