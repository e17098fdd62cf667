import { type KeyboardEvent, type PointerEvent, type ReactNode, useRef, useSyncExternalStore } from "react";
import { PANEL, useUi, usualPanel } from "../../state/window/ui";
import { useSteady } from "./steady";
import "./panel.css";

/** px of an arrow key. */
const STEP = 16;
/** px of the window that are left for the view, however wide the panel was made in a larger one. */
const VIEW = 480;

function onResize(hear: () => void): () => void {
  window.addEventListener("resize", hear);
  return () => window.removeEventListener("resize", hear);
}

/** The panel on the right; its left edge is dragged, or moved with the arrow keys. */
export function Panel({ children }: { readonly children: ReactNode }) {
  const room = useSyncExternalStore(onResize, () => window.innerWidth) - VIEW;
  const most = Math.max(PANEL.least, Math.min(PANEL.most, room));
  // What it was made in a larger window is kept for that one.
  const width = Math.min(
    useUi((ui) => ui.panelWidth),
    most,
  );
  const setWidth = useUi((ui) => ui.setPanelWidth);
  const sections = useRef<HTMLDivElement>(null);
  useSteady(sections, ".section");
  const grip = useRef<{ x: number; width: number } | null>(null);
  const down = (event: PointerEvent<HTMLDivElement>) => {
    event.currentTarget.setPointerCapture(event.pointerId);
    grip.current = { x: event.clientX, width };
  };
  const move = (event: PointerEvent) => {
    const wanted = grip.current ? Math.min(grip.current.width + grip.current.x - event.clientX, most) : width;
    if (wanted !== width) setWidth(wanted);
  };
  const key = (event: KeyboardEvent) => {
    const to: Partial<Record<string, number>> = {
      ArrowLeft: Math.min(width + STEP, most),
      ArrowRight: width - STEP,
      Home: most,
      End: PANEL.least,
    };
    const wanted = to[event.key];
    if (wanted === undefined) return;
    event.preventDefault();
    setWidth(wanted);
  };
  return (
    <aside className="panel" style={{ width }} aria-label="Panel">
      {/* biome-ignore lint/a11y/useSemanticElements: it is dragged, and has a value; a line has none */}
      <div
        className="panel-edge"
        role="separator"
        tabIndex={0}
        aria-orientation="vertical"
        aria-label="Width of the panel"
        aria-valuemin={PANEL.least}
        aria-valuemax={most}
        aria-valuenow={width}
        onPointerDown={down}
        onPointerMove={move}
        onPointerUp={() => (grip.current = null)}
        onPointerCancel={() => (grip.current = null)}
        onDoubleClick={() => setWidth(usualPanel(window.innerWidth))}
        onKeyDown={key}
      />
      <div ref={sections} className="panel-sections">
        {children}
      </div>
    </aside>
  );
}
