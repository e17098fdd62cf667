import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect } from "vitest";
import type { Editor } from "./editor.ts";
import { root } from "./places.ts";

/** What the sampled motions and the frames solved from nothing of `tests/brute` have against a sequence of the open design. */
async function faultsOf(editor: Editor, sequence: unknown): Promise<string> {
  const design = join(editor.loopback.home, "confirmed.wirebend");
  const file = join(editor.loopback.home, "confirmed.json");
  await editor.loopback.ask("save", { path: design });
  writeFileSync(file, JSON.stringify(sequence));
  try {
    return execFileSync(`${root}target/debug/wirebend-brute`, [design, file], { encoding: "utf8" });
  } catch (error) {
    // It ends with 1 where anything is wrong, and says what.
    if (typeof error === "object" && error && "stdout" in error && error.stdout) return String(error.stdout);
    throw error;
  }
}

/** The window is given a sequence; brute force agrees that it can be built, or that it cannot. */
export async function confirmed(editor: Editor, buildable: boolean, act: () => Promise<void>): Promise<void> {
  const given = editor.page.waitForResponse((response) => {
    const asked = response.request().postData();
    return asked !== null && (JSON.parse(asked) as { ask?: string }).ask === "sequence";
  });
  await act();
  const { sequence } = (await (await given).json()) as { sequence: { feasible: boolean } };
  expect(sequence.feasible).toBe(buildable);
  const faults = await faultsOf(editor, sequence);
  if (buildable) expect(faults).toMatch(/^[1-9]\d* steps, 0 faults\n$/);
  else expect(faults).toMatch(/ [1-9]\d* faults\n$/);
}
