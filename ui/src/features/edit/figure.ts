import { useState } from "react";

/** A figure of a form: what its field is given, and what stands in it now, also while it is typed. */
export function useFigure(first: number) {
  const [value, onCommit] = useState(first);
  const [typed, onType] = useState<number | null>(null);
  return { value, now: typed ?? value, set: onCommit, field: { value, onCommit, onType } };
}
