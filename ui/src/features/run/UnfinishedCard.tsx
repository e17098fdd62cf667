import { useState } from "react";
import { Button } from "../../shared/controls/Button";
import { Mark } from "../../shared/lists/Mark";
import type { Unfinished } from "../../state/machine/operator";
import { order } from "../../state/machine/run";
import type { RunButtons } from "./buttons";
import { unfinishedPhrase } from "./phrases";

/** A wire that was interrupted: resuming it, or giving it up. */
export function UnfinishedCard({
  unfinished,
  all,
  accept,
}: {
  readonly unfinished: Unfinished;
  readonly all: RunButtons;
  readonly accept: boolean;
}) {
  const [leaving, setLeaving] = useState(false);
  const { job_hash, wire, name, resumable } = unfinished;
  // The first wire of a design is nearly always its only one.
  const which = wire > 0 ? `${name ? `“${name}”, ` : ""}wire ${wire + 1}` : name ? `“${name}”` : "A wire";
  return (
    <fieldset className="unfinished stack" aria-label="Interrupted wire">
      <p>
        <Mark tone="warning" /> <strong>{which} was interrupted</strong>
      </p>
      <p className="muted">
        {leaving ? "Once it is given up, it cannot be resumed. Nothing moves for it." : unfinishedPhrase(unfinished)}
      </p>
      <div className="row end">
        {leaving ? (
          <>
            <Button onClick={() => setLeaving(false)}>Keep it</Button>
            <Button kind="danger" why={all.abandon} onClick={() => void order({ order: "abandon", job_hash, wire })}>
              Give it up
            </Button>
          </>
        ) : (
          <>
            <Button why={all.abandon} onClick={() => setLeaving(true)}>
              Give up…
            </Button>
            {resumable && (
              <Button
                kind="primary"
                why={all.resumeRun}
                onClick={() => void order({ order: "resume-run", job_hash, wire, accept_settings: accept })}
              >
                Resume…
              </Button>
            )}
          </>
        )}
      </div>
    </fieldset>
  );
}
