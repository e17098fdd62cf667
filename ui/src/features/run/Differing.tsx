import { Button } from "../../shared/Button";
import { Checkbox } from "../../shared/inputs";
import { Line } from "../../shared/Line";
import type { MachineState } from "../../state/operator";
import { order } from "../../state/run";

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
    <div className="inset stack" role="group" aria-label="Settings that differ">
      <ul>
        {settings.map(({ name, machine, expected, matters }) => (
          <Line key={name} tone={matters ? "warning" : "info"} what={name} sub={`The machine has ${machine}, the profile says ${expected}.`} />
        ))}
      </ul>
      <div className="row end">
        <Button why={why} title="It asks before it writes anything" onClick={() => void order({ order: "write-settings" })}>
          Set the machine as its profile says…
        </Button>
      </div>
      {settings.some(({ matters }) => matters) && (
        <Checkbox checked={accept} onChange={onAccept}>
          Make wires all the same: they may come out wrong
        </Checkbox>
      )}
    </div>
  );
}
