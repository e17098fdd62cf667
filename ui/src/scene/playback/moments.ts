/** Which moment of a step is shown. */

import type { Moment } from "../interface";

/** Step and fraction within it; the last step at its end where the time is past it. Null without steps. */
export function stepAt(steps: number, time: number): { step: number; fraction: number } | null {
  if (steps === 0) return null;
  if (!(time > 0)) return { step: 0, fraction: 0 };
  if (time >= steps) return { step: steps - 1, fraction: 1 };
  return { step: Math.floor(time), fraction: time - Math.floor(time) };
}

/** What is there at a fraction of the step's time, evenly between the moments around it; null without moments. */
export function momentAt(moments: readonly Moment[], fraction: number): Moment | null {
  const last = moments.at(-1);
  if (fraction >= 1) return last ?? null;
  const next = moments.findIndex(({ at }) => at >= fraction);
  const [from, to] = [moments[next - 1], moments[next]];
  if (!from || !to || !(to.at > from.at)) return to ?? last ?? null;
  const part = (fraction - from.at) / (to.at - from.at);
  const between = (a: number, b: number): number => a + (b - a) * part;
  return {
    at: fraction,
    fed: between(from.fed, to.fed),
    bent: between(from.bent, to.bent),
    head: between(from.head, to.head),
    bendAxis: between(from.bendAxis, to.bendAxis),
    pegOut: between(from.pegOut, to.pegOut),
  };
}
