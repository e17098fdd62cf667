import { Button } from "../../../shared/controls/Button";
import { count } from "../../../shared/figures/format";
import { compareVersions, takeVersion, useCalibration } from "../../../state/calibration/calibration";
import { useDesign } from "../../../state/design/design";
import { useMachines } from "../../../state/machine/machines";
import { Compared } from "./Compared";
import { versionsOf } from "./words";

const TAKEN = ". The design has it.";

/** What calibrations made, and what they were made from: compared with the machine of the design, and taken for it. */
export function Versions() {
  const { versions, busy } = useCalibration();
  const { machines } = useMachines();
  const machine = useDesign((design) => design.state?.machine ?? null);
  const wire = useDesign((design) => design.state?.material ?? null);
  const list = versionsOf(machines ?? []);
  return (
    <div className="calibrate-columns">
      <div className="stack">
        <p>
          Each calibration that was applied is a version of a machine and of the wire that it was calibrated with. Take
          any of them for the design, or go back to what it was made from.
        </p>
        <ul className="stack">
          {list.map(({ id, name, material, calibrated }) => {
            const taken = id === machine && material === wire;
            const why = busy ? "Wait until this is done." : taken ? "The design has it." : null;
            return (
              <li key={`${id} ${material}`} className="row calibrate-version" aria-current={taken || undefined}>
                <div className="grow">
                  <p className="selectable">
                    {name} with {material}
                  </p>
                  {/* As many lines with and without its last sentence: the buttons below stay where they are. */}
                  <p className="muted small version-said" data-room={taken ? undefined : TAKEN}>
                    {calibrated
                      ? `Calibrated ${calibrated.date} from ${count(calibrated.readings, "reading")}, made from ${calibrated.machine}`
                      : "Not calibrated"}
                    {taken && TAKEN}
                  </p>
                </div>
                <Button small why={why} aria-label={`Compare ${id}`} onClick={() => void compareVersions(id)}>
                  Compare
                </Button>
                <Button small why={why} aria-label={`Use ${id}`} onClick={() => void takeVersion(id, material)}>
                  Use
                </Button>
              </li>
            );
          })}
        </ul>
      </div>
      {versions ? <Compared compared={versions} /> : <p className="muted">What differs is listed here.</p>}
    </div>
  );
}
