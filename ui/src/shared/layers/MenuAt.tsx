import * as Radix from "@radix-ui/react-menubar";
import { type CSSProperties, useRef } from "react";
import { FROM_EDGE, type MenuItem, Opened, withinMenu } from "./Menu";

/** The menu is above all that is laid over the view, and below the top bar: STOP stays in sight. */
const TOP_BAR = 44;
const ROOM = { top: TOP_BAR + FROM_EDGE, right: FROM_EDGE, bottom: FROM_EDGE, left: FROM_EDGE };

/** Whether nothing has taken the focus from the menu. */
function isFocusFree(): boolean {
  const at = document.activeElement;
  return at === null || at === document.body || at.closest("[role=menu]") !== null;
}

/** A menu at a place of the window, without a head: what a right click opens. `back` gives the focus to where it was. */
export function MenuAt({
  label,
  at,
  items,
  back,
  close,
}: {
  readonly label: string;
  readonly at: { readonly x: number; readonly y: number };
  readonly items: () => readonly MenuItem[];
  readonly back: () => void;
  readonly close: () => void;
}) {
  const list = useRef<HTMLDivElement>(null);
  const changed = (open: string) => {
    if (open !== "") return;
    // A click elsewhere closes it before it moves the focus: where that was is left by it, as without a menu.
    if (isFocusFree()) back();
    close();
  };
  const place: CSSProperties = { left: at.x, top: at.y };
  return (
    <Radix.Root aria-label={label} value="at" onValueChange={changed} className="menu-place" style={place}>
      <Radix.Menu value="at">
        {/* It only says where: the menu has no head to go back to. */}
        <Radix.Trigger tabIndex={-1} aria-label={label} className="menu-at" />
        <Radix.Content
          ref={list}
          className="menu"
          aria-label={label}
          loop
          side="right"
          align="start"
          collisionPadding={ROOM}
          onKeyDownCapture={(event) => {
            withinMenu(event);
            if (event.key !== "Tab") return;
            event.preventDefault();
            event.stopPropagation();
          }}
          onEscapeKeyDown={back}
          onCloseAutoFocus={(event) => event.preventDefault()}
        >
          <Opened
            items={items}
            list={list}
            choose={(run) => {
              back();
              run();
            }}
          />
        </Radix.Content>
      </Radix.Menu>
    </Radix.Root>
  );
}
