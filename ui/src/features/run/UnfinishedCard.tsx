import { useState } from "react";
import { Button } from "../../shared/controls/Button";
import { Either } from "../../shared/controls/Either";
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
        {leaving
          ? "Once it is given up, it cannot be resumed. Giving it up moves nothing."
          : unfinishedPhrase(unfinished)}
      </p>
      <div className={resumable ? "row end" : "row end turned"}>
        {leaving ? (
          <>
            {/* Where the button was that was clicked, so that a second click gives nothing up. */}
            <Button onClick={() => setLeaving(false)}>
              <Either shown="Keep it" other="Give up…" />
            </Button>
            <Button kind="danger" why={all.abandon} onClick={() => void order({ order: "abandon", job_hash, wire })}>
              <Either shown="Give it up" other="Resume…" />
            </Button>
          </>
        ) : (
          <>
            <Button why={all.abandon} onClick={() => setLeaving(true)}>
              <Either shown="Give up…" other="Keep it" />
            </Button>
            {resumable && (
              <Button
                kind="primary"
                why={all.resumeRun}
                onClick={() => void order({ order: "resume-run", job_hash, wire, accept_settings: accept })}
              >
                <Either shown="Resume…" other="Give it up" />
              </Button>
            )}
          </>
        )}
      </div>
    </fieldset>
  );
}
