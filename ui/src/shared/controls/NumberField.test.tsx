// @vitest-environment happy-dom
import { act, useState } from "react";
import { beforeEach, describe, expect, it, vi } from "vitest";
import type { DisplayUnit } from "../figures/format";
import { ShownUnit } from "../figures/unit";
import { place } from "../testing";
import { NumberField } from "./NumberField";

const at = place();

let committed: number[];
let unit: DisplayUnit;

beforeEach(() => {
  committed = [];
  unit = "mm";
});

function show(props: Partial<Parameters<typeof NumberField>[0]> = {}): HTMLInputElement {
  at.show(
    <ShownUnit value={unit}>
      <NumberField label="X" value={10} onCommit={(value) => committed.push(value)} {...props} />
    </ShownUnit>,
  );
  const field = at.host.querySelector("input");
  if (!field) throw new Error("no field");
  return field;
}

function type(field: HTMLInputElement, text: string, key = "Enter"): void {
  act(() => {
    // React listens to the setter of the prototype.
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field, text);
    field.dispatchEvent(new Event("input", { bubbles: true }));
  });
  act(() => void field.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true })));
}

describe("a field for a length", () => {
  it("adds up what is typed as a sum, whatever sign it begins with", () => {
    const field = show();
    for (const [text, mm] of [
      ["-0.3+30", 29.7],
      ["12+3.5", 15.5],
      ["\u22121 \u2212 2", -3],
      ["1 in - 0.4mm", 25],
      ["1/2 in+1", 13.7],
      ["1e-1+1", 1.1],
      ["5'-6\"", 1676.4],
    ] as const) {
      committed = [];
      type(field, text);
      expect(committed[0], text).toBeCloseTo(mm, 9);
    }
  });

  it("says what it expects where it cannot read, but not while a sum is half written", () => {
    const field = show();
    const said = () => at.host.querySelector("[role=alert]")?.textContent;
    for (const text of ["12*3", "1++2", "cat", "3+cat"]) {
      type(field, text);
      expect(said(), text).toContain("or a sum such as 12+3.5");
    }
    for (const text of ["-", "12+", "0."]) {
      type(field, text, "a");
      expect(said(), text).toBeUndefined();
    }
    // Who presses Enter takes it for a number.
    for (const text of ["-", "12+"]) {
      type(field, text);
      expect(said(), text).toContain("or a sum such as 12+3.5");
    }
    expect(committed).toEqual([]);
  });

  it("shows the unit of the design and reads any", () => {
    unit = "inch";
    const field = show({ value: 25.4 });
    expect(field.value).toBe("1.000");
    expect(field.getAttribute("aria-label")).toBe("X, in");
    type(field, "12 mm");
    expect(committed).toEqual([12]);
  });

  it("has the unit of another quantity behind its number, where it is read with or without it", () => {
    const field = show({ label: "Mass", kind: "number", unit: "g", value: 1 });
    expect(at.host.querySelector(".number-field")?.lastElementChild?.textContent).toBe("g");
    expect(field.getAttribute("aria-label")).toBe("Mass, g");
    type(field, "2.5 g");
    type(field, "3");
    expect(committed).toEqual([2.5, 3]);
  });

  it("keeps what makes no sense to itself, and says so", () => {
    const field = show();
    type(field, "twelve");
    expect(committed).toEqual([]);
    expect(field.getAttribute("aria-invalid")).toBe("true");
    act(() => void field.dispatchEvent(new FocusEvent("focusout", { bubbles: true })));
    expect(field.value).toBe("10.0");
  });

  it("refuses what is outside its limits", () => {
    type(show({ min: 0, max: 20 }), "-3");
    expect(committed).toEqual([]);
  });

  it("says its limits with their unit, thousands apart, and one that it has to exceed as such", () => {
    const said = (props: Parameters<typeof show>[0], text: string) => {
      type(show(props), text, "Shift");
      return at.host.querySelector("[role=alert]")?.textContent;
    };
    expect(said({ min: 1e-3, max: 1e4, positive: true }, "0")).toBe("Expected more than 0 mm, at most 10\u202f000 mm");
    expect(said({ min: 0, max: 100 }, "200")).toBe("Expected from 0 mm to 100 mm");
    expect(said({ min: 0 }, "-1")).toBe("Expected at least 0 mm");
    expect(said({ max: 2.5 }, "3")).toBe("Expected at most 2.5 mm");
    expect(said({ kind: "angle", min: 1, max: 90 }, "91")).toBe("Expected from 1° to 90°");
    expect(said({ kind: "whole", min: 3, max: 10_000 }, "2")).toBe("Expected from 3 to 10\u202f000");
    expect(said({ kind: "percent", min: 0.001, max: 0.999 }, "0")).toBe("Expected from 0.1 % to 99.9 %");
    expect(said({ kind: "number", unit: "N", min: 1e-6, positive: true }, "0")).toBe("Expected more than 0 N");
    unit = "inch";
    expect(said({ min: 25.4, max: 25_400 }, "0")).toBe("Expected from 1 in to 1\u202f000 in");
  });

  it("still says of a value that was left with Tab that it was not taken, until the field is used again", () => {
    const said = () => at.host.querySelector("[role=alert]")?.textContent;
    const left = (field: HTMLInputElement) =>
      act(() => void field.dispatchEvent(new FocusEvent("focusout", { bubbles: true })));
    const field = show({ min: 0, max: 100 });
    type(field, "200", "Shift");
    left(field);
    expect([field.value, committed]).toEqual(["10.0", []]);
    expect(said()).toBe("“200” was not taken: expected from 0 mm to 100 mm");
    type(field, "20", "Shift");
    expect(said()).toBeUndefined();
    type(field, "cat", "Shift");
    left(field);
    expect(said()).toContain("“cat” was not taken: expected a length such as 12.5");
    // Another value is no longer about it.
    show({ value: 11, min: 0, max: 100 });
    expect(said()).toBeUndefined();
    type(field, "200", "Shift");
    left(field);
    act(() => void document.dispatchEvent(new PointerEvent("pointerdown", { bubbles: true })));
    expect(said()).toBeUndefined();
  });

  it("keeps what cannot be taken while another window has the focus, and takes what can", () => {
    const said = () => at.host.querySelector("[role=alert]")?.textContent;
    const field = show({ min: 0, max: 100 });
    const hasFocus = vi.spyOn(document, "hasFocus").mockReturnValue(false);
    const left = () => act(() => void field.dispatchEvent(new FocusEvent("focusout", { bubbles: true })));
    type(field, "200", "Shift");
    left();
    hasFocus.mockReturnValue(true);
    act(() => void field.dispatchEvent(new FocusEvent("focusin", { bubbles: true })));
    expect([field.value, said()]).toEqual(["200", "Expected from 0 mm to 100 mm"]);
    left();
    expect([field.value, said()]).toEqual(["10.0", "“200” was not taken: expected from 0 mm to 100 mm"]);
    hasFocus.mockReturnValue(false);
    type(field, "20", "Shift");
    left();
    expect(committed).toEqual([20]);
    hasFocus.mockRestore();
  });

  it("takes back what was typed with Escape", () => {
    const field = show();
    type(field, "99", "Escape");
    expect(field.value).toBe("10.0");
    expect(committed).toEqual([]);
  });

  it("does not close the dialog around it with the Escape that takes back what was typed", () => {
    const field = show();
    const pressed = () => new KeyboardEvent("keydown", { key: "Escape", bubbles: true, cancelable: true });
    type(field, "99", "Shift");
    const first = pressed();
    act(() => void field.dispatchEvent(first));
    expect(first.defaultPrevented).toBe(true);
    const second = pressed();
    act(() => void field.dispatchEvent(second));
    expect(second.defaultPrevented).toBe(false);
  });

  it("steps with the arrows, by ten with Shift, not beyond its limits", () => {
    const field = show({ max: 15 });
    act(() => void field.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowDown", bubbles: true })));
    act(
      () => void field.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowUp", shiftKey: true, bubbles: true })),
    );
    expect(committed).toEqual([9, 15]);
  });

  it("hands over with Enter what was just read, not what stood there before", () => {
    const entered: number[] = [];
    const field = show({ onEnter: (value) => entered.push(value) });
    type(field, "25");
    expect(entered).toEqual([25]);
    expect(committed).toEqual([25]);
  });

  it("hands over what stands there where nothing was typed, with all its digits", () => {
    const entered: number[] = [];
    const field = show({ value: 10.04, onEnter: (value) => entered.push(value) });
    act(() => void field.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true })));
    expect(entered).toEqual([10.04]);
    act(() => void field.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", repeat: true, bubbles: true })));
    expect(entered).toEqual([10.04]);
  });

  it.each(["", " ", "abc", "-3"])("hands over nothing where it holds %j", (text) => {
    const entered: number[] = [];
    type(show({ min: 0, onEnter: (value) => entered.push(value) }), text);
    expect(entered).toEqual([]);
    expect(committed).toEqual([]);
  });

  it("counts every press of an arrow, also before the last one has been applied", () => {
    const press = (field: HTMLInputElement, key: string) =>
      act(() => void field.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true })));
    const field = show();
    for (const key of ["ArrowUp", "ArrowUp", "ArrowUp"]) press(field, key);
    expect(committed).toEqual([11, 12, 13]);
    // The first of them is applied: the next press still continues from the last.
    press(show({ value: 11 }), "ArrowUp");
    expect(committed.at(-1)).toBe(14);
    // Another part has changed it: it continues from there.
    press(show({ value: 50 }), "ArrowDown");
    expect(committed.at(-1)).toBe(49);
  });

  it("does not change by itself: leaving a field that shows rounded digits is no edit", () => {
    const field = show({ value: 10.04 });
    type(field, "10.0", "Enter");
    expect(committed).toEqual([]);
  });
});

