/**
 * What changes the open design is carried out and shown one after the other, in the order of asking. Otherwise an older answer
 * could come over a newer one.
 */

let last: Promise<unknown> = Promise.resolve();
let waiting = 0;
let replacing = 0;

/** Does it when everything asked for before is done. */
export function inTurn<T>(does: () => Promise<T>): Promise<T> {
  waiting += 1;
  const turn = last.then(does).finally(() => {
    waiting -= 1;
  });
  last = turn.catch(() => {});
  return turn;
}

/** Whether something that may change the design is on its way: what can be undone is not known yet. */
export const isChanging = (): boolean => waiting > 0;

/** The same for what puts another design in the place of the open one: until it is there nothing is changed. */
export async function replacingDesign<T>(does: () => Promise<T>): Promise<T> {
  replacing += 1;
  try {
    return await inTurn(does);
  } finally {
    replacing -= 1;
  }
}

/** Whether another design is on its way. */
export const isBeingReplaced = (): boolean => replacing > 0;

/** Waits until nothing is on its way. */
export async function settled(): Promise<void> {
  for (let seen: unknown = null; seen !== last; ) {
    seen = last;
    await seen;
  }
}
