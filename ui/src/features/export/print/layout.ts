/** Where pages stand under each other. */

import type { PageSize } from "./pdf";

export type Zoom = "page" | "width" | "actual";

/** Around and between pages, px. */
export const GAP = 16;
/** Pixels of a millimetre at 96 dpi, as browsers count. */
const ACTUAL = 96 / 25.4;
/** No page is smaller than can be seen, nor larger than can be drawn. */
const SCALES = { least: 0.3, most: 12 } as const;

/** Pixels for a millimetre, one for all pages: so that they fit into a room, as wide as it or as a whole. */
export function scaleFor(zoom: Zoom, sizes: readonly PageSize[], room: readonly [number, number]): number {
  if (zoom === "actual") return ACTUAL;
  const wide = Math.max(1, ...sizes.map(([width]) => width));
  const high = Math.max(1, ...sizes.map(([, height]) => height));
  const across = (room[0] - 2 * GAP) / wide;
  const scale = zoom === "width" ? across : Math.min(across, (room[1] - 2 * GAP) / high);
  return Math.min(SCALES.most, Math.max(SCALES.least, scale));
}

/** How far down each page begins, and at the end how high all are together, px. */
export function tops(sizes: readonly PageSize[], scale: number): readonly number[] {
  let top = GAP;
  return [
    ...sizes.map(([, height]) => {
      const here = top;
      top += Math.round(height * scale) + GAP;
      return here;
    }),
    top,
  ];
}

/** The pages that are seen, with one more before and after: from the first to before the second. */
export function seen(all: readonly number[], scrolled: number, high: number): readonly [number, number] {
  const count = all.length - 1;
  let first = 0;
  while (first < count - 1 && (all[first + 1] ?? 0) <= scrolled) first += 1;
  let end = first;
  while (end < count && (all[end] ?? 0) < scrolled + high) end += 1;
  return [Math.max(0, first - 1), Math.min(count, end + 1)];
}

/** The page that is most in sight: the one that is in the middle. */
export function current(all: readonly number[], scrolled: number, high: number): number {
  const count = all.length - 1;
  let page = 0;
  while (page < count - 1 && (all[page + 1] ?? 0) - GAP / 2 <= scrolled + high / 2) page += 1;
  return page;
}
