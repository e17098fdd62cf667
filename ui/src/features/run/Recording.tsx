import { useState } from "react";
import { platform } from "../../platform";
import { Button } from "../../shared/Button";
import { count } from "../../shared/format";
import { useUnit } from "../../shared/unit";
import { clearRecording, order, saveRecording, useRun } from "../../state/run";
import type { MachineState } from "../../state/operator";
import { buttons } from "./buttons";
import { movePhrase } from "./phrases";
import { useProspect } from "./prospect";

const MOVES = { name: "Moves", extensions: ["wbmoves"] } as const;

/** Moves that were made by hand and kept: saved, made again, forgotten. */
export function Recording({ state, record }: { readonly state: MachineState; readonly record: boolean }) {
  const recorded = useRun((run) => run.recorded);
  const unit = useUnit();
  const [file, setFile] = useState<string | null>(null);
  const all = buttons(state, useProspect());
  const none = recorded.length === 0 ? "No moves are recorded." : null;
  const save = async () => {
    const path = await platform.pickSave("moves.wbmoves", MOVES);
    if (path !== null) setFile(await saveRecording(path));
  };
  const replay = async () => {
    const picked = await platform.pickFile([MOVES]);
    if (picked !== null) await order({ order: "replay", file: picked });
  };
  if (recorded.length === 0 && !record) {
    return (
      <div className="row end">
        <Button kind="link" why={all.replay} onClick={() => void replay()}>
          Replay a file…
        </Button>
      </div>
    );
  }
  return (
    <div className="stack">
      <div className="recorded" tabIndex={0} role="region" aria-label="Recorded moves">
        {none ? (
          <span className="muted">Moves that you make now are kept here.</span>
        ) : (
          <ol>
            {recorded.map((move, index) => (
              <li key={index}>{movePhrase(move, unit)}</li>
            ))}
          </ol>
        )}
      </div>
      <div className="row wrap">
        <span className="grow muted small">{file ? `Saved: ${file}` : count(recorded.length, "move")}</span>
        <Button small why={none} onClick={() => void clearRecording()}>
          Clear
        </Button>
        <Button small why={none} onClick={() => void save()}>
          Save…
        </Button>
        <Button small why={all.replay} onClick={() => void replay()}>
          Replay…
        </Button>
      </div>
    </div>
  );
}
