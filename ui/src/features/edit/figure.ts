import { useCallback, useRef, useState } from "react";

/** A figure of a form: what its field is given, and what stands in it now, also while it is typed. */
export function useFigure(first: number) {
  const [value, setValue] = useState(first);
  const [typed, setTyped] = useState<number | null>(null);
  const [own, setOwn] = useState(false);
  /** The same at once: a proposal may be on its way while the first key comes. */
  const isOwn = useRef(false);
  const take = () => {
    isOwn.current = true;
    setOwn(true);
  };
  const set = (to: number) => {
    take();
    setValue(to);
  };
  const onType = (to: number | null) => {
    // A field that is left tells that nothing is typed any more.
    if (to !== null) take();
    setTyped(to);
  };
  return {
    value,
    now: typed ?? value,
    /** Whether a person has set it: what a form proposes may be replaced by something better. */
    own,
    set,
    propose: useCallback((to: number) => {
      if (!isOwn.current) setValue(to);
    }, []),
    field: { value, onCommit: set, onType },
  };
}
