import { Button } from "../../shared/Button";
import { count } from "../../shared/format";
import { useDesign } from "../../state/design";
import { useView } from "../../state/view";

/** How the strand stands that is being drawn, and how it is ended. */
export function Strand() {
  const { tool, strand, handle } = useView();
  const stencil = useDesign((design) => design.stencil);
  if (tool === "select") return <p className="muted">Take up one of the two, then click in the view: each click places a vertex.</p>;
  if (strand === null) {
    return (
      <p className="muted" role="status">
        {tool === "draw" ? "Click on the plane to begin a strand; Shift keeps it to steps of 15°." : stencil ? "Click on the stencil to begin a strand." : "Click to begin a strand. Without a stencil it goes on the ground."}
      </p>
    );
  }
  return (
    <div className="row wrap" role="status">
      <span className="muted small">Type a length and Enter for an edge as long as that, towards the pointer.</span>
      <span className="grow">{count(strand, "edge")} drawn</span>
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
