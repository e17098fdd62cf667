/** What moves under the pointer of the windows that tests have open: in a browser, and of the installed package. */

/** Has the page of a window come to rest, and says what has moved in it since it was asked last. */
export type Rest = () => Promise<readonly string[]>;

const windows = new Set<Rest>();
/** In windows that were closed. */
const before: string[] = [];

/** From now on that window is asked; gives what ends that, with a last question where the page can still answer. */
export function watch(rest: Rest): () => Promise<void> {
  windows.add(rest);
  return async () => {
    if (windows.delete(rest)) before.push(...(await rest()));
  };
}

/** Waits for each window to come to rest, and takes what has moved under its pointer. */
export async function moved(): Promise<string[]> {
  const found = before.splice(0);
  for (const rest of windows) found.push(...(await rest()));
  return found;
}
