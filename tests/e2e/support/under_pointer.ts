/** What moves under the pointer, measured at each action of each test in a browser: see `watchPointer`. */

/** The name under which the page tells what has moved. */
export const TELL = "wirebendMoved";

export interface PointerWatch {
  /** Whether the page has come to rest, and what had moved is told: to be awaited at the end of a test. */
  rest(): Promise<void>;
  /** Scrolls something into sight as a test does, which is no movement. */
  bring(element: Element): void;
}

export type Watched = typeof globalThis & { wirebendPointer?: PointerWatch };

/**
 * Runs in the page, before a person does anything. An action is a move of the pointer onto something else, a press of its button, a key, or a new value
 * of a field. At each the boxes are kept, before the page hears of it, of
 *
 * - the control that the pointer is on, or, where it is on none, of what else it is on, and between two things of the lower one;
 * - the controls that come within `NEAR` of the pointer and can be clicked on there.
 *
 * From then on, and until the next action, each of them that is still shown has to be where it was, on each side to 1 px; of what is no control
 * the left and the upper side. Also what comes later counts, such as an answer of the Rust side while the pointer rests. Something has moved once
 * it has been elsewhere at the same place for two looks, `LOOK_MS` apart, or when the next action comes, for `FRAMES` frames without a scroll:
 * what passes while the page is laid out does not count.
 *
 * No movement is what the person asked for:
 *
 * - a scroll by wheel, key, or by the test that brings something into sight. A scroll by the page, and one that the browser does since the
 *   contents have become too short, is none of these;
 * - what a dialog or a menu covers that has opened where the pointer is;
 * - another size of the window, a drag, and a double-click on a divider, which puts it back, until the next action;
 * - all of the panel, after a click on a control that leads to another section of it (`aria-controls`);
 * - below a control that opens and closes (`aria-expanded`, `summary`): what comes after it in the document. It stays itself, until the page
 *   brings what was opened into sight.
 */
