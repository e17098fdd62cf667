/** Ends what was begun. */
export type End = () => void;

interface Store<S> {
  subscribe(hear: (now: S, before: S) => void): End;
}

/** Calls `act` whenever something of what `pick` gives is another. */
export function whenChanged<S>(
  store: Store<S>,
  pick: (state: S) => readonly unknown[],
  act: (now: S, before: S) => void,
): End {
  return store.subscribe((now, before) => {
    const was = pick(before);
    if (pick(now).some((value, index) => !Object.is(value, was[index]))) act(now, before);
  });
}

/** One end for all of these. */
export function together(ends: readonly End[]): End {
  return () => {
    for (const end of ends) end();
  };
}
