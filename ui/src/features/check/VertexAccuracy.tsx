// biome-ignore-all lint/a11y/useSemanticElements: of thousands of rows those in sight are there, which <table> would lay out by itself
// biome-ignore-all lint/a11y/useFocusableInteractive: it is a table and no grid: the focus goes to what is in its cells

import { useMemo } from "react";
import type { Prediction } from "../../generated/responses";
import { Fold } from "../../shared/controls/Fold";
import { useUnit } from "../../shared/figures/unit";
import { Rows } from "../../shared/lists/Rows";
import { highlight, select } from "../../state/design/selection";
import { frame } from "../../state/window/view";
import { displacement } from "../frame/words";
import { byVertex } from "./spread";

const ROW = 28;
const HEIGHT = 280;

/** How far each vertex will be off, and how far apart the passes of one are, the worst first; a number of a vertex selects and frames it. */
export function VertexAccuracy({ prediction }: { readonly prediction: Prediction }) {
  const unit = useUnit();
  const list = useMemo(() => byVertex(prediction), [prediction]);
  const go = (vertex: number) => {
    select([vertex]);
    frame([vertex], []);
  };
  return (
    <Fold title="Vertex by vertex" phrase={`${list.length}, the worst first`}>
      <div
        role="table"
        aria-label="Accuracy of each vertex"
        aria-rowcount={list.length + 1}
        className="vertex-accuracy"
      >
        <div role="row" className="accuracy-row head" aria-rowindex={1}>
          <span role="columnheader">Vertex</span>
          <span role="columnheader">average</span>
          <span role="columnheader">95 % within</span>
          <span role="columnheader" title="Between the passes of a vertex that the wire goes through more than once">
            gap, 95 %
          </span>
        </div>
        <Rows
          role="rowgroup"
          count={list.length}
          rowHeight={ROW}
          height={HEIGHT}
          render={(index) => {
            const one = list[index];
            if (!one) return null;
            const { vertex, mean, radius, gap } = one;
            return (
              <div
                key={vertex}
                role="row"
                aria-rowindex={index + 2}
                className="accuracy-row"
                style={{ height: ROW }}
                onPointerEnter={() => highlight([vertex])}
                onPointerLeave={() => highlight()}
              >
                <span role="rowheader">
                  <button type="button" className="button link" title="Select and frame" onClick={() => go(vertex)}>
                    {vertex}
                  </button>
                </span>
                <span role="cell">{displacement(mean, unit)}</span>
                <span role="cell">{displacement(radius, unit)}</span>
                <span role="cell">{gap === null ? "–" : displacement(gap, unit)}</span>
              </div>
            );
          }}
        />
      </div>
    </Fold>
  );
}
