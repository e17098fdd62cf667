// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it } from "vitest";
import { closeMenu, focusAgain, useContextMenu } from "../state/window/context_menu";
import { listenToRightClicks } from "./right_click";

let end = () => {};
beforeEach(() => {
  document.body.innerHTML =
    '<canvas></canvas><input value="12.5"><p>read</p><div role="menu"><i>Copy</i></div><button>Arm</button>';
  end = listenToRightClicks();
});
afterEach(() => {
  end();
  closeMenu();
});

const element = (name: string) => document.querySelector<HTMLElement>(name) as HTMLElement;

/** Clicks with the right button; whether the browser shows nothing of its own, and what is shown instead. */
function click(name: string): readonly [boolean, string | undefined] {
  const at = { button: 2, clientX: 30, clientY: 40, bubbles: true, cancelable: true };
  element(name).dispatchEvent(new PointerEvent("pointerdown", at));
  const event = new MouseEvent("contextmenu", at);
  element(name).dispatchEvent(event);
  return [event.defaultPrevented, useContextMenu.getState().opened?.place];
}

it("never shows the browser's menu, which can load the page anew", () => {
  expect(click("button")).toEqual([true, "window"]);
  closeMenu();
  // The view answers for itself, also where a turn of it ends over something else.
  expect(click("canvas")).toEqual([true, undefined]);
  expect(click("[role=menu] i")).toEqual([true, undefined]);
});

it.each(["ContextMenu", "F10"])(
  "answers the key %s after the view was turned, which is no click on the view",
  (key) => {
    click("canvas");
    element("button").dispatchEvent(new KeyboardEvent("keydown", { key, shiftKey: key === "F10", bubbles: true }));
    const asked = new MouseEvent("contextmenu", { button: 0, bubbles: true, cancelable: true });
    element("button").dispatchEvent(asked);
    expect([asked.defaultPrevented, useContextMenu.getState().opened?.place]).toEqual([true, "window"]);
  },
);

it("shows no menu where a turn of the view ends elsewhere, also when a key is held with it", () => {
  element("canvas").dispatchEvent(new PointerEvent("pointerdown", { button: 2, bubbles: true }));
  element("canvas").dispatchEvent(new KeyboardEvent("keydown", { key: "Shift", bubbles: true }));
  element("button").dispatchEvent(new MouseEvent("contextmenu", { button: 2, bubbles: true, cancelable: true }));
  expect(useContextMenu.getState().opened).toBeNull();
});

it("gives the field that was clicked the focus, and back what was marked in it", () => {
  expect(click("input")).toEqual([true, "field"]);
  closeMenu();
  const field = element("input") as HTMLInputElement;
  field.setSelectionRange(1, 3);
  click("input");
  const { opened } = useContextMenu.getState();
  expect(opened).toMatchObject({ at: { x: 30, y: 40 }, marked: [1, 3] });
  field.blur();
  field.setSelectionRange(0, 0);
  if (opened) focusAgain(opened);
  expect([document.activeElement, field.selectionStart, field.selectionEnd]).toEqual([field, 1, 3]);
});
