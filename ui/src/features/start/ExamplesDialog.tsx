import { Dialog } from "../../shared/layers/Dialog";
import { openExample } from "../../state/files/files";
import { useUi } from "../../state/window/ui";
import { useNeededExamples } from "./examples";
import { Picture } from "./Picture";
import "./start.css";

/** All examples, with what there is to see in each. */
export function ExamplesDialog() {
  const shown = useUi(({ dialog }) => dialog === "examples");
  const close = () => useUi.getState().showDialog(null);
  return shown ? <Gallery close={close} /> : null;
}

function Gallery({ close }: { readonly close: () => void }) {
  const examples = useNeededExamples();
  return (
    <Dialog title="Examples" wide onClose={close}>
      {!examples && <p className="muted">Loading examples…</p>}
      <ul className="gallery">
        {examples?.map((example) => (
          <li key={example.id}>
            <button
              type="button"
              className="card"
              onClick={() => {
                close();
                void openExample(example.id, example.name);
              }}
            >
              <Picture lines={example.lines_mm} width={240} height={150} />
              <span className="card-name">{example.name}</span>
              <span className="card-text muted small">{example.description}</span>
            </button>
          </li>
        ))}
      </ul>
    </Dialog>
  );
}
