import type { Shown as ShownName } from "../../scene/interface";
import { Segmented } from "../../shared/inputs";
import { useLengths } from "../../shared/unit";
import { chooseShown, usePlayback, useProgram } from "../../state/program";
import { worst } from "./steps";

/** The wire as it is designed, as the machine makes it, or both. */
export function Shown() {
  const { made, askingMade, wire, program } = useProgram();
  const shown = usePlayback((playback) => playback.shown);
  const { unit, said } = useLengths();
  const told = program?.wires[wire]?.steps.every((step) => step.told !== null) ?? false;
  const why = told ? null : "The wire is not compensated, so that nobody knows how it is made: see Check.";
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
        {askingMade ? "Bending it…" : off ? `${off}, ${made?.by_machine ? "on the simulated machine" : "by formulas alone: this machine is not simulated"}` : "“As made” works out what the machine makes of it."}
      </p>
      {made?.notes.map((note) => (
        <p key={note.code + note.message} className="muted small">
          {said(note.message)}
        </p>
      ))}
    </div>
  );
}
