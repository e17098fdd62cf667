import { useEffect, useState } from "react";
import type { DriverEntry, DriverTrustResponse } from "../../generated/responses";
import { platform } from "../../platform";
import { Button } from "../../shared/Button";
import { Dialog } from "../../shared/Dialog";
import { Checkbox } from "../../shared/inputs";
import { profilesChanged } from "../../state/machines";

/** A hash in groups of eight, which can be compared by eye. */
export const inGroups = (hash: string): string => (hash.match(/.{1,8}/g) ?? []).join(" ");

/** Accepts a library by somebody else, as it is now. */
export function TrustDialog({ driver, onClose }: { readonly driver: DriverEntry; readonly onClose: () => void }) {
  const [seen, setSeen] = useState<DriverTrustResponse | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const [sure, setSure] = useState(false);
  const [busy, setBusy] = useState(false);
  const ask = async (sha256: string | null) => {
    setBusy(true);
    setProblem(null);
    try {
      const answer = await platform.ask("trust-driver", { library: driver.file, sha256 });
      if (answer.accepted) {
        profilesChanged(null);
        onClose();
      } else {
        setSeen(answer);
      }
    } catch (error) {
      setProblem(error instanceof Error ? error.message : String(error));
    } finally {
      setBusy(false);
    }
  };
  // Without a hash nothing is accepted and nothing is run: it only tells the hash.
  useEffect(() => void ask(null), []);
  const why = busy ? "It is being looked at." : !seen ? "Its hash is not known." : !sure ? "Say first that you trust whoever made it." : null;
  return (
    <Dialog
      title={driver.state === "changed" ? "Trust a driver that has changed" : "Trust a driver"}
      onClose={onClose}
      actions={
        <>
          <Button data-first onClick={onClose}>
            Cancel
          </Button>
          <Button kind="danger" why={why} onClick={() => void ask(seen?.sha256 ?? null)}>
            Trust and run it
          </Button>
        </>
      }
    >
      <p>
        A driver is a program. Once it is trusted it runs with your rights: it can read and write your files, and it moves your machine. Only trust one that comes from somebody you know, and
        whose hash they have told you.
      </p>
      {driver.state === "changed" && <p className="field-below wrong">The file is not the one that was accepted before. If you have not replaced it yourself, find out who has.</p>}
      <dl className="pairs">
        <div>
          <dt>File</dt>
          <dd className="selectable">{seen?.library ?? driver.file}</dd>
        </div>
        <div>
          <dt>SHA-256</dt>
          <dd className="selectable hash">{seen ? inGroups(seen.sha256) : "…"}</dd>
        </div>
      </dl>
      <Checkbox checked={sure} onChange={setSure}>
        I have compared the hash, and I trust whoever made this file.
      </Checkbox>
      {problem && (
        <p className="field-below wrong" role="alert">
          {problem}
        </p>
      )}
    </Dialog>
  );
}
