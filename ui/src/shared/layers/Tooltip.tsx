import * as Radix from "@radix-ui/react-tooltip";
import type { ReactElement } from "react";
import "./tooltip.css";

/** px between the button and its name. */
const APART = { right: 8, bottom: 6 } as const;

/** A name and a key beside a button that shows only a drawing; shown on hover and on focus. */
export function Tooltip({
  text,
  keys,
  side = "right",
  children,
}: {
  readonly text: string;
  readonly keys?: string | undefined;
  readonly side?: keyof typeof APART;
  readonly children: ReactElement;
}) {
  return (
    <Radix.Provider delayDuration={0} disableHoverableContent>
      <Radix.Root>
        <Radix.Trigger asChild>{children}</Radix.Trigger>
        <Radix.Portal>
          <Radix.Content className="tooltip" side={side} sideOffset={APART[side]} collisionPadding={8}>
            {text}
            {keys && <kbd>{keys}</kbd>}
          </Radix.Content>
        </Radix.Portal>
      </Radix.Root>
    </Radix.Provider>
  );
}
