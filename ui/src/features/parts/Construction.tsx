import { Button } from "../../shared/controls/Button";
import { count } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { Rows } from "../../shared/lists/Rows";
import { edit } from "../../state/design/design";
import { distance } from "../../state/design/geometry";
import { useView } from "../../state/window/view";
import { Part as Piece } from "../panel/Section";
import { ROW } from "./PartRow";

const HEIGHT = 192;

type Lines = readonly (readonly [readonly [number, number, number], readonly [number, number, number]])[];

const point = (pointedLine: number | null) => useView.setState({ pointedLine });
const make = (change: "edges" | "nothing", lines: readonly number[]) => {
  point(null);
  void edit({ edit: "construction", change: { make: change, lines: [...lines] } });
};

/** Lines to measure and to snap to, which are never bent: each becomes an edge again, or is deleted. */
export function Construction({ lines }: { readonly lines: Lines }) {
  const { length } = useLengths();
  if (lines.length === 0) return null;
  const all = lines.map((_, index) => index);
  return (
    <Piece title="Construction lines" aside={<span className="muted">{count(lines.length, "line")}</span>}>
      <Rows
        role="list"
        aria-label="Construction lines"
        count={lines.length}
        rowHeight={ROW}
        height={HEIGHT}
        render={(index) => {
          const line = lines[index];
          if (!line) return null;
          const name = `Line ${index + 1}`;
          return (
            // biome-ignore lint/a11y/useSemanticElements: of many rows those in sight are there, and they are laid out by height
            <div
              key={index}
              role="listitem"
              className="part-row"
              style={{ height: ROW }}
              onPointerEnter={() => point(index)}
              onPointerLeave={() => point(null)}
            >
              <span className="part-name">
                <span className="ellipsis">{name}</span>
                <span className="muted">{length(distance(line[0], line[1]))}</span>
              </span>
              <Button small aria-label={`Make edge of ${name}`} onClick={() => make("edges", [index])}>
                Make edge
              </Button>
              <Button
                kind="quiet"
                icon="trash"
                aria-label={`Delete ${name}`}
                title="Delete"
                onClick={() => make("nothing", [index])}
              />
            </div>
          );
        }}
      />
      <div className="row end">
        <Button small onClick={() => make("edges", all)}>
          Make edges of all
        </Button>
        <Button small onClick={() => make("nothing", all)}>
          Delete all
        </Button>
      </div>
      <p className="muted small">To measure and to snap to; never bent. Select edges and press K for more.</p>
    </Piece>
  );
}
