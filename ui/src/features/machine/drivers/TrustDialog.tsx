import { useEffect, useState } from "react";
import type { DriverEntry, DriverTrustResponse } from "../../../generated/responses";
import { platform } from "../../../platform";
import { Button } from "../../../shared/controls/Button";
import { Checkbox } from "../../../shared/controls/inputs";
import { Dialog } from "../../../shared/layers/Dialog";
import { profilesChanged } from "../../../state/machine/machines";

/** A hash in groups of eight, which can be compared by eye. */
const inGroups = (hash: string): string => (hash.match(/.{1,8}/g) ?? []).join(" ");

/** Accepts a third-party library, as it is now. */
export function TrustDialog({ driver, onClose }: { readonly driver: DriverEntry; readonly onClose: () => void }) {
  const [seen, setSeen] = useState<DriverTrustResponse | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const [sure, setSure] = useState(false);
  const [busy, setBusy] = useState(false);
  const ask = async (sha256: string | null) => {
    setBusy(true);
    setProblem(null);
    try {
      const answer = await platform.ask("driver-trust", { library: driver.file, sha256 });
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
  // Without a hash nothing is accepted and nothing is run: it only shows the hash.
  // biome-ignore lint/correctness/useExhaustiveDependencies: it is asked once, when the dialog is there
  useEffect(() => void ask(null), []);
  const why = busy
    ? "The file is being read."
    : !seen
      ? "The file's hash is not known."
      : !sure
        ? "Confirm first that you trust its author."
        : null;
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
        A driver is a program. Once trusted, it runs with your rights: it can read and write your files, and it moves
        your machine. Trust only a driver from an author you know, whose hash they have given you.
      </p>
      {driver.state === "changed" && (
        <p className="field-below wrong">
          This is not the file that was trusted before. If you did not replace it yourself, find out who did.
        </p>
      )}
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
        I have compared the hash, and I trust the author of this file.
      </Checkbox>
      {problem && (
        <p className="field-below wrong" role="alert">
          {problem}
        </p>
      )}
    </Dialog>
  );
}
