/** A job, a program or a recording that is open to be shown and run; the design stays as it is behind it. */

import { create } from "zustand";
import type { RunFileNow, RunFileReport } from "../../generated/responses";
import { platform } from "../../platform";
import { told } from "../asking/problems";
import { asking } from "../asking/work";
import { useDesign } from "../design/design";

interface RunFileStore {
  /** Null: the design is shown and run. */
  readonly file: RunFileReport | null;
  /** How often another one was opened, or it was closed. */
  readonly opened: number;
}

export const useRunFile = create<RunFileStore>()(() => ({ file: null, opened: 0 }));

function took(now: RunFileNow | null): boolean {
  if (now) useRunFile.setState(({ opened }) => ({ file: now.file, opened: opened + 1 }));
  return now !== null;
}

/** Opens a file to be run; false where it cannot be. */
export async function openRunFile(path: string): Promise<boolean> {
  return took(await told(asking("open-run-file", { file: { file: path } })));
}

/** Has what is open checked with the profiles as they are; a job has its own in it. What cannot be checked is closed. */
export async function checkRunFile(): Promise<void> {
  const { file, opened } = useRunFile.getState();
  if (!file || file.kind === "job") return;
  const now = await told(asking("check-run-file", {}));
  if (!now) await loadRunFile();
  else if (useRunFile.getState().opened === opened) useRunFile.setState({ file: now.file });
}

/** The design is shown and run again. */
export async function closeRunFile(): Promise<void> {
  took(await told(platform.ask("close-run-file", {})));
}

/** Takes what the Rust side has open, such as after the window was loaded anew. */
export async function loadRunFile(): Promise<void> {
  took(await told(platform.ask("run-file", {})));
}

/** It was closed with the design that was open. */
export function forgetRunFile(): void {
  if (useRunFile.getState().file) took({ file: null });
}

/** The machine of what is run: that of the file, or of the design. */
export function useRunMachine(): string | null {
  const designed = useDesign(({ state }) => state?.machine ?? null);
  return useRunFile(({ file }) => file?.machine ?? null) ?? designed;
}

/** What the checks say of the file that is run; null where the design is. */
export function useRunFindings(): { readonly diagnostics: RunFileReport["findings"] } | null {
  const findings = useRunFile(({ file }) => file?.findings ?? null);
  return findings && { diagnostics: findings };
}
