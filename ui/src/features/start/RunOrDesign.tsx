import { useState } from "react";
import { Button } from "../../shared/controls/Button";
import { count } from "../../shared/figures/format";
import { useLengths } from "../../shared/figures/unit";
import { Dialog } from "../../shared/layers/Dialog";
import { baseName, type Opening, openAs, type RunUse, runFile, useFiles } from "../../state/files/files";

const USES: Readonly<Record<"program" | "moves", Readonly<Record<RunUse, readonly [string, string]>>>> = {
  program: {
    run: ["Run it as it stands", "Shown, checked and run unchanged. Nothing is compensated."],
    design: ["Make it a design", "The shape that it leaves on this machine, to edit and to plan."],
  },
  moves: {
    run: ["Replay it", "Shown, and replayed move by move."],
    design: ["Make it a design", "The shape that the moves leave, to edit and to plan."],
  },
};

/** What becomes of a program of the machine's own format, or of recorded moves. */
export function RunOrDesign({ opening }: { readonly opening: Opening }) {
  const { path, look } = opening;
  const [choice, setChoice] = useState<RunUse>(opening.use ?? "run");
  const [busy, setBusy] = useState(false);
  const { bare, length } = useLengths();
  const close = () => useFiles.setState({ opening: null });
  const uses = USES[look.seen === "moves" ? "moves" : "program"];
  const submit = async () => {
    setBusy(true);
    try {
      await (choice === "run" ? runFile(path) : openAs({ input: { file: path } }, null));
    } finally {
      setBusy(false);
    }
  };
  const size = look.size_mm;
  return (
    <Dialog
      title={`Open ${baseName(path)}`}
      onClose={close}
      actions={
        <>
          <Button onClick={close}>Cancel</Button>
          <Button kind="primary" data-first why={busy ? "Reading the file" : null} onClick={() => void submit()}>
            Open
          </Button>
        </>
      }
    >
      <p className="muted">
        {count(look.edges, "edge")}
        {size && ` · ${bare(size[0])} × ${bare(size[1])} × ${length(size[2])}`}
      </p>
      <fieldset className="uses">
        <legend className="muted">What to do with it</legend>
        {(["run", "design"] as const).map((value) => (
          <label key={value} className="use">
            <input type="radio" name="use" checked={choice === value} onChange={() => setChoice(value)} />
            <span>
              <strong>{uses[value][0]}</strong>
              <span className="muted">{uses[value][1]}</span>
            </span>
          </label>
        ))}
      </fieldset>
    </Dialog>
  );
}
