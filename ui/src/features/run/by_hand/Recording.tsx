import { useState } from "react";
import { platform } from "../../../platform";
import { Button } from "../../../shared/controls/Button";
import { count } from "../../../shared/figures/format";
import { useUnit } from "../../../shared/figures/unit";
import { Mark } from "../../../shared/lists/Mark";
import { Scrolls } from "../../../shared/lists/Scrolls";
import { told } from "../../../state/asking/problems";
import { openPath } from "../../../state/files/files";
import type { MachineState } from "../../../state/machine/operator";
import { clearRecording, order, saveRecording, useRun } from "../../../state/machine/run";
import { buttons } from "../buttons";
import { movePhrase } from "../phrases";
import { useProspect } from "../prospect";

/** Why moves are not run at once: they were recorded on another machine, or before its profile was changed. */
const OF_ANOTHER = "moves-of-another";

const MOVES = { name: "Moves", extensions: ["wbmoves"] } as const;

/** Moves by hand that were kept: saved, replayed, forgotten. */
export function Recording({ state, record }: { readonly state: MachineState; readonly record: boolean }) {
  const recorded = useRun((run) => run.recorded);
  const unit = useUnit();
  const [file, setFile] = useState<string | null>(null);
  const [replayed, setReplayed] = useState<string | null>(null);
  const all = buttons(state, useProspect());
  const none = recorded.length === 0 ? "No moves are recorded." : null;
  const save = async () => {
    const path = await told(platform.pickSave("moves.wbmoves", MOVES));
    const saved = path === null ? null : await saveRecording(path);
    if (saved !== null) setFile(saved);
    return saved;
  };
  // A design says which file it comes from: the moves are in one before it is made.
  const makeDesign = async () => {
    const saved = await save();
    if (saved !== null) await openPath(saved, "design", "design");
  };
  const replayFile = async () => {
    const picked = await told(platform.pickFile([MOVES]));
    if (picked === null) return;
    setReplayed(picked);
    await order({ order: "replay", file: picked });
  };
  const foreign = replayed !== null && state.problem?.code === OF_ANOTHER;
  const asked = foreign && (
    <fieldset className="unfinished stack" aria-label="Moves of another machine">
      <p>
        <Mark tone="warning" /> These moves were not recorded on this machine as it is now. Check that there is room for
        them.
      </p>
      <div className="row end">
        <Button onClick={() => setReplayed(null)}>Cancel</Button>
        <Button
          kind="primary"
          why={all.replay}
          onClick={() => void order({ order: "replay", file: replayed, other_machine: true })}
        >
          Replay anyway
        </Button>
      </div>
    </fieldset>
  );
  if (recorded.length === 0 && !record) {
    return (
      <>
        {asked}
        <div className="row end">
          <Button kind="link" why={all.replay} onClick={() => void replayFile()}>
            Replay a file…
          </Button>
        </div>
      </>
    );
  }
  return (
    <div className="stack">
      {asked}
      {/* The buttons first: the list grows with each move, and they stay where the pointer is. */}
      <div className="row wrap end">
        <span className="muted small">{count(recorded.length, "move")}</span>
        <Button small why={none} onClick={() => void clearRecording()}>
          Clear
        </Button>
        <Button small why={none} onClick={() => void save()}>
          Save…
        </Button>
        <Button
          small
          why={none}
          title="Saves the moves first, then opens the shape that they leave"
          onClick={() => void makeDesign()}
        >
          Make it a design…
        </Button>
        <Button
          small
          why={none ?? all.replay}
          title={`Homes the machine, then makes the ${count(recorded.length, "recorded move")} again`}
          // A person is asked before anything moves, by the Rust side.
          onClick={() => void order({ order: "replay", file: null })}
        >
          Replay
        </Button>
        <Button small why={all.replay} onClick={() => void replayFile()}>
          Replay a file…
        </Button>
      </div>
      <Scrolls className="recorded" label="Recorded moves">
        {none ? (
          <span className="muted">Your moves are recorded here.</span>
        ) : (
          <ol>
            {recorded.map((move, index) => (
              // biome-ignore lint/suspicious/noArrayIndexKey: moves are only added at the end
              <li key={index}>{movePhrase(move, unit)}</li>
            ))}
          </ol>
        )}
      </Scrolls>
      {file && (
        <p className="written small" role="status">
          <span className="muted">Saved: </span>
          <span className="selectable">{file}</span>
        </p>
      )}
    </div>
  );
}
