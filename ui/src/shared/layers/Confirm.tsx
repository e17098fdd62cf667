import type { ReactNode } from "react";
import { Button } from "../controls/Button";
import { Dialog } from "./Dialog";

interface ConfirmProps {
  /** The question. */
  readonly title: string;
  /** What the button does that loses something. */
  readonly label: string;
  readonly onConfirm: () => void;
  readonly onClose: () => void;
  /** What is lost. */
  readonly children: ReactNode;
}

/** Asks before something is lost that no undo brings back. *Cancel* has the focus. */
export function Confirm({ title, label, onConfirm, onClose, children }: ConfirmProps) {
  return (
    <Dialog
      title={title}
      onClose={onClose}
      actions={
        <>
          <Button data-first onClick={onClose}>
            Cancel
          </Button>
          <Button kind="danger" onClick={onConfirm}>
            {label}
          </Button>
        </>
      }
    >
      {children}
    </Dialog>
  );
}
