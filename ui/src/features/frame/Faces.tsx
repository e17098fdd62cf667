import { platform } from "../../platform";
import { Button } from "../../shared/controls/Button";
import { count } from "../../shared/figures/format";
import { told } from "../../state/asking/problems";
import { useDesign } from "../../state/design/design";
import { select, useSelection, verticesOf } from "../../state/design/selection";
import { whyNoFace, withFace, withoutFace } from "../../state/frame/faces";
import { chooseFrame, useFrame } from "../../state/frame/frame";
import { frame } from "../../state/window/view";
import { nameOfFaces } from "./faces_name";

const LISTS = { name: "Lists of faces", extensions: ["json"] };

/** Which faces are to be flat: what the closed shape is measured on. */
export function Faces() {
  const faces = useFrame((store) => store.faces);
  const pick = async () => {
    const path = await told(platform.pickFile([LISTS]));
    if (path) chooseFrame({ faces: { file: path } });
  };
  return (
    <>
      <div className="field frame-file">
        <span className="field-name">Shape of</span>
        <span className="row">
          <span className="grow ellipsis" title={faces && "file" in faces ? faces.file : undefined}>
            {faces === null ? "all vertices" : nameOfFaces(faces)}
          </span>
          {faces !== null && (
            <Button
              kind="quiet"
              small
              icon="close"
              aria-label="All vertices"
              title="All vertices"
              onClick={() => chooseFrame({ faces: null })}
            />
          )}
          <Button
            small
            title="A JSON list of lists of vertices, such as [[0, 1, 2, 3]]: each face is measured from the plane that fits it best"
            onClick={() => void pick()}
          >
            Faces…
          </Button>
        </span>
      </div>
      <Selected />
    </>
  );
}

/** Faces of selected vertices. */
function Selected() {
  const faces = useFrame((store) => store.faces);
  const selection = useSelection();
  const design = useDesign();
  const selected = verticesOf(selection, design);
  const go = (vertices: readonly number[]) => {
    select(vertices);
    frame(vertices, []);
  };
  return (
    <>
      <div className="row">
        <span className="grow muted small">
          {selected.length === 0 ? "Nothing is selected." : `${count(selected.length, "vertex", "vertices")} selected`}
        </span>
        <Button
          small
          icon="plus"
          why={whyNoFace(faces, selected)}
          onClick={() => chooseFrame({ faces: withFace(faces, selected) })}
        >
          Add as a face
        </Button>
      </div>
      {faces && "vertices" in faces && (
        <ul className="frame-forces" aria-label="Faces">
          {faces.vertices.map((face, at) => (
            <li key={face.join()}>
              <button type="button" className="button link" onClick={() => go(face)}>
                face {at + 1}
              </button>
              <span className="grow ellipsis muted">{count(face.length, "vertex", "vertices")}</span>
              <Button
                kind="quiet"
                small
                icon="close"
                aria-label={`Remove face ${at + 1}`}
                title="Remove"
                onClick={() => chooseFrame({ faces: withoutFace(faces, face) })}
              />
            </li>
          ))}
        </ul>
      )}
    </>
  );
}
