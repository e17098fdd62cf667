import { useView } from "../../state/window/view";
import "./viewport.css";

const NEXT = [
  "Click the first point of the plane: a vertex, the middle of an edge, the end of a construction line, a corner of the stencil.",
  "Click the second point: its first axis runs towards it.",
  "Click the third point, off the line of the first two.",
] as const;

/** Which point of a plane a click takes next, over the foot of the view. */
export function PlanePoints() {
  const { tool, planePoints } = useView();
  if (tool !== "plane") return null;
  return (
    <p role="status" className="measuring">
      {NEXT[planePoints]}
    </p>
  );
}
