import { useMemo } from "react";
import { Checkbox, Segmented } from "../../shared/controls/inputs";
import { NumberField } from "../../shared/controls/NumberField";
import { useDesign } from "../../state/design/design";
import { canFollow, cornerOf, edgeOf, setAngle, setLength, useExact } from "../../state/design/exact";
import { useSelection } from "../../state/design/selection";

type Which = "0" | "1";

/** Which of two stays where it is; as wide without any. */
function Stays({
  label,
  names,
  value,
  none,
  onChoose,
}: {
  readonly label: string;
  readonly names: readonly [string, string];
  readonly value: 0 | 1;
  /** Why there are none. */
  readonly none: string | null;
  readonly onChoose: (value: 0 | 1) => void;
}) {
  const choice = (value: Which, name: string) => ({ value, label: none === null ? name : "\u2013", why: none });
  return (
    <Segmented<Which>
      label={label}
      choices={[choice("0", names[0]), choice("1", names[1])]}
      value={value === 0 ? "0" : "1"}
      onChoose={(chosen) => onChoose(chosen === "0" ? 0 : 1)}
    />
  );
}

/** The length of the selected edge and the angle of the selected corner, to be typed over. As high whatever is selected. */
export function Exact() {
  const design = useDesign();
  const selection = useSelection();
  const { end, side, follows } = useExact();
  const { vertices, edges } = design;
  const edge = useMemo(() => edgeOf(selection, { vertices, edges }), [selection, vertices, edges]);
  const corner = useMemo(() => cornerOf(selection, { vertices, edges }), [selection, vertices, edges]);
  const open = useMemo(
    () => [edge, corner].some((what) => typeof what !== "string" && canFollow(what, { vertices, edges })),
    [edge, corner, vertices, edges],
  );
  const [noEdge, noCorner] = [typeof edge === "string" ? edge : null, typeof corner === "string" ? corner : null];
  const [ends, sides] = [typeof edge === "string" ? null : edge.ends, typeof corner === "string" ? null : corner.edges];
  const nothing = noEdge !== null && noCorner !== null;
  return (
    <>
      <div className="exact">
        <span className="muted">Length</span>
        <NumberField
          key={`edge ${typeof edge === "string" ? "" : edge.id}`}
          label="Length of the edge"
          value={typeof edge === "string" ? null : edge.mm}
          placeholder="one edge"
          why={noEdge}
          onCommit={(mm) => void setLength(mm)}
        />
        <span className="muted">stays</span>
        <Stays
          label="Vertex that stays"
          names={[`${ends?.[0] ?? ""}`, `${ends?.[1] ?? ""}`]}
          value={end}
          none={noEdge}
          onChoose={(chosen) => useExact.setState({ end: chosen })}
        />
        <span className="muted">Angle</span>
        <NumberField
          key={`corner ${typeof corner === "string" ? "" : corner.vertex}`}
          label="Angle between the edges"
          kind="angle"
          value={typeof corner === "string" ? null : corner.deg}
          placeholder="a corner"
          why={noCorner}
          onCommit={(deg) => void setAngle(deg)}
        />
        <span className="muted">stays</span>
        <Stays
          label="Edge that stays"
          names={[`${sides?.[0] ?? ""}`, `${sides?.[1] ?? ""}`]}
          value={side}
          none={noCorner}
          onChoose={(chosen) => useExact.setState({ side: chosen })}
        />
      </div>
      <Checkbox
        checked={follows && (open || nothing)}
        why={
          nothing ? "Select an edge or a corner first." : open ? null : "In a closed loop only the end itself moves."
        }
        onChange={(chosen) => useExact.setState({ follows: chosen })}
      >
        The rest follows
      </Checkbox>
    </>
  );
}
