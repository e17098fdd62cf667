import { Field } from "../../shared/controls/Field";
import { count } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { Rows } from "../../shared/lists/Rows";
import { useDesign } from "../../state/design/design";
import { highlight, select, useSelection } from "../../state/design/selection";
import { changePart, type Part } from "../../state/parts/parts";
import { Part as Piece } from "../panel/Section";
import { Name } from "./Name";
import { PartRow, ROW } from "./PartRow";

/** The most px of the list. */
const HEIGHT = 240;

/** What a part is called. */
const nameOf = ({ look }: Part, index: number): string => look.name || `Part ${index + 1}`;

function lengthOf({ edges }: Part): number {
  const design = useDesign.getState();
  return edges.reduce((sum, id) => {
    const edge = design.edges.get(id);
    const [a, b] = [design.vertices.get(edge?.a ?? -1)?.at, design.vertices.get(edge?.b ?? -1)?.at];
    return a && b ? sum + Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) : sum;
  }, 0);
}

/** The part that all of the selection belongs to; none where it is of several, or nothing is selected. */
function selectedPart(
  parts: readonly Part[],
  { vertices, edges }: { vertices: ReadonlySet<number>; edges: ReadonlySet<number> },
): Part | undefined {
  const [edge] = edges;
  const [vertex] = vertices;
  const found = parts.find(
    (part) =>
      (edge !== undefined && part.edges.includes(edge)) ||
      (edge === undefined && vertex !== undefined && part.vertices.includes(vertex)),
  );
  if (!found) return undefined;
  const own = { vertices: new Set(found.vertices), edges: new Set(found.edges) };
  const all = [...vertices].every((id) => own.vertices.has(id)) && [...edges].every((id) => own.edges.has(id));
  return all ? found : undefined;
}

/** Wires that hang together: each is named, coloured and hidden by itself. */
export function Wires({ parts }: { readonly parts: readonly Part[] }) {
  const selection = useSelection();
  const { length } = useLengths();
  if (parts.length === 0) {
    return (
      <Piece title="Wire">
        <p className="muted">Nothing is drawn yet. Connected edges form one part.</p>
      </Piece>
    );
  }
  const chosen = selectedPart(parts, selection);
  const why = chosen ? null : "Select one part first.";
  return (
    <Piece title="Wire" aside={<span className="muted">{count(parts.length, "part")}</span>}>
      <Rows
        role="list"
        aria-label="Parts of the wire"
        count={parts.length}
        rowHeight={ROW}
        height={HEIGHT}
        render={(index) => {
          const part = parts[index];
          if (!part) return null;
          const name = nameOf(part, index);
          return (
            <PartRow
              key={part.id}
              name={name}
              look={part.look}
              usual="var(--wire)"
              figures={`${count(part.edges.length, "edge")} · ${length(lengthOf(part))}`}
              chosen={part === chosen}
              onChoose={() => select(part.look.hidden ? [] : part.vertices, part.look.hidden ? [] : part.edges)}
              onPoint={(pointed) => highlight([], pointed ? part.edges : [])}
              onChange={(change) => {
                if (change.hidden && part === chosen) select([]);
                void changePart(part, change);
              }}
            />
          );
        }}
      />
      <Field label="Name">
        {({ id }) => (
          <Name
            key={chosen?.id ?? "none"}
            id={id}
            label="Name of the part"
            name={chosen?.look.name ?? ""}
            usual={chosen ? nameOf({ ...chosen, look: {} }, parts.indexOf(chosen)) : ""}
            why={why}
            onCommit={(name) => chosen && void changePart(chosen, { name })}
          />
        )}
      </Field>
      <p className="muted small">Hidden parts are still bent.</p>
    </Piece>
  );
}
