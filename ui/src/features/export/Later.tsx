import { Button } from "../../shared/controls/Button";
import { isRefused, useDesign } from "../../state/design/design";
import { chosenFormat, setDespiteErrors, useExports } from "../../state/files/exports";
import { saveAs, saveJob, saveWireframe } from "../../state/files/files";
import { Anyway } from "../check/Anyway";

/** What is kept to resume with: the document, and the job. */
export function Later() {
  const empty = useDesign((design) => design.edges.size === 0);
  const refused = useDesign(isRefused);
  const store = useExports();
  const whyNoJob = empty
    ? "The design is empty."
    : refused && !store.despiteErrors
      ? "The machine cannot bend this: see above."
      : null;
  return (
    <div className="stack">
      {/* Of a program it is said above. */}
      {refused && !empty && !chosenFormat(store)?.program && (
        <Anyway checked={store.despiteErrors} onChange={setDespiteErrors}>
          Save the job anyway
        </Anyway>
      )}
      <div className="row wrap">
        <Button icon="save" onClick={() => void saveAs()}>
          Document…
        </Button>
        <Button icon="wire" why={empty ? "The design is empty." : null} onClick={() => void saveWireframe()}>
          Wireframe…
        </Button>
        <Button icon="file" why={whyNoJob} onClick={() => void saveJob()}>
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
