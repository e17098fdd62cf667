import type { MenuItem } from "../../shared/layers/Menu";
import { tell } from "../../state/asking/problems";
import { fieldOf, useContextMenu } from "../../state/window/context_menu";

/** Puts text where the caret is, as if it had been typed. */
const write = (text: string) => document.execCommand("insertText", false, text);

async function paste(): Promise<void> {
  const text = await navigator.clipboard?.readText().catch(() => null);
  if (text) write(text);
  else tell("info", "The clipboard has no text, or may not be read from here: press Ctrl+V in the field.", "paste");
}

/** What can be done in a field. The menu gives it the focus back, with what was selected in it, before it does any of it. */
export function fieldItems(): readonly MenuItem[] {
  const { opened } = useContextMenu.getState();
  const field = fieldOf(opened?.focus ?? null);
  const [from, to] = opened?.marked ?? [0, 0];
  const nothing = from === to ? "Nothing is selected in the field." : null;
  const fixed = field?.readOnly || field?.disabled ? "The field cannot be changed now." : null;
  return [
    { kind: "item", label: "Cut", why: fixed ?? nothing, run: () => void document.execCommand("cut") },
    { kind: "item", label: "Copy", why: nothing, run: () => void document.execCommand("copy") },
    { kind: "item", label: "Paste", why: fixed, run: () => void paste() },
    { kind: "rule" },
    { kind: "item", label: "Select all", why: field?.value ? null : "The field is empty.", run: () => field?.select() },
  ];
}

/** What can be done with text that is selected. */
export function textItems(): readonly MenuItem[] {
  const text = window.getSelection()?.toString() ?? "";
  return [
    {
      kind: "item",
      label: "Copy",
      run: () =>
        void navigator.clipboard
          ?.writeText(text)
          .catch(() => tell("info", "The clipboard may not be written from here: press Ctrl+C.", "copy")),
    },
  ];
}
