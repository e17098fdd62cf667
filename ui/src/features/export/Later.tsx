import { Button } from "../../shared/controls/Button";
import { useDesign } from "../../state/design/design";
import { saveAs, saveJob, saveWireframe } from "../../state/files/files";

/** What is kept to resume with: the document, and the job. */
export function Later() {
  const empty = useDesign((design) => design.edges.size === 0);
  return (
    <div className="stack">
      <div className="row wrap">
        <Button icon="save" onClick={() => void saveAs()}>
          Document…
        </Button>
        <Button icon="wire" why={empty ? "The design is empty." : null} onClick={() => void saveWireframe()}>
          Wireframe…
        </Button>
        <Button icon="file" why={empty ? "The design is empty." : null} onClick={() => void saveJob()}>
          Job…
        </Button>
      </div>
      <p className="muted small">
        The document keeps everything that can be edited. The wireframe is an OBJ file of lines for other programs. The
        job is a fixed copy of the programs and profiles as they are now, ready to run on a machine.
      </p>
    </div>
  );
}
