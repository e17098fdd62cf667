import { platform } from "../../platform";
import { Button } from "../../shared/controls/Button";
import { told } from "../../state/asking/problems";
import { baseName } from "../../state/files/files";
import { chooseFrame, useFrame } from "../../state/frame/frame";

const LISTS = { name: "Lists of faces", extensions: ["json"] };

/** Which faces are to be flat: what the closed shape is measured on. */
export function Faces() {
  const faces = useFrame((frame) => frame.faces);
  const pick = async () => {
    const path = await told(platform.pickFile([LISTS]));
    if (path) chooseFrame({ faces: path });
  };
  return (
    <div className="field frame-file">
      <span className="field-name">Shape of</span>
      <span className="row">
        <span className="grow ellipsis" title={faces ?? undefined}>
          {faces === null ? "all vertices" : baseName(faces)}
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
  );
}
