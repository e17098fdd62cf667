/** Construction lines of the open design, which are named by their places in a list. */

import type { EditRequest } from "../../generated/requests";
import type { ViewChange } from "../../generated/responses";
import type { Vec3 } from "../../scene/interface";
import { type DesignState, editAsItIs, useDesign } from "../design/design";
import { distance } from "../design/geometry";

/** A line by its two ends, mm. */
export type Line = readonly [Vec3, Vec3];

const NONE: readonly Line[] = [];
const NO_LINE: readonly [] = [];

export const linesOf = (state: Pick<DesignState, "construction_mm"> | null): readonly Line[] =>
  state?.construction_mm ?? NONE;

/** Those of the open design. */
export const lines = (): readonly Line[] => linesOf(useDesign.getState().state);

/** The length of lines of a list, mm. */
export function lengthOfLines(places: Iterable<number>, all: readonly Line[]): number {
  let sum = 0;
  for (const place of places) {
    const line = all[place];
    if (line) sum += distance(line[0], line[1]);
  }
  return sum;
}

const nameOf = (line: readonly Vec3[]): string => line.flat().join();

/** Where each line of a list is, those with the same ends in their order. */
function placesIn(list: readonly Line[]): Map<string, number[]> {
  const places = new Map<string, number[]>();
  list.forEach((line, place) => {
    const name = nameOf(line);
    places.set(name, [...(places.get(name) ?? []), place]);
  });
  return places;
}

/**
 * Where lines of a list are after a change. In a list of the same length all are at their places, whatever their ends, as after a move; in
 * another they are where their ends are, and those that are gone in no place.
 */
export function placesAfter(named: Iterable<number>, before: readonly Line[], after: readonly Line[]): number[] {
  if (before.length === after.length) return [...named];
  const [were, are] = [placesIn(before), placesIn(after)];
  return [...named].flatMap((place) => {
    const name = nameOf(before[place] ?? NO_LINE);
    const same = were.get(name)?.indexOf(place) ?? 0;
    return are.get(name)?.[same] ?? [];
  });
}

/** Lines that a change names which waits for its turn. */
interface Named {
  places: readonly number[];
}

const waiting = new Set<Named>();

/** Construction lines have changed: what waits names those that it has named. */
export function renumberWaiting(before: readonly Line[], after: readonly Line[]): void {
  for (const named of waiting) named.places = placesAfter(named.places, before, after);
}

/** Makes a change of lines, which are named as the list has them when its turn comes; none where that is null. */
export async function editLines(
  places: Iterable<number>,
  request: (places: number[]) => EditRequest | null,
): Promise<ViewChange | null> {
  const named: Named = { places: [...places] };
  waiting.add(named);
  try {
    return await editAsItIs(() => request([...named.places]));
  } finally {
    waiting.delete(named);
  }
}
