import { Button } from "../../shared/controls/Button";
import { Checkbox } from "../../shared/controls/inputs";
import { Line } from "../../shared/lists/Line";
import type { MachineState } from "../../state/machine/operator";
import { order } from "../../state/machine/run";

/** How the machine is set otherwise than its profile says: to be set right, or to be put up with. */
export function Differing({
  settings,
  why,
  accept,
  onAccept,
}: {
  readonly settings: MachineState["settings"];
  /** Why they cannot be written now. */
  readonly why: string | null;
  readonly accept: boolean;
  readonly onAccept: (accept: boolean) => void;
}) {
  return (
    <fieldset className="inset stack" aria-label="Settings that differ">
      <ul>
        {settings.map(({ name, machine, expected, matters }) => (
          <Line
            key={name}
            tone={matters ? "warning" : "info"}
            what={name}
            sub={`The machine has ${machine}, the profile says ${expected}.`}
          />
        ))}
      </ul>
      <div className="row end">
        <Button
          why={why}
          title="It asks before it writes anything"
          onClick={() => void order({ order: "write-settings" })}
        >
          Set the machine as its profile says…
        </Button>
      </div>
      {settings.some(({ matters }) => matters) && (
        <Checkbox checked={accept} onChange={onAccept}>
          Bend anyway: wires may come out wrong
        </Checkbox>
      )}
    </fieldset>
  );
}
