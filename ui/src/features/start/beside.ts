/** Where a hint stands: beside what it is about, in the view, and clear of what is around. */

export interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** From an edge of the view. */
const EDGE = 8;
/** The help at the pointer and the size of the grid are written there. */
const FOOT = 52;
const APART = 12;

/** `around`: what it stands beside; `corner`: the cube and the buttons below it, at the top right of the view. */
export function beside(
  side: "left" | "below",
  around: Box,
  view: Box,
  corner: Box | null,
  size: { readonly width: number; readonly height: number },
): { readonly left: number; readonly top: number } {
  const lowest = view.bottom - FOOT - size.height;
  let left = side === "left" ? around.left - APART - size.width : around.left;
  let top = side === "left" ? around.top : around.bottom + APART;
  // Below there is no room for it.
  if (side === "below" && top > lowest && around.left < view.left + EDGE * 4) left = around.right + APART;
  top = Math.max(view.top + EDGE, Math.min(top, lowest));
  left = Math.max(view.left + EDGE, Math.min(left, view.right - EDGE - size.width));
  const meets = corner !== null && left + size.width > corner.left - EDGE && top < corner.bottom + EDGE;
  if (!corner || !meets) return { left, top };
  if (corner.bottom + EDGE <= lowest && side === "left") return { left, top: corner.bottom + EDGE };
  return { left: Math.max(view.left + EDGE, corner.left - EDGE - size.width), top };
}
