import { Button } from "../../shared/Button";
import { count } from "../../shared/format";
import { edit, useDesign } from "../../state/design";
import { edgesOf, useSelection, verticesOf } from "../../state/selection";

/** Where the wire starts, and which edges are laid twice so that one wire can cover the rest. */
export function Route() {
  const design = useDesign();
  const selection = useSelection();
  const { state, vertices } = design;
  if (!state) return null;
  const ids = verticesOf(selection, design);
  const [one] = ids;
  const edges = edgesOf(selection, design);
  const doubled = new Set(state.doublings);
  const others = edges.filter((id) => !doubled.has(id));
  return (
    <div className="stack">
      <div className="row wrap">
        <span className="grow">{state.start === null ? "Starts where it is best" : `Starts at vertex ${state.start}`}</span>
        {state.start !== null && (
          <Button small onClick={() => void edit({ edit: "start", vertex: null })}>
            Anywhere
          </Button>
        )}
        <Button
          small
          why={vertices.size === 0 ? "There is nothing in the design yet" : ids.length === 1 ? (one === state.start ? "It starts there" : null) : "Select one vertex first"}
          onClick={() => one !== undefined && void edit({ edit: "start", vertex: one })}
        >
          Start at the selected
        </Button>
      </div>
      <div className="row wrap">
        <span className="grow">{doubled.size === 0 ? "No edge is laid twice" : `${count(doubled.size, "edge")} laid twice`}</span>
        {doubled.size > 0 && (
          <Button small onClick={() => void edit({ edit: "doublings", edges: [] })}>
            None twice
          </Button>
        )}
        <Button
          small
          why={edges.length === 0 ? "Select edges first" : others.length === 0 ? "They are laid twice already" : null}
          onClick={() => void edit({ edit: "doublings", edges: [...doubled, ...others] })}
        >
          Double the selected
        </Button>
      </div>
    </div>
  );
}
