import { Button } from "../../shared/controls/Button";
import { count } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { Rows } from "../../shared/lists/Rows";
import type { Line } from "../../state/construction/lines";
import { distance } from "../../state/design/geometry";
import { changeLines } from "../../state/design/operations";
import { highlight, select, useSelection } from "../../state/design/selection";
import { setConstructionShown, useView } from "../../state/window/view";
import { Part as Piece } from "../panel/Section";
import { ROW } from "./PartRow";

const HEIGHT = 192;

/** Chooses a line of the list, or with a key held also that one, or all up to it; hidden ones are shown, to be seen chosen. */
function choose(
  index: number,
  keys: { readonly shiftKey: boolean; readonly ctrlKey: boolean; readonly metaKey: boolean },
) {
  setConstructionShown(true);
  const { vertices, edges, lines } = useSelection.getState();
  const chosen = new Set(lines);
  if (!keys.shiftKey && !keys.ctrlKey && !keys.metaKey) return select([], [], [index]);
  if (!keys.shiftKey && chosen.has(index)) chosen.delete(index);
  else chosen.add(index);
  select(vertices, edges, chosen);
}

function Row({ line, index }: { readonly line: Line; readonly index: number }) {
  const { length } = useLengths();
  const chosen = useSelection(({ lines }) => lines.has(index));
  const shown = useView(({ constructionShown }) => constructionShown);
  const name = `Line ${index + 1}`;
  return (
    // biome-ignore lint/a11y/useSemanticElements: of many rows those in sight are there, and they are laid out by height
    <div
      role="listitem"
      className={`part-row${chosen ? " chosen" : ""}${shown ? "" : " hidden-part"}`}
      style={{ height: ROW }}
      onPointerEnter={() => highlight([], [], [index])}
      onPointerLeave={() => highlight()}
    >
      <button
        type="button"
        className="part-name"
        aria-pressed={chosen}
        title={name}
        onClick={(event) => choose(index, event)}
      >
        <span className="ellipsis">{name}</span>
        <span className="muted">{length(distance(line[0], line[1]))}</span>
      </button>
      <Button small aria-label={`Make edge of ${name}`} onClick={() => void changeLines("edges", [index])}>
        Make edge
      </Button>
      <Button
        kind="quiet"
        icon="trash"
        aria-label={`Delete ${name}`}
        title="Delete"
        onClick={() => void changeLines("nothing", [index])}
      />
    </div>
  );
}

/** Lines to measure and to snap to, which are never bent: each becomes an edge again, or is deleted. */
export function Construction({ lines }: { readonly lines: readonly Line[] }) {
  const shown = useView(({ constructionShown }) => constructionShown);
  if (lines.length === 0) return null;
  return (
    <Piece
      title="Construction lines"
      aside={
        <span className="row">
          <span className="muted">{count(lines.length, "line")}</span>
          <Button
            kind="quiet"
            icon={shown ? "shown" : "hidden"}
            aria-label={shown ? "Hide construction lines" : "Show construction lines"}
            title={shown ? "Hide all" : "Show all"}
            onClick={() => setConstructionShown(!shown)}
          />
        </span>
      }
    >
      <Rows
        role="list"
        aria-label="Construction lines"
        count={lines.length}
        rowHeight={ROW}
        height={HEIGHT}
        render={(index) => {
          const line = lines[index];
          return line && <Row key={index} line={line} index={index} />;
        }}
      />
      <div className="row end">
        <Button small onClick={() => void changeLines("edges", lines.keys())}>
          Make edges of all
        </Button>
        <Button small onClick={() => void changeLines("nothing", lines.keys())}>
          Delete all
        </Button>
      </div>
      <p className="muted small">
        To measure and to snap to; never bent. Shift+K draws more, K makes them of selected edges.
      </p>
    </Piece>
  );
}
