import * as Radix from "@radix-ui/react-popover";
import { type ReactElement, type ReactNode, useRef } from "react";
import "./popover.css";

/** px between the button and what it opens, and from the edges of the window. */
const APART = 4;
const FROM_EDGE = 8;

/** Something beside the button that opens it, until Esc, a click elsewhere, or until the focus leaves it. */
export function Popover({
  button,
  label,
  open,
  onOpenChange,
  children,
  width,
}: {
  readonly button: ReactElement;
  readonly label: string;
  readonly open: boolean;
  readonly onOpenChange: (open: boolean) => void;
  readonly children: ReactNode;
  /** px. */
  readonly width?: number;
}) {
  const opener = useRef<HTMLButtonElement>(null);
  return (
    <Radix.Root open={open} onOpenChange={onOpenChange}>
      <Radix.Trigger ref={opener} asChild>
        {button}
      </Radix.Trigger>
      <Radix.Portal>
        <Radix.Content
          className="popover"
          aria-label={label}
          align="start"
          sideOffset={APART}
          collisionPadding={FROM_EDGE}
          // At once: Radix does it a moment later, and a key in between would be for the whole window.
          onEscapeKeyDown={() => opener.current?.focus()}
          style={{ width, maxHeight: "var(--radix-popover-content-available-height)" }}
        >
          {children}
        </Radix.Content>
      </Radix.Portal>
    </Radix.Root>
  );
}
