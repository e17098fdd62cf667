import { apartPhrase } from "../../shared/figures/apart";
import { useLengths } from "../../shared/figures/unit";
import { between } from "../../state/design/measure";
import { useView } from "../../state/window/view";
import "./viewport.css";

/** What is measured in the view, while that is its tool: over its foot, so that nothing moves for it. */
export function Measuring() {
  const shown = useView(({ tool }) => tool === "measure");
  const [one, other] = useView(({ measuring }) => measuring);
  const lengths = useLengths();
  if (!shown) return null;
  return (
    <p role="status" className="measuring">
      {one && other
        ? apartPhrase(between(one, other), lengths)
        : one
          ? "Click what to measure to."
          : "Click what to measure from: a vertex, an edge or its middle, a construction line, the stencil."}
    </p>
  );
}
