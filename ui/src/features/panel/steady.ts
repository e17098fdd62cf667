import { type RefObject, useEffect } from "react";

/** What is held, the innermost of them that the pointer is on. */
const HELD = ".part, .section";

/**
 * Keeps what is under the pointer where it is when something above it grows or shrinks: a click that is on its way would land on something
 * else, and some of it moves machines. `parts` names what the box scrolls, one below the other. WebKit does not do it by itself.
 */
export function useSteady(box: RefObject<HTMLElement | null>, parts: string): void {
  useEffect(() => {
    const scrolled = box.current;
    if (!scrolled) return;
    let under: Element | null = null;
    let [top, scroll] = [0, 0];
    const place = () => (under ? under.getBoundingClientRect().top - scrolled.getBoundingClientRect().top : 0);
    const look = () => {
      [top, scroll] = [place(), scrolled.scrollTop];
    };
    const hold = (): boolean => {
      if (!under?.isConnected) return false;
      // A scroll is wanted, but for that of a box whose contents have become too short for it.
      const cut = scrolled.scrollTop + scrolled.clientHeight >= scrolled.scrollHeight - 1;
      const moved = place() - top + (cut ? 0 : scrolled.scrollTop - scroll);
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
      under = target instanceof Element ? target.closest(HELD) : null;
      look();
    };
    scrolled.addEventListener("pointerover", point, { signal });
    scrolled.addEventListener("scroll", look, { signal });
    scrolled.addEventListener(
      "pointerleave",
      () => {
        under = null;
      },
      { signal },
    );
    return () => {
      stop.abort();
      observer.disconnect();
    };
  }, [box, parts]);
}
