import { Button } from "../../shared/Button";
import { useDesign } from "../../state/design";
import { saveAs, saveJob, saveWireframe } from "../../state/files";

/** What is kept to go on with: the document, and the job. */
export function Later() {
  const empty = useDesign((design) => design.edges.size === 0);
  return (
    <div className="stack">
      <div className="row wrap">
        <Button icon="save" onClick={() => void saveAs()}>
          Document…
        </Button>
        <Button icon="wire" why={empty ? "There is nothing in the design." : null} onClick={() => void saveWireframe()}>
          Wireframe…
        </Button>
        <Button icon="file" why={empty ? "There is nothing in the design." : null} onClick={() => void saveJob()}>
          Job…
        </Button>
      </div>
      <p className="muted small">The document keeps everything that can be edited. The wireframe is an OBJ of lines for other programs. The job is sealed: programs and profiles as they are now, to be made on a machine.</p>
    </div>
  );
}
