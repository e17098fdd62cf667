import { type ReactNode, useEffect, useLayoutEffect, useRef, useState } from "react";
import { current, GAP, scaleFor, seen, tops, type Zoom } from "./layout";
import type { PageSize, PrintedPages } from "./pdf";

const NONE: readonly PageSize[] = [];

/** The pages under each other, or what is to be said instead. It is there from the beginning, and so has the focus of the dialog. Those that are in sight are drawn; the others have their place. */
export function Pages({
  pages,
  zoom,
  onPage,
  onProblem,
  children,
}: {
  readonly pages: PrintedPages | null;
  readonly zoom: Zoom;
  /** Which page is in the middle, from 0. */
  readonly onPage: (page: number) => void;
  readonly onProblem: (error: unknown) => void;
  readonly children?: ReactNode;
}) {
  const sizes = pages?.sizes ?? NONE;
  const box = useRef<HTMLElement>(null);
  const [room, setRoom] = useState<readonly [number, number] | null>(null);
  const [scrolled, setScrolled] = useState(0);
  useLayoutEffect(() => {
    const shown = box.current;
    if (!shown) return;
    const measure = () => setRoom([shown.clientWidth, shown.clientHeight]);
    measure();
    const watch = new ResizeObserver(measure);
    watch.observe(shown);
    return () => watch.disconnect();
  }, []);
  const scale = room ? scaleFor(zoom, sizes, room) : 0;
  const all = tops(sizes, scale);
  const high = room?.[1] ?? 0;
  const page = current(all, scrolled, high);
  useEffect(() => onPage(page), [page, onPage]);
  // The page that was looked at stays in sight when the pages become larger or smaller.
  const before = useRef({ scale, page });
  useLayoutEffect(() => {
    const { scale: last, page: stay } = before.current;
    if (last !== scale && last !== 0 && box.current) {
      box.current.scrollTop = Math.max(0, (all[stay] ?? 0) - GAP);
      setScrolled(box.current.scrollTop);
    }
    before.current = { scale, page: last === scale ? page : stay };
  }, [scale, page, all]);
  const [first, end] = seen(all, scrolled, high);
  const widest = Math.max(0, ...sizes.map(([width]) => Math.round(width * scale)));
  return (
    <section
      ref={box}
      className="print-pages"
      aria-label="Pages"
      // biome-ignore lint/a11y/noNoninteractiveTabindex: who has no pointer scrolls it by keys
      tabIndex={0}
      data-first
      aria-busy={!pages && !children}
      onScroll={(event) => setScrolled(event.currentTarget.scrollTop)}
    >
      {children}
      {!pages && !children && <p className="muted print-wait">Preparing the pages…</p>}
      {pages && room && (
        <div className="print-strip" style={{ height: all.at(-1) ?? 0, minWidth: widest + 2 * GAP }}>
          {sizes.map(([width, height], index) => (
            <div
              // biome-ignore lint/suspicious/noArrayIndexKey: pages have no other name
              key={index}
              className="print-page"
              role="img"
              aria-label={`Page ${index + 1} of ${sizes.length}`}
              style={{ top: all[index], width: Math.round(width * scale), height: Math.round(height * scale) }}
            >
              {index >= first && index < end && (
                <Page pages={pages} index={index} width={Math.round(width * scale)} onProblem={onProblem} />
              )}
            </div>
          ))}
        </div>
      )}
    </section>
  );
}

function Page({
  pages,
  index,
  width,
  onProblem,
}: {
  readonly pages: PrintedPages;
  readonly index: number;
  readonly width: number;
  readonly onProblem: (error: unknown) => void;
}) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    if (!canvas.current) return;
    return pages.draw(index, canvas.current, width * (window.devicePixelRatio || 1), onProblem);
  }, [pages, index, width, onProblem]);
  // A canvas that is being drawn on is given to nobody else.
  return <canvas key={width} ref={canvas} />;
}
