import { useEffect, useState } from "react";
import type { DriverEntry } from "../../../generated/responses";
import { errorText } from "../../../platform/error_text";
import { Button } from "../../../shared/controls/Button";
import { Line } from "../../../shared/lists/Line";
import type { Tone } from "../../../shared/lists/Mark";
import { loadDrivers, useMachines } from "../../../state/machine/machines";
import { TrustDialog } from "./TrustDialog";

const STATES: Readonly<Record<DriverEntry["state"], readonly [Tone, string]>> = {
  shipped: ["fine", "comes with the program"],
  accepted: ["fine", "trusted by you"],
  unknown: ["warning", "not trusted: it is not run"],
  changed: ["warning", "has changed since it was trusted: it is not run"],
  refused: ["error", "cannot be used"],
};

/** Whether a person has to say that it may run. */
export const waits = ({ state }: DriverEntry): boolean => state === "unknown" || state === "changed";

/** The drivers: where they come from, and accepting those of others. */
export function Drivers() {
  const drivers = useMachines((store) => store.drivers);
  const changes = useMachines((store) => store.changes);
  const [trusting, setTrusting] = useState<DriverEntry | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: a changed profile may name another driver
  useEffect(() => void loadDrivers(), [changes]);
  if (!drivers) return <p className="muted">Loading drivers…</p>;
  return (
    <>
      <ul>
        {drivers.drivers
          .toSorted((a, b) => Number(waits(b)) - Number(waits(a)))
          .map((driver) => {
            const [tone, state] = STATES[driver.state];
            const offered = waits(driver);
            // That it is not accepted is all that is wrong with it.
            const problem =
              offered || !driver.problem ? null : errorText({ message: driver.problem, remedies: driver.remedies });
            const file = driver.file.slice(Math.max(driver.file.lastIndexOf("/"), driver.file.lastIndexOf("\\")) + 1);
            return (
              <Line
                key={driver.file}
                tone={problem ? "error" : tone}
                what={driver.name ? `${driver.name} ${driver.version ?? ""}` : file}
                sub={
                  <>
                    {state}
                    {problem ? `. ${problem}` : driver.machines.length > 0 ? ` · ${driver.machines.join(", ")}` : ""}
                  </>
                }
                action={
                  offered && (
                    <Button kind="link" onClick={() => setTrusting(driver)}>
                      Trust…
                    </Button>
                  )
                }
                title={driver.file}
              />
            );
          })}
        {drivers.missing.map((missing) => (
          <Line key={missing} tone="error" what={missing} sub="The file is missing." />
        ))}
      </ul>
      {trusting && <TrustDialog driver={trusting} onClose={() => setTrusting(null)} />}
    </>
  );
}
