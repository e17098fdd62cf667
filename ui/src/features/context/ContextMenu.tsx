import { createPortal } from "react-dom";
import { MenuAt } from "../../shared/layers/MenuAt";
import { closeMenu, focusAgain, useContextMenu } from "../../state/window/context_menu";
import { itemsOf } from "./items";

const LABELS = { design: "What can be done here", field: "Text of the field", text: "Marked text", window: "Window" };

/** The menu of a right click, over what it is on: a dialog lies over everything that is not in it. */
export function ContextMenu() {
  const opened = useContextMenu((menu) => menu.opened);
  if (!opened) return null;
  const host = document.querySelector("dialog[open]") ?? document.body;
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
