import { platform } from "../../platform";
import { tell, told } from "../asking/problems";
import { checked } from "../design/design";
import { openPath, start } from "./files";

/** How long the view waits for what it shows first, ms: a large model comes into a view that is there. */
const PATIENCE = 500;

let beginning: Promise<unknown> = Promise.resolve();

/** Shows what is open, and what the window was started with. */
export function begin(): void {
  const all = async () => {
    const [files] = await Promise.all([told(platform.filesToOpen()), start()]);
    await openFirst(files ?? []);
  };
  beginning = told(all());
}

/** Opens a file that was asked for from outside; what the window was started with was asked for before. */
export async function openNext(path: string): Promise<void> {
  await beginning;
  await openPath(path);
}

/** One design is open at a time: of several files the first. */
export async function openFirst(paths: readonly string[]): Promise<void> {
  const [first, ...others] = paths;
  if (!first) return;
  if (others.length > 0)
    tell("info", `Only the first of ${paths.length} files is opened: one design is open at a time.`, "one-file");
  await openPath(first);
}

/** When what the window begins with is there and checked, or was waited for long enough: a picture of nothing before it would only cost time. */
export function begun(): Promise<unknown> {
  return Promise.race([beginning.then(checked), new Promise((resolve) => setTimeout(resolve, PATIENCE))]);
}
