import type { Page } from "playwright-core";
import type { Editor } from "./editor.ts";

export type Place = readonly [number, number, number];

/** The axes that go to the right and up in the views without perspective. */
const SIDES = { front: ["1", 0, 2], right: ["3", 1, 2], top: ["7", 0, 1] } as const;

/** A view frames what there is with so much room around it, and nothing smaller than 20 mm. */
const ROOM = 1.16;
const MIN = 20;

/** Where places of the design are in the window, looked at from a side. */
export class Sight {
  private constructor(
    private readonly middle: readonly [number, number],
    private readonly seen: readonly [number, number],
    private readonly sides: (typeof SIDES)[keyof typeof SIDES],
    /** mm that a pixel of the window covers. */
    readonly pixel: number,
  ) {}

  /** Turns the view to a side and frames everything: `places` are the outermost of it. */
  static async from(page: Page, side: keyof typeof SIDES, places: readonly Place[]): Promise<Sight> {
    await page.locator(".viewport canvas").focus();
    await page.keyboard.press(SIDES[side][0]);
    await page.keyboard.press("Home");
    return Sight.framed(page, side, places);
  }

  /** The design of an editor from its front. */
  static async front(editor: Editor): Promise<Sight> {
    const { vertices } = await editor.design();
    return Sight.from(
      editor.page,
      "front",
      vertices.map(({ at_mm }) => at_mm),
    );
  }

  /** The same where the view looks from that side already, with everything framed. */
  static async framed(page: Page, side: keyof typeof SIDES, places: readonly Place[]): Promise<Sight> {
    const sides = SIDES[side];
    const [, right, up] = sides;
    const box = await page.locator(".viewport canvas").boundingBox();
    if (!box) throw new Error("there is no view");
    const extent = (axis: number): [number, number] => {
      const all = places.map((place) => place[axis] ?? 0);
      return [Math.min(...all), Math.max(...all)];
    };
    const [[left, rightmost], [low, high]] = [extent(right), extent(up)];
    const half = Math.max(MIN / 2, (high - low) / 2, ((rightmost - left) / 2) * (box.height / box.width));
    return new Sight(
      [(left + rightmost) / 2, (low + high) / 2],
      [box.x + box.width / 2, box.y + box.height / 2],
      sides,
      (2 * half * ROOM) / box.height,
    );
  }

  /** Pixels of the window. */
  at(place: Place): { x: number; y: number } {
    const [, right, up] = this.sides;
    const [x = 0, y = 0] = [place[right], place[up]];
    return { x: this.seen[0] + (x - this.middle[0]) / this.pixel, y: this.seen[1] - (y - this.middle[1]) / this.pixel };
  }
}
