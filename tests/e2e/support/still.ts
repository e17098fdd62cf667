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

/** What the page does later, it does within this time, such as bringing into sight what was opened. */
const LATER_MS = 700;
/** The layout is at rest once it has been the same for so long, frame by frame, with nothing to come. */
const REST_MS = 250;

type Waiting = typeof globalThis & { wirebendWaits?: () => boolean };

/** Runs in the page, before anything of it: keeps whether it waits for an answer, or for a time to pass that is no longer than `later`. */
export function watchWaits(later: number): void {
  const timers = new Set<number>();
  let asked = 0;
  const { setTimeout: begin, clearTimeout: clear, fetch: ask } = window;
  const timeout = (handler: TimerHandler, ms = 0, ...words: unknown[]): number => {
    const id = begin(
      (...given: unknown[]) => {
        timers.delete(id);
        if (typeof handler === "function") handler(...given);
      },
      ms,
      ...words,
    );
    if (ms <= later) timers.add(id);
    return id;
  };
  window.setTimeout = timeout as typeof window.setTimeout;
  window.clearTimeout = (id) => {
    timers.delete(Number(id));
    clear(id);
  };
  window.fetch = async (...what) => {
    asked += 1;
    try {
      return await ask(...what);
    } finally {
      asked -= 1;
    }
  };
  (globalThis as Waiting).wirebendWaits = () => asked > 0 || timers.size > 0;
}

/** For a page that is not loaded yet. */
export const watchesWaits = (page: Page): Promise<unknown> => page.addInitScript(watchWaits, LATER_MS);

/** Waits until nothing moves any more of what came before: until the page waits for nothing, and each frame has found the same layout for a while. */
export function atRest(page: Page): Promise<void> {
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
          const waits = (globalThis as Waiting).wirebendWaits?.() ?? true;
          if (!still || waits || boxes.size !== before.size) [before, since] = [boxes, now];
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
