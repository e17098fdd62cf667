import { create } from "zustand";

/** What was clicked with the right button, which says what the menu offers. */
export type MenuPlace = "design" | "field" | "text" | "window";

interface Opened {
  /** Of each opening another one: the menu begins anew. */
  readonly id: number;
  readonly place: MenuPlace;
  /** px from the upper left corner of the window. */
  readonly at: { readonly x: number; readonly y: number };
  /** What had the focus, which gets it back. */
  readonly focus: HTMLElement | null;
  /** What is marked in a field, which loses it with the focus. */
  readonly marked: readonly [number, number] | null;
}

export const useContextMenu = create<{ readonly opened: Opened | null }>()(() => ({ opened: null }));

let next = 1;

/** What takes text with a caret; null of anything else. */
export function fieldOf(element: Element | null): HTMLInputElement | HTMLTextAreaElement | null {
  if (element instanceof HTMLTextAreaElement) return element;
  const text = element instanceof HTMLInputElement && !["checkbox", "radio", "range", "button"].includes(element.type);
  return text ? element : null;
}

export function openMenu(place: MenuPlace, at: Opened["at"]): void {
  const focus = document.activeElement instanceof HTMLElement ? document.activeElement : null;
  const field = fieldOf(focus);
  // A field for numbers of the browser's own kind has no marks.
  const marked =
    field && field.selectionStart !== null ? ([field.selectionStart, field.selectionEnd ?? 0] as const) : null;
  useContextMenu.setState({ opened: { id: next++, place, at, focus, marked } });
}

export function closeMenu(): void {
  useContextMenu.setState({ opened: null });
}

/** Gives the focus back to where it was, with what was marked there. */
export function focusAgain({ focus, marked }: Opened): void {
  focus?.focus();
  if (marked) fieldOf(focus)?.setSelectionRange(...marked);
}
