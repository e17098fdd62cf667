import { Button } from "../../shared/controls/Button";
import "./trace.css";
import { count } from "../../shared/figures/format";
import { useDesign } from "../../state/design/design";
import { useView } from "../../state/window/view";

/** How the strand stands that is being drawn, and how it is ended: in as much room whatever it says. */
export function Strand() {
  return (
    <div className="strand">
      <State />
    </div>
  );
}

function State() {
  const { tool, constructing, strand, handle } = useView();
  const stencil = useDesign(({ surfaces }) => surfaces.size > 0);
  if (tool !== "trace" && tool !== "draw")
    return <p className="muted">Choose one of the two tools, then click in the view. Each click places a vertex.</p>;
  if (strand === null) {
    return (
      <p className="muted" role="status">
        {constructing
          ? "Click to begin a construction line: to measure and to snap to."
          : tool === "draw"
            ? "Click on the plane to begin a strand. Its edges go in steps of 15°; Shift frees them."
            : stencil
              ? "Click on the stencil to begin a strand."
              : "Click to begin a strand. Without a stencil it lies on the ground plane."}
      </p>
    );
  }
  return (
    <div className="row wrap" role="status">
      <span className="muted small">
        Type a length, after Tab an angle, and press Enter to place the {constructing ? "line" : "edge"}.
      </span>
      <span className="grow">{count(strand, constructing ? "line" : "edge")} drawn</span>
      <Button
        onClick={() => {
          handle?.cancel();
          useView.setState({ strand: null });
        }}
      >
        End strand <kbd>Esc</kbd>
      </Button>
    </div>
  );
}
