import { useEffect } from "react";
import { Button } from "../../shared/controls/Button";
import { FileProblem, WrittenFiles } from "../../shared/lists/FileOutcome";
import { type FrameFile, forgetFrameFiles, replaceFrameFile, saveFrame, useFrameFiles } from "../../state/frame/files";
import { useFrame, useFrameStale } from "../../state/frame/frame";
import { Part } from "../panel/Section";

const BUTTONS: readonly (readonly [FrameFile, string, string])[] = [
  ["vtk", "VTK…", "Displacements and forces, for ParaView"],
  ["csv", "CSV…", "Two tables: of the nodes, and of the members"],
  ["glb", "glTF…", "The deformed shape as a model, enlarged as it is shown"],
  ["conmech", "conmech…", "The frame as it is computed, and its loads, in two files"],
];

/** What the loaded frame is written as for other programs. */
export function Files() {
  const { busy, written, notes, problem } = useFrameFiles();
  const answer = useFrame((frame) => frame.answer);
  const stale = useFrameStale();
  // biome-ignore lint/correctness/useExhaustiveDependencies: what was written is of the answer of before
  useEffect(() => forgetFrameFiles, [answer]);
  const why = !answer?.value.shapes.loaded
    ? "The frame floats, or does not stand."
    : stale
      ? "Changed since it was computed."
      : busy
        ? "A file is being written."
        : null;
  return (
    <Part title="Files of the loaded frame">
      <div className="stack">
        {problem && <FileProblem problem={problem} replace={() => void replaceFrameFile()} />}
        <div aria-live="polite" className="frame-written">
          <WrittenFiles files={written} />
          {notes.map((note) => (
            <p key={note} className="muted small">
              {note}
            </p>
          ))}
        </div>
        <div className="row wrap">
          {BUTTONS.map(([file, label, title]) => (
            <Button key={file} small why={why} title={title} onClick={() => void saveFrame(file)}>
              {label}
            </Button>
          ))}
        </div>
      </div>
    </Part>
  );
}
