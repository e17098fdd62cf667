import { select } from "../../state/design/selection";
import { frame } from "../../state/window/view";

/** A place in the design, to be looked at. */
export function Place({ vertex, edge }: { readonly vertex?: number; readonly edge?: number }) {
  const [vertices, edges] = [vertex === undefined ? [] : [vertex], edge === undefined ? [] : [edge]];
  const go = () => {
    select(vertices, edges);
    frame(vertices, edges);
  };
  return (
    <button type="button" className="button link" onClick={go}>
      {vertex === undefined ? `edge ${edge}` : `vertex ${vertex}`}
    </button>
  );
}
