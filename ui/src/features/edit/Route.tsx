import { Button } from "../../shared/controls/Button";
import { Field } from "../../shared/controls/Field";
import { Checkbox } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { count } from "../../shared/figures/format";
import { edit, useDesign } from "../../state/design/design";
import { edgesOf, useSelection, verticesOf } from "../../state/design/selection";

/** How the wire runs: from where, which way, in how many pieces, and which edges it is laid along twice. */
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
        <span className="grow">
          {state.start === null ? "Start point: automatic" : `Start point: vertex ${state.start}`}
        </span>
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
      {state.walks.length > 0 && (
        <div className="row wrap">
          <span className="grow">
            {state.walks.length === 1
              ? "The order of the bends is chosen"
              : `The orders of the bends of ${state.walks.length} wires are chosen`}
          </span>
          <Button small onClick={() => void edit({ edit: "walks", walks: [] })}>
            Choose automatically
          </Button>
        </div>
      )}
      <Checkbox checked={state.reversed} onChange={(reversed) => void edit({ edit: "reversed", reversed })}>
        Reversed: the wire runs the other way
      </Checkbox>
      <Checkbox checked={state.closed} onChange={(closed) => void edit({ edit: "closed", closed })}>
        Closed: the wire ends where it starts
      </Checkbox>
      <Field
        label="Most wires"
        hint={
          state.closed
            ? "A closed wire is the only one of its part. More wires open it."
            : doubled.size > 0
              ? "Doubled edges stay doubled: clear them so that more wires can save them."
              : "Fewer are used where more would not save doubled edges."
        }
      >
        {({ id, "aria-describedby": below }) => (
          <NumberField
            id={id}
            aria-describedby={below}
            kind="whole"
            label="Most wires"
            value={state.wires}
            min={1}
            max={999}
            onCommit={(wires) => void edit({ edit: "wires", wires })}
          />
        )}
      </Field>
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
          onClick={() => void edit({ edit: "doublings", edges: [...state.doublings, ...others] })}
        >
          Double the selected
        </Button>
      </div>
    </div>
  );
}
