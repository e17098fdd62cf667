import { type ReactNode, type RefObject, useEffect, useLayoutEffect, useRef, useState } from "react";
import { createPortal } from "react-dom";
import "./layers.css";

/** Something beside a button, until Esc, a click elsewhere, or until the focus leaves it. */
export function Popover({
  anchor,
  label,
  onClose,
  children,
  width,
}: {
  readonly anchor: RefObject<HTMLElement | null>;
  readonly label: string;
  readonly onClose: () => void;
  readonly children: ReactNode;
  /** px. */
  readonly width?: number;
}) {
  const box = useRef<HTMLDivElement>(null);
  const [at, setAt] = useState<{ left: number; top: number; height: number }>({ left: -9999, top: 0, height: 0 });
  useLayoutEffect(() => {
    const place = () => {
      const from = anchor.current?.getBoundingClientRect();
      const own = box.current?.getBoundingClientRect();
      if (!from || !own) return;
      const left = Math.max(8, Math.min(from.left, window.innerWidth - own.width - 8));
      setAt({ left, top: from.bottom + 4, height: window.innerHeight - from.bottom - 16 });
    };
    place();
    window.addEventListener("resize", place);
    return () => window.removeEventListener("resize", place);
  }, [anchor]);
  useEffect(() => {
    const opener = anchor.current;
    box.current?.querySelector<HTMLElement>("[data-first], button, input, select, [tabindex]")?.focus();
    const away = (event: PointerEvent) => {
      const target = event.target as Node;
      if (!box.current?.contains(target) && !opener?.contains(target)) onClose();
    };
    window.addEventListener("pointerdown", away, true);
    return () => window.removeEventListener("pointerdown", away, true);
  }, [anchor, onClose]);
  return createPortal(
    <div
      ref={box}
      className="popover"
      role="dialog"
      aria-label={label}
      style={{ left: at.left, top: at.top, width, maxHeight: at.height || undefined }}
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        onClose();
        anchor.current?.focus();
      }}
      onBlur={(event) => {
        const next = event.relatedTarget;
        if (next instanceof Node && !event.currentTarget.contains(next) && !anchor.current?.contains(next)) onClose();
      }}
    >
      {children}
    </div>,
    document.body,
  );
}
