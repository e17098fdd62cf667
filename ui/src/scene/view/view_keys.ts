/** Turning, shifting and zooming the view by keys, as far as dragging with the pointer would. Pure. */

import { type Orbit, shifted, turned, zoomed } from "./orbit";

/** CSS pixels that a press stands for: about 10° of a turn. */
const PIXELS = 24;
const NEARER = 1 / 1.2;

const WAYS: Readonly<Partial<Record<string, readonly [number, number]>>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** The view after a key, and whether it was turned; null where the key means nothing to it. `height` of the viewport in CSS pixels. */
export function afterKey(
  orbit: Orbit,
  { key, shiftKey }: Pick<KeyboardEvent, "key" | "shiftKey">,
  height: number,
): { readonly orbit: Orbit; readonly turned: boolean } | null {
  const way = WAYS[key];
  if (way) {
    const [dx, dy] = [way[0] * PIXELS, way[1] * PIXELS];
    return shiftKey
      ? { orbit: shifted(orbit, dx, dy, height), turned: false }
      : { orbit: turned(orbit, dx, dy), turned: true };
  }
  // The plus is the equals sign with Shift on many keyboards: both are taken.
  const factor = key === "+" || key === "=" ? NEARER : key === "-" || key === "_" ? 1 / NEARER : null;
  return factor === null ? null : { orbit: zoomed(orbit, factor, 0, 0, height), turned: false };
}
