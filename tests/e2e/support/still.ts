import type { Page } from "playwright-core";
import { expect } from "vitest";

/** What a person may be about to click on, and the view. */
const THINGS = "button, input, select, textarea, a, summary, canvas, h1, h2, h3, [role=separator], [role=option]";

/** What was there before an action, kept in the page. */
interface Kept {
  readonly boxes: Map<Element, DOMRect>;
}

type Marked = typeof globalThis & { wirebendStill?: Kept };

/** px that a box may differ by: what is between two pixels. */
const SAME = 0.75;

async function measure(page: Page, acted: string): Promise<void> {
  await page.evaluate(
    ({ things, acted }) => {
      const boxes = new Map<Element, DOMRect>();
      for (const element of document.querySelectorAll(things)) {
        if (acted && element.closest(acted)) continue;
        const box = element.getBoundingClientRect();
        if (box.width > 0 && box.height > 0) boxes.set(element, box);
      }
      (globalThis as Marked).wirebendStill = { boxes };
    },
    { things: THINGS, acted },
  );
}

/** What is elsewhere or has another size now, by its name. What is gone has not moved. */
function moved(page: Page): Promise<string[]> {
  return page.evaluate((same) => {
    const found: string[] = [];
    for (const [element, before] of (globalThis as Marked).wirebendStill?.boxes ?? []) {
      const box = element.getBoundingClientRect();
      if (!element.isConnected || box.width === 0) continue;
      const by = [box.left - before.left, box.top - before.top, box.right - before.right, box.bottom - before.bottom];
      if (by.every((px) => Math.abs(px) <= same)) continue;
      const name = element.getAttribute("aria-label") ?? element.textContent ?? "";
      const what = `${element.tagName.toLowerCase()} “${name.trim().slice(0, 40)}”`;
      found.push(`${what} by ${by.map((px) => Math.round(px)).join(", ")}`);
    }
    return found;
  }, SAME);
}

/** What was opened comes into sight half a second later: the layout is at rest once it has been the same for longer, frame by frame. */
const REST_MS = 700;

/** Waits until nothing moves any more of what came before: until each frame has found the same layout for so long. */
function atRest(page: Page): Promise<void> {
  return page.evaluate(
    ({ things, same, rest }) =>
      new Promise<void>((done) => {
        let before = new Map<Element, DOMRect>();
        let since = 0;
        const look = (now: number) => {
          const boxes = new Map(
            [...document.querySelectorAll(things)].map((one) => [one, one.getBoundingClientRect()]),
          );
          const still = [...boxes].every(([one, { left, top, right, bottom }]) => {
            const was = before.get(one);
            const by = was ? [left - was.left, top - was.top, right - was.right, bottom - was.bottom] : [Infinity];
            return by.every((px) => Math.abs(px) <= same);
          });
          if (!still || boxes.size !== before.size) [before, since] = [boxes, now];
          if (now - since >= rest) done();
          else requestAnimationFrame(look);
        };
        requestAnimationFrame(look);
      }),
    { things: THINGS, same: SAME, rest: REST_MS },
  );
}

/**
 * Does something, and shows that nothing has moved but what it is done to: `acted` names that, and what belongs below it, as a selector. `settled`
 * waits for what the action brings.
 */
export async function holdsStill(
  page: Page,
  name: string,
  action: () => Promise<unknown>,
  settled: () => Promise<unknown>,
  acted = "",
): Promise<void> {
  await atRest(page);
  await measure(page, acted);
  await action();
  await settled();
  // What is measured is laid out, and what it leads to as well.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  expect(await moved(page), `moved by: ${name}`).toEqual([]);
}
