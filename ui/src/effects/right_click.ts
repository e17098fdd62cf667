import { fieldOf, type MenuPlace, openMenu } from "../state/window/context_menu";
import type { End } from "./changes";

/** What a right click is on. */
function placeOf(target: Element): MenuPlace {
  if (fieldOf(target)) return "field";
  const marked = window.getSelection();
  return marked && !marked.isCollapsed && marked.containsNode(target, true) ? "text" : "window";
}

/** The window's own menu wherever it is asked for, and never the browser's: that one reloads the page while a machine moves. */
export function listenToRightClicks(): End {
  const stop = new AbortController();
  const { signal } = stop;
  let pressed: EventTarget | null = null;
  window.addEventListener("pointerdown", ({ target, button }) => (pressed = button === 2 ? target : null), {
    signal,
    capture: true,
  });
  // The keys that ask for a menu: what the pointer has pressed before is over.
  const byKey = ({ key }: KeyboardEvent) => {
    if (key === "ContextMenu" || key === "F10") pressed = null;
  };
  window.addEventListener("keydown", byKey, { signal, capture: true });
  const asked = (event: MouseEvent) => {
    const { target } = event;
    // The view has answered for itself: it turns with the right button, and a click alone is a question.
    const answered = event.defaultPrevented || pressed instanceof HTMLCanvasElement;
    event.preventDefault();
    if (answered || !(target instanceof Element) || target.closest("[role=menu]")) return;
    const field = fieldOf(target);
    if (field && document.activeElement !== field) field.focus();
    openMenu(placeOf(target), { x: event.clientX, y: event.clientY });
  };
  window.addEventListener("contextmenu", asked, { signal });
  return () => stop.abort();
}
