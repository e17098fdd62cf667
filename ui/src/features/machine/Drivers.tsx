import { useEffect, useState } from "react";
import type { DriverEntry } from "../../generated/responses";
import { Button } from "../../shared/Button";
import { Line } from "../../shared/Line";
import type { Tone } from "../../shared/Mark";
import { loadDrivers, useMachines } from "../../state/machines";
import { TrustDialog } from "./TrustDialog";

const STATES: Readonly<Record<DriverEntry["state"], readonly [Tone, string]>> = {
  shipped: ["fine", "comes with the program"],
  accepted: ["fine", "accepted by you"],
  unknown: ["warning", "not accepted: it is not run"],
  changed: ["warning", "has changed since it was accepted: it is not run"],
  refused: ["error", "cannot be used"],
};

/** Whether a person has to say that it may run. */
export const waits = ({ state }: DriverEntry): boolean => state === "unknown" || state === "changed";

/** The drivers: where they come from, and accepting those of others. */
export function Drivers() {
  const drivers = useMachines((store) => store.drivers);
  const changes = useMachines((store) => store.changes);
  const [trusting, setTrusting] = useState<DriverEntry | null>(null);
  useEffect(() => void loadDrivers(), [changes]);
  if (!drivers) return <p className="muted">Asking the drivers…</p>;
  return (
    <>
      <ul>
        {drivers.drivers.toSorted((a, b) => Number(waits(b)) - Number(waits(a))).map((driver) => {
          const [tone, state] = STATES[driver.state];
          const offered = waits(driver);
          // That it is not accepted is all that is wrong with it.
          const problem = offered ? null : driver.problem;
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
          <Line key={missing} tone="error" what={missing} sub="It was named and is not there." />
        ))}
      </ul>
      {trusting && <TrustDialog driver={trusting} onClose={() => setTrusting(null)} />}
    </>
  );
}