export function watchPointer(tell: string): void {
  const CONTROLS =
    "button, input, select, textarea, a, summary, label, [role=option], [role=separator], [role=slider], canvas";
  const LAYERS = "[role=dialog], [role=alertdialog], [role=menu], dialog, [data-radix-popper-content-wrapper]";
  /** px from the pointer: half the height of a button. */
  const NEAR = 14;
  const LOOK_MS = 100;
  const SAME = 1;
  /** What is elsewhere for so many frames was seen there. */
  const FRAMES = 2;
  /** What was opened is brought into sight within this time. */
  const SIGHT_MS = 1000;
  /** Frames are counted for so long after an action or a change: what is drawn later is a change itself, or is seen at the looks. */
  const SETTLE_MS = 500;
  /** px that a pressed pointer moves before it drags. */
  const DRAG = 4;

  interface Kept {
    readonly element: Element;
    readonly box: DOMRect;
    readonly control: boolean;
  }
  let kept: readonly Kept[] = [];
  let action = "";
  let at: { readonly x: number; readonly y: number } | null = null;
  let pressed: { readonly x: number; readonly y: number } | null = null;
  let heights = new Map<Element, number>();
  /** How far the boxes around what is kept were scrolled. */
  let scrolled = new Map<Element, number>();
  let own: Element | null = null;
  let opening: Element | null = null;
  let openedAt = -Infinity;
  let sighted = false;
  let elsewhere = "";
  let since = 0;
  let drawn = { elsewhere: "", frames: 0 };
  let counting = false;
  let countUntil = 0;
  let telling: Promise<void> | undefined;

  const name = (element: Element) => {
    const said = element.getAttribute("aria-label") ?? element.textContent ?? "";
    return `${element.tagName.toLowerCase()} “${said.trim().replaceAll(/\s+/g, " ").slice(0, 40)}”`;
  };
  const by = ({ element, box, control }: Kept): readonly number[] => {
    const now = element.getBoundingClientRect();
    if (!element.isConnected || now.width === 0 || now.height === 0) return [];
    const sides = [now.left - box.left, now.top - box.top, now.right - box.right, now.bottom - box.bottom];
    const seen = control ? sides : sides.slice(0, 2);
    return seen.some((px) => Math.abs(px) > SAME) ? seen.map((px) => Math.round(px)) : [];
  };
  const scrollers = (element: Element): Element[] => {
    const found: Element[] = [];
    for (let one: Element | null = element; one; one = one.parentElement)
      if (one.scrollHeight > one.clientHeight + 1) found.push(one);
    return found;
  };

  /** Keeps what is there now; `opened`: what comes after it may move. */
  const keep = (what: string, opened: Element | null = null) => {
    action = what;
    opening = opened;
    changed();
    if (opened) openedAt = performance.now();
    forget();
    if (!at) return;
    const { x, y } = at;
    const hit = document.elementFromPoint(x, y);
    // A picture is one thing: what it shows may turn. Between two things it is the lower one that the pointer is at.
    const beside = hit && [...hit.children].find((child) => child.getBoundingClientRect().bottom > y);
    const under = hit?.closest("svg") ?? (hit?.closest(CONTROLS) ? hit : (beside ?? hit));
    if (!hit || !under || hit === document.documentElement || hit === document.body) return;
    const control = under.closest(CONTROLS);
    const near = [...document.querySelectorAll(CONTROLS)].filter((element) => {
      if (element.contains(under)) return false;
      const { left, top, right, bottom, width, height } = element.getBoundingClientRect();
      if (width === 0 || height === 0) return false;
      if (x <= left - NEAR || x >= right + NEAR || y <= top - NEAR || y >= bottom + NEAR) return false;
      // What lies below a dialog cannot be clicked on.
      const [px, py] = [Math.min(Math.max(x, left + 1), right - 1), Math.min(Math.max(y, top + 1), bottom - 1)];
      const seen = document.elementFromPoint(px, py);
      return seen !== null && element.contains(seen);
    });
    const after = (element: Element) =>
      opened !== null &&
      element !== opened &&
      (opened.compareDocumentPosition(element) & Node.DOCUMENT_POSITION_FOLLOWING) !== 0;
    kept = [control ?? under, ...near]
      .filter((element) => !after(element))
      .map((element) => ({
        element,
        box: element.getBoundingClientRect(),
        control: element !== under || control !== null,
      }));
    heights = new Map(scrollers(under).map((one) => [one, one.scrollHeight]));
    scrolled = new Map(scrollers(under).map((one) => [one, one.scrollTop]));
  };
  const forget = () => {
    kept = [];
    elsewhere = "";
    drawn = { elsewhere: "", frames: 0 };
  };

  /** Whether a dialog or a menu has come between the pointer and what it was on. */
  const isCovered = (): boolean => {
    const now = at && document.elementFromPoint(at.x, at.y)?.closest(LAYERS);
    return now !== null && now !== undefined && kept.every(({ element }) => element.closest(LAYERS) !== now);
  };

  /** What is elsewhere now, and by how much. */
  const found = (): string => {
    if (kept.length > 0 && isCovered()) forget();
    const all = kept.flatMap((one) => {
      const sides = by(one);
      return sides.length > 0 ? [`${name(one.element)} by ${sides.join(", ")}`] : [];
    });
    return all.join("; ");
  };
  /** Counts for how many frames in a row what is elsewhere is at the same place. */
  const count = () => {
    const now = found();
    drawn = { elsewhere: now, frames: now !== "" && now === drawn.elsewhere ? drawn.frames + 1 : 1 };
    counting = now !== "" || performance.now() < countUntil;
    if (counting) requestAnimationFrame(count);
  };
  /** What moves does so in consequence of an action, also by a style for hover or focus alone, a change or a scroll. */
  const changed = () => {
    countUntil = performance.now() + SETTLE_MS;
    if (counting) return;
    counting = true;
    requestAnimationFrame(count);
  };
  new MutationObserver(changed).observe(document, {
    subtree: true,
    childList: true,
    characterData: true,
    attributes: true,
  });
  for (const moves of ["scroll", "resize", "transitionrun", "animationstart"]) addEventListener(moves, changed, true);

  /** `acted`: a person does the next thing, to what they have seen. */
  const look = (acted = false) => {
    const now = found();
    if (now !== elsewhere) [elsewhere, since] = [now, performance.now()];
    // Whether a scroll is wanted is known once it is reported, which the next action may come before.
    const still = [...scrolled].every(([box, top]) => Math.abs(box.scrollTop - top) < SAME);
    const seen = acted && still && now === drawn.elsewhere && drawn.frames >= FRAMES;
    if (now === "" || (!seen && performance.now() - since < LOOK_MS * 0.9)) return;
    const { [tell]: told } = globalThis as unknown as Record<string, (what: string) => Promise<void>>;
    telling = told?.(`${now}; after ${action}`);
    forget();
  };
  setInterval(() => look(), LOOK_MS);
  const bring = Element.prototype.scrollIntoView;
  (globalThis as Watched).wirebendPointer = {
    rest: () =>
      new Promise<void>((done) => {
        const frames = (left: number) =>
          requestAnimationFrame(() => {
            look();
            if (left > 0 || elsewhere !== "") frames(left - 1);
            else done(telling);
          });
        frames(2);
      }),
    bring: (element) => {
      bring.call(element, { block: "center" });
      keep(action, opening);
    },
  };

  const opens = (target: EventTarget | null) =>
    target instanceof Element ? target.closest("[aria-expanded], summary") : null;
  const capture = { capture: true, passive: true };
  addEventListener(
    "pointermove",
    (event) => {
      const dragged = pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > DRAG;
      const target = event.target instanceof Element ? event.target : null;
      if (at && at.x === event.clientX && at.y === event.clientY) return;
      look(true);
      at = { x: event.clientX, y: event.clientY };
      if (dragged) forget();
      else if (!pressed && target) keep(`the pointer came on ${name(target.closest(CONTROLS) ?? target)}`);
    },
    capture,
  );
  addEventListener(
    "pointerdown",
    (event) => {
      look(true);
      pressed = at = { x: event.clientX, y: event.clientY };
      if (!(event.target instanceof Element)) return;
      if (event.target.closest("[aria-controls^='section-']")) forget();
      else keep(`a click on ${name(event.target.closest(CONTROLS) ?? event.target)}`, opens(event.target));
    },
    capture,
  );
  const release = () => {
    pressed = null;
  };
  for (const up of ["pointerup", "pointercancel"] as const) addEventListener(up, release, capture);
  addEventListener(
    "dblclick",
    ({ target }) => {
      if (target instanceof Element && target.closest("[role=separator]")) forget();
    },
    capture,
  );
  addEventListener(
    "keydown",
    ({ key, target }) => {
      look(true);
      keep(`the key ${key}`, opens(target));
    },
    capture,
  );
  addEventListener(
    "input",
    ({ target }) => {
      // It follows a click, which the page has heard of by now.
      if (target instanceof HTMLInputElement && ["checkbox", "radio"].includes(target.type)) return;
      look(true);
      keep(`a value of ${target instanceof Element ? name(target) : "?"}`);
    },
    capture,
  );
  addEventListener("resize", forget);

  // What the page scrolls itself is told apart from what a person scrolls.
  const scrolls = (element: Element) => {
    own = element;
    // One that was there already scrolls nothing.
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        if (own === element) own = null;
      }),
    );
  };
  const top = Object.getOwnPropertyDescriptor(Element.prototype, "scrollTop");
  if (top?.set && top.get) {
    const { get, set } = top;
    Object.defineProperty(Element.prototype, "scrollTop", {
      ...top,
      get,
      set(this: Element, value: number) {
        scrolls(this);
        set.call(this, value);
      },
    });
  }
  for (const way of ["scrollTo", "scrollBy", "scrollIntoView"] as const) {
    const original = Element.prototype[way] as (this: Element, ...how: unknown[]) => void;
    Object.assign(Element.prototype, {
      [way](this: Element, ...how: unknown[]) {
        const sights = way === "scrollIntoView" && performance.now() - openedAt < SIGHT_MS;
        sighted ||= sights;
        scrolls(this);
        original.apply(this, how);
        // WebKit may report the scroll much later than it is drawn.
        if (sights) keep(action, opening);
      },
    });
  }
  addEventListener(
    "scroll",
    ({ target }) => {
      const box = target instanceof Element ? target : document.documentElement;
      const byPage = own !== null && !sighted && (own === box || box.contains(own));
      own = null;
      sighted = false;
      // That brings the beginning nearer, never the end.
      const back = box.scrollTop < (scrolled.get(box) ?? 0);
      const shorter = back && box.scrollHeight < (heights.get(box) ?? 0);
      if (!byPage && !shorter && kept.some(({ element }) => box.contains(element))) keep(action, opening);
    },
    capture,
  );
}
