import { fieldOf } from "../state/window/context_menu";
import { type End, together } from "./changes";

/** Whether the focus is where a person writes, so that letters are letters. */
export function typing(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  return target.isContentEditable || target instanceof HTMLSelectElement || fieldOf(target) !== null;
}

/** A field was used last, and nothing since: what is typed now was meant for it, although it has lost the focus. */
let lost = false;

/** Whether a letter would be for a field that has lost the focus, and not for the view. */
export const wasTyping = (): boolean => lost;

/**
 * Follows what is used last: a field, until the view has the focus, or a button is clicked. Tab goes from a field to a button, and what is
 * typed then may still be meant for the field. Fields of a dialog go with it.
 */
export function followFields(): End {
  const stop = new AbortController();
  const { signal } = stop;
  lost = false;
  const used = ({ target }: Event) => {
    if (!(target instanceof Element)) return;
    if (typing(target)) lost = target.closest("dialog") === null;
    else if (target.closest(".work, dialog, [role=menu]")) lost = false;
  };
  const pressed = ({ target }: Event) => {
    if (target instanceof Element && target.closest(".work, button, [role=menu]")) lost = false;
  };
  window.addEventListener("focusin", used, { signal, capture: true });
  window.addEventListener("pointerdown", pressed, { signal, capture: true });
  return together([() => stop.abort(), () => (lost = false)]);
}
