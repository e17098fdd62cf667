import { tell } from "../state/asking/problems";
import { copied, pasteText, remove } from "../state/design/operations";
import { run, whyNot } from "../state/window/commands";
import { type CommandId, chordOf, commandOf } from "../state/window/keys";
import { useView } from "../state/window/view";
import { together } from "./changes";
import { followFields, typing, wasTyping } from "./fields";
import { takeTyped } from "./typed";

/** Keys that a control uses itself while it has the focus. */
function used(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  const control = target.closest("button, summary, a, input, [role=menu], [role=menubar], [role=slider]");
  return control !== null && (key === " " || key === "Enter" || key === "Home" || key === "End");
}

/** Whether a menu is open under the focus: letters are not for the design behind it. */
function inMenu({ target, ctrlKey, metaKey }: KeyboardEvent): boolean {
  return target instanceof HTMLElement && target.closest("[role=menu]") !== null && !ctrlKey && !metaKey;
}

/** Whether something that has to be answered is shown: then only STOP works. */
const asked = (): boolean => document.querySelector("dialog[open]") !== null;

/** STOP comes before everything else, whatever has the focus and whatever is shown. */
function stopPressed(event: KeyboardEvent): void {
  const entry = commandOf(chordOf(event), true);
  if (entry?.typing !== "always") return;
  event.preventDefault();
  event.stopImmediatePropagation();
  if (!event.repeat) run(entry.command);
}

/** To load the page anew would leave the machine with a connection that nobody holds. */
function reloads(event: KeyboardEvent): void {
  if (["F5", "Ctrl+F5", "Ctrl+R", "Ctrl+Shift+R"].includes(chordOf(event))) event.preventDefault();
}

/** A key that writes or deletes a sign. */
const writesSign = ({ key, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean =>
  !ctrlKey && !metaKey && !altKey && (key.length === 1 || key === "Delete" || key === "Backspace");

/** Whether undo is for the design although a field has the focus: what was typed there is taken, and changed something. */
function undoesDesign({ target, key, ctrlKey, metaKey }: KeyboardEvent): boolean {
  const taken = target instanceof HTMLElement && target.dataset.undo === "design";
  return taken && (ctrlKey || metaKey) && ["z", "y"].includes(key.toLowerCase());
}

function pressed(event: KeyboardEvent): void {
  if (event.isComposing || event.defaultPrevented || asked() || inMenu(event)) return;
  const writes = typing(event.target);
  if (!writes && wasTyping() && writesSign(event) && !used(event.target, event.key)) {
    event.preventDefault();
    const meant = commandOf(chordOf(event), false);
    if (meant?.onlyLooks) run(meant.command);
    else if (meant) tell("info", "Click in the view to use its keys.", "keys_of_view");
    return;
  }
  // While something is moved, X, Y, Z, digits and Enter belong to the move.
  if (!writes && useView.getState().handle?.handleKey(event)) {
    event.preventDefault();
    return;
  }
  const entry = commandOf(chordOf(event), writes && !undoesDesign(event));
  if (!entry || entry.native || used(event.target, event.key)) return;
  event.preventDefault();
  // What stands in a field belongs to what is saved, or asked about.
  if (writes && entry.typing === "also") takeTyped();
  if (!event.repeat || entry.command === "undo" || entry.command === "redo") run(entry.command);
}

/** Whether it cannot be done now, which the person reads: there is no button that says it. */
function refused(command: CommandId): boolean {
  const why = whyNot(command);
  if (why) tell("info", why, command);
  return why !== null;
}

/** The middle button was pressed last: it pans the view, and pastes what is marked elsewhere only where a person writes. */
let middle = false;

function clipboard(event: ClipboardEvent): void {
  if (typing(event.target) || asked() || !event.clipboardData) return;
  // Text that a person has marked, such as a line of the console, is copied as text.
  if (event.type === "copy" && !window.getSelection()?.isCollapsed) return;
  if (event.type === "paste") {
    event.preventDefault();
    if (middle) return;
    if (refused("paste")) return;
    void pasteText(event.clipboardData.getData("text/plain"));
    return;
  }
  const text = copied();
  if (!text) return;
  event.preventDefault();
  event.clipboardData.setData("text/plain", text);
  if (event.type === "cut" && !refused("cut")) remove();
}

/** WebKit reports copying only to listeners that ask for it beforehand. */
function wanted(event: Event): void {
  if (!typing(event.target) && !asked()) event.preventDefault();
}

/** Listens to the keys of the window; the function that is returned ends it. */
export function listenToKeys(): () => void {
  const stop = new AbortController();
  const { signal } = stop;
  window.addEventListener("keydown", stopPressed, { signal, capture: true });
  window.addEventListener("keydown", reloads, { signal, capture: true });
  window.addEventListener("keydown", () => (middle = false), { signal, capture: true });
  window.addEventListener("pointerdown", ({ button }) => (middle = button === 1), { signal, capture: true });
  window.addEventListener("keydown", pressed, { signal });
  for (const type of ["copy", "cut", "paste"] as const) document.addEventListener(type, clipboard, { signal });
  for (const type of ["beforecopy", "beforecut", "beforepaste"]) document.addEventListener(type, wanted, { signal });
  return together([followFields(), () => stop.abort()]);
}
