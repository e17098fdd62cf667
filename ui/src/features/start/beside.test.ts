import { expect, it } from "vitest";
import { type Box, beside } from "./beside";

const box = (left: number, top: number, width: number, height: number): Box => ({
  left,
  top,
  right: left + width,
  bottom: top + height,
});
const meet = (one: Box, other: Box) =>
  one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom;

it.each([
  [960, 600],
  [1280, 800],
  [2560, 1440],
])("stands in the view and clear of its corner in a window of %i × %i", (width, height) => {
  const view = box(0, 44, width - 344, height - 74);
  const corner = box(view.right - 120, 56, 112, 160);
  const size = { width: 288, height: 130 };
  for (const [side, around] of [
    ["below", box(12, 56, 46, 450)],
    ["below", box(414, 8, 395, 30)],
    ["left", box(view.right, 300, 344, 40)],
    ["left", box(view.right, height - 60, 344, 40)],
    ["left", box(view.right, 48, 344, 40)],
  ] as const) {
    const at = beside(side, around, view, corner, size);
    const own = box(at.left, at.top, size.width, size.height);
    expect(own.left >= view.left && own.right <= view.right && own.top >= view.top).toBe(true);
    expect(own.bottom, "what is written at the foot").toBeLessThanOrEqual(view.bottom - 52);
    expect([meet(own, corner), meet(own, around)], `${side} ${JSON.stringify(around)}`).toEqual([false, false]);
  }
});
