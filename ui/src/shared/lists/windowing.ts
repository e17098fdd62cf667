/** Rows beyond those in sight, so that scrolling shows no gaps. */
const SPARE = 6;

/** The rows from `first` to before `last` that a box shows, scrolled down by `top`. All in px but the rows. */
export function windowOf(
  top: number,
  height: number,
  rowHeight: number,
  count: number,
): { first: number; last: number } {
  const first = Math.max(0, Math.min(count, Math.floor(top / rowHeight) - SPARE));
  const last = Math.min(count, Math.ceil((top + height) / rowHeight) + SPARE);
  return { first, last: Math.max(first, last) };
}
