import type { Shown as ShownName } from "../../scene/interface";
import { Segmented } from "../../shared/controls/inputs";
import { useUnit } from "../../shared/figures/unit";
import { chooseShown, usePlayback, useProgram } from "../../state/program/program";
import { Notes } from "../panel/Notes";
import { worst } from "./steps";

/** The wire as it is designed, as the machine bends it, or both. */
export function Shown() {
  const { made, askingMade, wire, program } = useProgram();
  const shown = usePlayback((playback) => playback.shown);
  const unit = useUnit();
  const told = program?.wires[wire]?.steps.every((step) => step.told !== null) ?? false;
  const why = told ? null : "This wire has no compensated program. See Check.";
  const off = worst(made, wire, unit);
  return (
    <div className="stack">
      <Segmented<ShownName>
        label="What is shown"
        value={shown}
        onChoose={(chosen) => void chooseShown(chosen)}
        choices={[
          { value: "designed", label: "As designed" },
          { value: "made", label: "As made", why },
          { value: "both", label: "Both", why },
        ]}
      />
      {shown === "both" && made && (
        <p className="legend small">
          <span className="swatch designed" /> as designed <span className="swatch made" /> as made
        </p>
      )}
      <p className="muted small" aria-live="polite">
        {askingMade
          ? "Simulating…"
          : off
            ? `${off}, ${made?.by_machine ? "on the simulated machine" : "calculated: this machine has no simulator"}`
            : "“As made” simulates how the machine bends it."}
      </p>
      <Notes notes={made?.notes ?? []} />
    </div>
  );
}
