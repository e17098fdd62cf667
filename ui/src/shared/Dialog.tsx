import { type ReactNode, useEffect, useId, useRef } from "react";
import { Button } from "./Button";
import "./layers.css";

/**
 * Something that has to be answered before the work goes on. Esc and the cross call `onClose`; without it neither is there.
 * What is to be focused first has `data-first`; otherwise it is the first control.
 */
export function Dialog({
  title,
  onClose,
  children,
  actions,
  wide,
}: {
  readonly title: string;
  readonly onClose?: (() => void) | undefined;
  readonly children: ReactNode;
  /** Buttons at the foot, the one that goes on last. */
  readonly actions?: ReactNode;
  readonly wide?: boolean;
}) {
  const dialog = useRef<HTMLDialogElement>(null);
  const id = useId();
  useEffect(() => {
    const shown = dialog.current;
    const before = document.activeElement;
    shown?.showModal();
    shown?.querySelector<HTMLElement>("[data-first]")?.focus();
    return () => {
      shown?.close();
      if (before instanceof HTMLElement) before.focus();
    };
  }, []);
  return (
    <dialog
      ref={dialog}
      className={wide ? "dialog wide" : "dialog"}
      aria-labelledby={id}
      onCancel={(event) => {
        event.preventDefault();
        onClose?.();
      }}
    >
      <header className="dialog-head">
        <h2 id={id}>{title}</h2>
        {onClose && <Button kind="quiet" icon="close" aria-label="Close" onClick={onClose} />}
      </header>
      {/* It scrolls where the window is low, also by keys. */}
      <div className="dialog-body" tabIndex={0}>
        {children}
      </div>
      {actions && <footer className="dialog-foot">{actions}</footer>}
    </dialog>
  );
}
