import { Button } from "../../shared/controls/Button";
import { useDesign } from "../../state/design/design";
import { openExample, useFiles } from "../../state/files/files";
import { useByHand } from "../../state/machine/by_hand";
import { useRunFile } from "../../state/program/run_file";
import { run } from "../../state/window/commands";
import { useView } from "../../state/window/view";
import { useNeededExamples } from "./examples";
import { Picture } from "./Picture";
import "./start.css";

/** Those that show most at first glance. */
const SHOWN = ["house", "phone-stand", "bunny"];

function Cards() {
  const examples = useNeededExamples();
  const shown = SHOWN.flatMap((id) => examples?.find((example) => example.id === id) ?? []);
  return (
    <ul className="start-cards">
      {(examples ? shown : SHOWN.map(() => null)).map((example, index) => (
        <li key={example?.id ?? index}>
          {example ? (
            <button type="button" className="card" onClick={() => void openExample(example.id, example.name)}>
              <Picture lines={example.lines_mm} width={176} height={120} />
              <span className="card-name">{example.name}</span>
            </button>
          ) : (
            <div className="card" aria-hidden="true" />
          )}
        </li>
      ))}
    </ul>
  );
}

/** What there is to do while the design is empty. It goes as soon as there is something to see, or a tool is chosen. */
export function EmptyState() {
  const empty = useDesign(
    ({ vertices, surfaces, state }) => state !== null && vertices.size === 0 && surfaces.size === 0,
  );
  const drawing = useView(({ tool }) => tool !== "select");
  const busy = useFiles((files) => files.busy);
  const byHand = useByHand(({ played }) => played !== null);
  const file = useRunFile((run) => run.file !== null);
  if (!empty || drawing || byHand || file) return null;
  return (
    <div className="start" aria-busy={busy !== null}>
      <h2>Drop a model or a drawing here</h2>
      <p className="muted">
        STL, OBJ, PLY, 3MF or glTF to trace on or to bend along its edges; SVG and DXF drawings; tables of bends.
      </p>
      <div className="row">
        <Button kind="primary" icon="folder" onClick={() => run("open")}>
          Open…
        </Button>
        <Button icon="draw" onClick={() => run("tool-draw")}>
          Draw on a plane
        </Button>
      </div>
      <div className="start-or muted small">or begin with an example</div>
      <Cards />
      <Button kind="link" onClick={() => run("examples")}>
        All examples
      </Button>
    </div>
  );
}
