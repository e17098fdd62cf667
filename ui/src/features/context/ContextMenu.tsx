import { createPortal } from "react-dom";
import { MenuAt } from "../../shared/layers/MenuAt";
import { closeMenu, focusAgain, useContextMenu } from "../../state/window/context_menu";
import { itemsOf } from "./items";

const LABELS = { design: "What can be done here", field: "Text of the field", text: "Selected text", window: "Window" };

/** The menu of a right click, over what it is on: a dialog lies over everything that is not in it. */
export function ContextMenu() {
  const opened = useContextMenu((menu) => menu.opened);
  if (!opened) return null;
  // Of several the focus can only be in the uppermost; without it there, the last comes over those before it.
  const host =
    opened.focus?.closest("dialog[open]") ?? [...document.querySelectorAll("dialog[open]")].at(-1) ?? document.body;
  return createPortal(
    <MenuAt
      key={opened.id}
      label={LABELS[opened.place]}
      at={opened.at}
      items={() => itemsOf(opened.place)}
      back={() => focusAgain(opened)}
      close={closeMenu}
    />,
    host,
  );
}
