import { angle } from "./format";
import type { Lengths } from "./unit";

/** How far two things are apart, in all and along each axis, and how they are turned: "Distance 50.0 mm · x 0.0  y 30.0  z 40.0 mm". */
export function apartPhrase(
  {
    from,
    to,
    mm,
    deg,
  }: {
    readonly from: readonly [number, number, number];
    readonly to: readonly [number, number, number];
    readonly mm: number;
    readonly deg: number | null;
  },
  { length, bare, name }: Pick<Lengths, "length" | "bare" | "name">,
): string {
  const along = (axis: 0 | 1 | 2) => bare(to[axis] - from[axis]);
  const apart = `Distance ${length(mm)} · x ${along(0)}  y ${along(1)}  z ${along(2)} ${name}`;
  return deg === null ? apart : `${apart} · ${angle(deg)}`;
}
