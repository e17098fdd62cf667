import { createContext, type ReactNode, use, useEffect, useId, useRef } from "react";
import { Button } from "../controls/Button";
import "./dialog.css";

/**
 * What stands in the head of every dialog, beside its title: a dialog makes everything behind it inert, STOP in the top bar too.
 */
export const DialogHead = createContext<ReactNode>(null);

/**
 * Something that has to be answered before the work continues. Esc and the cross call `onClose`; without it neither is there.
 * What is to be focused first has `data-first`; otherwise it is the cross, or what the dialog says.
 */
export function Dialog({
  title,
  onClose,
  children,
  actions,
  wide,
  large,
}: {
  readonly title: string;
  readonly onClose?: (() => void) | undefined;
  readonly children: ReactNode;
  /** Buttons at the foot, the one that leads on last. */
  readonly actions?: ReactNode;
  readonly wide?: boolean;
  /** As large as the window lets it, as high whatever is in it; what is in it scrolls itself. */
  readonly large?: boolean;
}) {
  const dialog = useRef<HTMLDialogElement>(null);
  const id = useId();
  const head = use(DialogHead);
  useEffect(() => {
    const shown = dialog.current;
    const before = document.activeElement;
    const section = before?.closest("section")?.querySelector<HTMLElement>("h2 button");
    shown?.showModal();
    const first =
      shown?.querySelector<HTMLElement>("[data-first]") ??
      shown?.querySelector<HTMLElement>("[data-close]") ??
      shown?.querySelector<HTMLElement>(".dialog-body");
    first?.focus();
    return () => {
      shown?.close();
      // What has opened it may be gone by what was done in it: then where that was.
      if (before instanceof HTMLElement) (before.isConnected ? before : section)?.focus();
    };
  }, []);
  return (
    <dialog
      ref={dialog}
      className={large ? "dialog large" : wide ? "dialog wide" : "dialog"}
      aria-labelledby={id}
      onCancel={(event) => {
        // Esc in a dialog that was opened from this one is for that one alone.
        if (event.target !== event.currentTarget) return;
        event.preventDefault();
        onClose?.();
      }}
    >
      <header className="dialog-head">
        <h2 id={id}>{title}</h2>
        {head && <div className="dialog-also">{head}</div>}
        {onClose && <Button data-close kind="quiet" icon="close" aria-label="Close" onClick={onClose} />}
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: where the window is low it scrolls, also by keys */}
      <div className="dialog-body" tabIndex={0}>
        {children}
      </div>
      {actions && <footer className="dialog-foot">{actions}</footer>}
    </dialog>
  );
}
