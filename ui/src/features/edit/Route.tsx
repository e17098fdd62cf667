import { Button } from "../../shared/controls/Button";
import { count } from "../../shared/figures/format";
import { edit, useDesign } from "../../state/design/design";
import { edgesOf, useSelection, verticesOf } from "../../state/design/selection";

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
        <span className="grow">{state.start === null ? "Start: automatic" : `Start: vertex ${state.start}`}</span>
        {state.start !== null && (
          <Button small onClick={() => void edit({ edit: "start", vertex: null })}>
            Choose automatically
          </Button>
        )}
        <Button
          small
          why={
            vertices.size === 0
              ? "The design is empty."
              : ids.length === 1
                ? one === state.start
                  ? "The wire starts there already."
                  : null
                : "Select one vertex first."
          }
          onClick={() => one !== undefined && void edit({ edit: "start", vertex: one })}
        >
          Start at the selected
        </Button>
      </div>
      <div className="row wrap">
        <span className="grow">
          {doubled.size === 0 ? "No edge is doubled" : `${count(doubled.size, "edge")} doubled`}
        </span>
        {doubled.size > 0 && (
          <Button small onClick={() => void edit({ edit: "doublings", edges: [] })}>
            Clear doubled edges
          </Button>
        )}
        <Button
          small
          why={edges.length === 0 ? "Select edges first." : others.length === 0 ? "They are doubled already." : null}
          onClick={() => void edit({ edit: "doublings", edges: [...doubled, ...others] })}
        >
          Double the selected
        </Button>
      </div>
    </div>
  );
}
