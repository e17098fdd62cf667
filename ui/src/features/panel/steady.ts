import { type RefObject, useEffect } from "react";

/** A picture is one thing: what it shows may turn. Between two things the pointer is at the lower one. */
const lower = (on: Element, y: number): Element =>
  on.closest("svg") ?? [...on.children].find((child) => child.getBoundingClientRect().bottom > y) ?? on;

/**
 * What is held, of what the pointer is on: the first that is still there. A row stays where one of its buttons becomes another. What has a scroll of
 * its own stands before what the pointer itself is on, which that scroll moves.
 */
const HELD: readonly ((on: Element, y: number) => Element | null | undefined)[] = [
  (on) => on.closest("button, input, select, textarea, label, summary"),
  (on) => on.closest(".row"),
  (on) => on.closest("[role=listbox], [role=list], [role=table], [role=log], ul, table, fieldset"),
  lower,
  (on) => on.closest(".fold"),
  (on) => on.closest(".part"),
  (on) => on.closest(".section"),
];

interface Held {
  readonly element: Element;
  readonly top: number;
}

/** px of a style; none is 0. */
const px = (length: string): number => Number.parseFloat(length) || 0;

/**
 * Keeps what is under the pointer where it is when something else in the box grows or shrinks: a click that is on its way would land on something
 * else, and some of it moves machines. Where the box cannot scroll so far there is room left above or below, until the pointer leaves. `parts`
 * names what the box scrolls, one below the other. WebKit does not do it by itself.
 */
export function useSteady(box: RefObject<HTMLElement | null>, parts: string): void {
  useEffect(() => {
    const scrolled = box.current;
    if (!scrolled) return;
    let under: readonly Held[] = [];
    let scroll = 0;
    let height = 0;
    const { style } = scrolled;
    const place = (element: Element, side: "top" | "bottom" = "top") =>
      element.getBoundingClientRect()[side] - scrolled.getBoundingClientRect().top;
    const look = () => {
      const there = under.filter(({ element }) => element.isConnected);
      under = there.map(({ element }) => ({ element, top: place(element) }));
      [scroll, height] = [scrolled.scrollTop, scrolled.scrollHeight];
    };
    /** Scrolls by so many px, with room above or below where the contents end before. */
    const shift = (by: number) => {
      const above = px(style.paddingTop);
      // Room that was left is used first.
      const kept = Math.max(above - Math.max(by, 0), 0);
      let rest = by - (above - kept);
      if (rest < -scrolled.scrollTop) {
        style.paddingTop = `${kept - rest - scrolled.scrollTop}px`;
        rest = -scrolled.scrollTop;
      } else if (kept !== above) style.paddingTop = kept > 0 ? `${kept}px` : "";
      const to = scrolled.scrollTop + rest;
      const end = scrolled.lastElementChild ? place(scrolled.lastElementChild, "bottom") + scrolled.scrollTop : 0;
      // Contents that end above the lower edge do not scroll yet: the room reaches from there on.
      const below = to > 0 ? to + scrolled.clientHeight - end : 0;
      if (below > px(style.paddingBottom)) style.paddingBottom = `${below}px`;
      if (scrolled.scrollTop !== to) scrolled.scrollTop = to;
    };
    const hold = (): boolean => {
      const held = under.find(({ element }) => element.isConnected);
      if (!held) return false;
      // A scroll is wanted, but for that of a box whose contents have become too short for it.
      const shorter = scrolled.scrollHeight < height && scrolled.scrollTop < scroll;
      const cut = shorter && scrolled.scrollTop + scrolled.clientHeight >= scrolled.scrollHeight - 1;
      const moved = place(held.element) - held.top + (cut ? 0 : scrolled.scrollTop - scroll);
      if (moved !== 0) shift(moved);
      look();
      return moved !== 0;
    };
    const observer = new ResizeObserver(() => void hold());
    for (const part of scrolled.querySelectorAll(parts)) observer.observe(part);
    // A click may come before what has changed is drawn, which is when sizes are reported.
    const changes = new MutationObserver(() => void hold());
    changes.observe(scrolled, { subtree: true, childList: true, characterData: true, attributes: true });
    const stop = new AbortController();
    const { signal } = stop;
    const point = ({ target, clientY }: PointerEvent) => {
      // What has grown may come under a pointer that rests, before its growth is reported: that is taken back, since the user has not
      // pointed at it.
      const grown = scrolled.scrollTop === scroll || scrolled.scrollHeight !== height;
      if (grown && hold()) return;
      const on = target instanceof Element && target !== scrolled ? target : null;
      const around = on ? HELD.map((kind) => kind(on, clientY)) : [];
      under = around.filter((element) => element instanceof Element).map((element) => ({ element, top: 0 }));
      look();
    };
    scrolled.addEventListener("pointerover", point, { signal });
    // From between two things it may come between two others of the same box at once, which is on nothing else.
    const move = (event: PointerEvent) => {
      const { target, clientY } = event;
      const between = target instanceof Element && target.childElementCount > 0 && target !== scrolled;
      if (between && !under.some(({ element }) => element === lower(target, clientY))) point(event);
    };
    scrolled.addEventListener("pointermove", move, { signal });
    // Contents that have become too short scroll the box too, maybe before their size is reported.
    scrolled.addEventListener("scroll", () => (scrolled.scrollHeight === height ? look() : void hold()), { signal });
    scrolled.addEventListener(
      "pointerleave",
      () => {
        under = [];
        [style.paddingTop, style.paddingBottom] = ["", ""];
      },
      { signal },
    );
    return () => {
      stop.abort();
      observer.disconnect();
      changes.disconnect();
    };
  }, [box, parts]);
}
