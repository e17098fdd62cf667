import { type RefObject, useEffect } from "react";

/** The second click of a double one comes sooner, ms: it is not to land on something that was brought under the pointer. */
const LATER = 500;

/** Brings something into sight a moment after a person has opened it; not what was open from the beginning. */
export function useInSight(box: RefObject<HTMLElement | null>, opened: boolean): void {
  useEffect(() => {
    if (!opened) return;
    const timer = setTimeout(() => void box.current?.scrollIntoView({ block: "nearest" }), LATER);
    return () => clearTimeout(timer);
  }, [box, opened]);
}
