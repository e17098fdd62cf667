import { type ReactNode, type Ref, useEffect, useImperativeHandle, useRef, useState } from "react";
import { windowOf } from "./windowing";

export interface RowsHandle {
  /** Brings a row into sight. */
  reveal(index: number): void;
}

/** Leaves a field in a row that goes, as a click elsewhere would: what is typed there is taken. */
function leaveUnseen(box: HTMLElement, next: { first: number; last: number }, first: number): void {
  const { activeElement } = document;
  if (!(activeElement instanceof HTMLElement) || activeElement === box || !box.contains(activeElement)) return;
  const rows = [...(box.firstElementChild?.children ?? [])];
  const index = first + rows.findIndex((row) => row.contains(activeElement));
  if (index < next.first || index >= next.last) activeElement.blur();
}

/** Many rows of the same height, of which only those in sight are there. Put it where a `role="table"` or a list says what they are. */
export function Rows({
  count,
  rowHeight,
  height,
  render,
  ref,
  ...rest
}: {
  readonly count: number;
  /** px. */
  readonly rowHeight: number;
  /** The most px that it takes. */
  readonly height: number;
  readonly render: (index: number) => ReactNode;
  readonly ref?: Ref<RowsHandle>;
  readonly role?: string;
  readonly "aria-label"?: string;
  readonly "aria-activedescendant"?: string | undefined;
  readonly className?: string;
}) {
  const box = useRef<HTMLDivElement>(null);
  const [top, setTop] = useState(0);
  const sight = Math.min(height, count * rowHeight);
  const { first, last } = windowOf(top, sight, rowHeight, count);
  useImperativeHandle(ref, () => ({
    reveal(index) {
      const { current } = box;
      if (!current) return;
      const [above, below] = [index * rowHeight, (index + 1) * rowHeight - current.clientHeight];
      if (current.scrollTop > above || current.scrollTop < below)
        current.scrollTop = Math.max(0, above - current.clientHeight / 2);
    },
  }));
  // biome-ignore lint/correctness/useExhaustiveDependencies: with fewer rows it may have been scrolled back
  useEffect(() => {
    if (box.current) setTop(box.current.scrollTop);
  }, [count]);
  const rows: ReactNode[] = [];
  for (let index = first; index < last; index++) rows.push(render(index));
  return (
    <div
      ref={box}
      {...rest}
      className={`rows ${rest.className ?? ""}`}
      style={{ maxHeight: height, overflow: "auto" }}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, also by keys
      tabIndex={0}
      onScroll={(event) => {
        const { scrollTop } = event.currentTarget;
        setTop(scrollTop);
        leaveUnseen(event.currentTarget, windowOf(scrollTop, sight, rowHeight, count), first);
      }}
    >
      <div
        role="presentation"
        style={{ height: count * rowHeight, paddingTop: first * rowHeight, boxSizing: "border-box" }}
      >
        {rows}
      </div>
    </div>
  );
}
