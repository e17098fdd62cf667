// biome-ignore-all lint/a11y/useSemanticElements: of thousands of rows those in sight are there, which <table> would lay out by itself
// biome-ignore-all lint/a11y/useFocusableInteractive: it is a table and no grid: the focus goes to what is in its cells

import { type KeyboardEvent, type MouseEvent, useEffect, useMemo, useRef } from "react";
import { NumberField } from "../../shared/controls/NumberField";
import { useLengths } from "../../shared/figures/unit";
import { Rows, type RowsHandle } from "../../shared/lists/Rows";
import { useDesign } from "../../state/design/design";
import { AXES, axisIndex, degrees } from "../../state/design/geometry";
import { placeAlong } from "../../state/design/operations";
import { highlight, select, useSelection } from "../../state/design/selection";
import { frame } from "../../state/window/view";
import { marksOf } from "../viewport/marks";

const ROW = 30;
const HEIGHT = 300;

const adds = ({ ctrlKey, metaKey, shiftKey }: MouseEvent | KeyboardEvent): boolean => ctrlKey || metaKey || shiftKey;

/** Adds a vertex to the selection as its last one, or takes it out. */
function toggle(id: number): void {
  const { vertices, edges } = useSelection.getState();
  select(vertices.has(id) ? [...vertices].filter((other) => other !== id) : [...vertices, id], edges);
}

/** All vertices with their places; a cell is typed over, a number of a vertex selects and frames it, or adds it to the selection. */
export function VertexTable() {
  const design = useDesign();
  const selected = useSelection((selection) => selection.vertices);
  const { name } = useLengths();
  const rows = useRef<RowsHandle>(null);
  const list = useMemo(() => [...design.vertices.values()].sort((a, b) => a.id - b.id), [design.vertices]);
  const wrong = useMemo(() => marksOf(design.check).odd, [design.check]);
  const degree = useMemo(() => degrees(design.edges), [design.edges]);
  const places = useMemo(() => new Map(list.map(({ id }, index) => [id, index])), [list]);
  const only = selected.size === 1 ? [...selected][0] : undefined;
  // biome-ignore lint/correctness/useExhaustiveDependencies: only a new selection moves the list, not every change of a place
  useEffect(() => {
    const index = only === undefined ? undefined : places.get(only);
    if (index !== undefined) rows.current?.reveal(index);
  }, [only]);
  return (
    <div role="table" aria-label="Vertices" aria-rowcount={list.length + 1} className="vertices">
      <div role="row" className="vertex-row head" aria-rowindex={1}>
        <span role="columnheader">Vertex</span>
        {AXES.map((axis) => (
          <span key={axis} role="columnheader">
            {axis.toUpperCase()}, {name}
          </span>
        ))}
        <span role="columnheader">Edges</span>
      </div>
      <Rows
        ref={rows}
        role="rowgroup"
        count={list.length}
        rowHeight={ROW}
        height={HEIGHT}
        render={(index) => {
          const vertex = list[index];
          if (!vertex) return null;
          const { id, at } = vertex;
          const meet = degree.get(id) ?? 0;
          return (
            <div
              key={id}
              role="row"
              aria-rowindex={index + 2}
              aria-selected={selected.has(id)}
              className="vertex-row"
              style={{ height: ROW }}
              onPointerEnter={() => highlight([id])}
              onPointerLeave={() => highlight()}
            >
              <span role="rowheader">
                <button
                  type="button"
                  className="vertex-id"
                  title="Select and frame; with Ctrl or Shift add to the selection"
                  onClick={(event) => {
                    if (adds(event)) return toggle(id);
                    select([id]);
                    frame([id], []);
                  }}
                  // Not every engine tells a click by Enter which keys were held.
                  onKeyDown={(event) => {
                    if (event.key !== "Enter" || !adds(event)) return;
                    event.preventDefault();
                    toggle(id);
                  }}
                >
                  {id}
                  {vertex.support && (
                    <span className="muted" title="Support">
                      {" "}
                      ▪
                    </span>
                  )}
                </button>
              </span>
              {AXES.map((axis) => (
                <span key={axis} role="cell">
                  <NumberField
                    label={`Vertex ${id}, ${axis.toUpperCase()}`}
                    value={at[axisIndex(axis)]}
                    onCommit={(value) => void placeAlong(id, axis, value)}
                  />
                </span>
              ))}
              <span
                role="cell"
                className={wrong.has(id) ? "odd" : "muted"}
                title={meet % 2 === 1 ? "Odd corner" : undefined}
              >
                {meet}
                {meet % 2 === 1 && <span className="visually-hidden"> (odd corner)</span>}
              </span>
            </div>
          );
        }}
      />
    </div>
  );
}
