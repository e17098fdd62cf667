import { type RefObject, useEffect } from "react";

/** What is held, of what the pointer is on: the first that is still there. A row stays where one of its buttons becomes another. */
const HELD = ["button, input, select, textarea, label, summary", ".row", ".part", ".section"];

interface Held {
  readonly element: Element;
  readonly top: number;
}

/**
 * Keeps what is under the pointer where it is when something above it grows or shrinks: a click that is on its way would land on something
 * else, and some of it moves machines. `parts` names what the box scrolls, one below the other. WebKit does not do it by itself.
 */
export function useSteady(box: RefObject<HTMLElement | null>, parts: string): void {
  useEffect(() => {
    const scrolled = box.current;
    if (!scrolled) return;
    let under: readonly Held[] = [];
    let scroll = 0;
    const place = (element: Element) => element.getBoundingClientRect().top - scrolled.getBoundingClientRect().top;
    const look = () => {
      const there = under.filter(({ element }) => element.isConnected);
      under = there.map(({ element }) => ({ element, top: place(element) }));
      scroll = scrolled.scrollTop;
    };
    const hold = (): boolean => {
      const held = under.find(({ element }) => element.isConnected);
      if (!held) return false;
      // A scroll is wanted, but for that of a box whose contents have become too short for it.
      const cut = scrolled.scrollTop + scrolled.clientHeight >= scrolled.scrollHeight - 1;
      const moved = place(held.element) - held.top + (cut ? 0 : scrolled.scrollTop - scroll);
      if (moved !== 0) scrolled.scrollTop += moved;
      look();
      return moved !== 0;
    };
    const observer = new ResizeObserver(() => void hold());
    for (const part of scrolled.querySelectorAll(parts)) observer.observe(part);
    const stop = new AbortController();
    const { signal } = stop;
    const point = ({ target }: Event) => {
      // What has grown may come under a pointer that rests, before its growth is reported: that is taken back, since the user has not
      // pointed at it.
      if (scrolled.scrollTop === scroll && hold()) return;
      const around = target instanceof Element ? HELD.map((kind) => target.closest(kind)) : [];
      under = around.filter((element) => element !== null).map((element) => ({ element, top: 0 }));
      look();
    };
    scrolled.addEventListener("pointerover", point, { signal });
    scrolled.addEventListener("scroll", look, { signal });
    scrolled.addEventListener(
      "pointerleave",
      () => {
        under = [];
      },
      { signal },
    );
    return () => {
      stop.abort();
      observer.disconnect();
    };
  }, [box, parts]);
}