describe("beside its digits", () => {
  it("a click on the unit keeps the focus, and gives it to a field that has none", () => {
    const field = show();
    const unit = at.host.querySelector(".number-unit");
    const click = () => {
      const event = new MouseEvent("mousedown", { bubbles: true, cancelable: true });
      act(() => void unit?.dispatchEvent(event));
      return event.defaultPrevented;
    };
    expect([click(), document.activeElement === field]).toEqual([true, true]);
    field.setSelectionRange(1, 1);
    expect([click(), document.activeElement === field, field.selectionStart]).toEqual([true, true, 1]);
  });

  it("undo is for the design until something is typed, and again once that is taken", () => {
    const field = show();
    expect(field.dataset.undo).toBe("design");
    type(field, "12", "Shift");
    expect(field.dataset.undo).toBeUndefined();
    type(field, "12");
    expect([committed, field.dataset.undo]).toEqual([[12], "design"]);
  });

  it("the menu of a right click takes the focus, and nothing of what was typed", () => {
    const field = show();
    const menu = document.createElement("div");
    menu.setAttribute("role", "menu");
    document.body.append(menu);
    type(field, "12", "Shift");
    act(() => void field.dispatchEvent(new FocusEvent("focusout", { bubbles: true, relatedTarget: menu })));
    expect([field.value, committed]).toEqual(["12", []]);
    act(() => void field.dispatchEvent(new FocusEvent("focusout", { bubbles: true })));
    expect(committed).toEqual([12]);
    menu.remove();
  });
});

/** A form proposes a value just before the first key comes: what the key has typed is not what the proposal has replaced. */
it("keeps what is typed as soon as another value stands there", async () => {
  let propose: (value: number) => void = () => {};
  function Form() {
    const [value, setValue] = useState(30);
    propose = setValue;
    return <NumberField label="X" value={value} onCommit={(value) => committed.push(value)} />;
  }
  at.show(<Form />);
  const field = at.host.querySelector("input");
  if (!field) throw new Error("no field");
  field.focus();
  // As in a browser: nothing waits for what React has left to do.
  Object.assign(globalThis, { IS_REACT_ACT_ENVIRONMENT: false });
  const typed = new Promise<void>((done) => {
    const observer = new MutationObserver(() => {
      observer.disconnect();
      Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field, "36");
      field.dispatchEvent(new Event("input", { bubbles: true }));
      done();
    });
    observer.observe(field, { attributes: true });
  });
  setTimeout(() => propose(36.3));
  await typed;
  await new Promise((resolve) => setTimeout(resolve, 30));
  expect(field.value).toBe("36");
  field.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
  expect(committed).toEqual([36]);
  Object.assign(globalThis, { IS_REACT_ACT_ENVIRONMENT: true });
});
