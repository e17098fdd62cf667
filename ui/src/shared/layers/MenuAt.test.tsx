// @vitest-environment happy-dom
import { act, useState } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { NumberField } from "../controls/NumberField";
import { place } from "../testing";
import { MenuAt } from "./MenuAt";

const at = place();

let committed: number[];
let open: () => void;

/** A field, its menu, and what else can be clicked. */
function Fields() {
  const [opened, setOpened] = useState(false);
  open = () => setOpened(true);
  return (
    <>
      <NumberField label="X" value={10} onCommit={(value) => committed.push(value)} />
      <p>words</p>
      <button type="button" id="other">
        Other
      </button>
      {opened && (
        <MenuAt
          label="Text of the field"
          at={{ x: 0, y: 0 }}
          items={() => [{ kind: "item", label: "Copy", run: () => {} }]}
          back={() => field().focus()}
          close={() => setOpened(false)}
        />
      )}
    </>
  );
}

const element = (name: string) => at.host.querySelector<HTMLElement>(name) as HTMLElement;
const field = () => element("input") as HTMLInputElement;
/** Does something, and what follows from it a moment later, such as where the focus goes. */
async function then(does: () => void): Promise<void> {
  await act(async () => does());
  await act(async () => void (await vi.runAllTimersAsync()));
}

/** A click as a browser makes it: the focus goes to what was pressed, or to nothing. */
async function click(name: string): Promise<void> {
  const pressed = element(name);
  await then(() => {
    pressed.dispatchEvent(new PointerEvent("pointerdown", { button: 0, pointerType: "mouse", bubbles: true }));
  });
  await then(() => {
    if (pressed instanceof HTMLButtonElement) pressed.focus();
    else (document.activeElement as HTMLElement | null)?.blur();
  });
}

beforeEach(async () => {
  vi.useFakeTimers();
  committed = [];
  at.show(<Fields />);
  act(() => field().focus());
  act(() => {
    // React listens to the setter of the prototype.
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field(), "12");
    field().dispatchEvent(new Event("input", { bubbles: true }));
  });
  await then(() => open());
});
afterEach(() => vi.useRealTimers());

it("takes the focus, and nothing of what was typed", () => {
  expect(document.activeElement?.textContent).toBe("Copy");
  expect([field().value, committed]).toEqual(["12", []]);
});

it.each(["p", "#other"])(
  "loses nothing of what was typed where it is closed by a click on %s: the field is left by it",
  async (name) => {
    await click(name);
    expect(at.host.querySelector("[role=menu]")).toBeNull();
    expect(committed).toEqual([12]);
    expect(document.activeElement?.id).toBe(name === "p" ? "" : "other");
  },
);

it("gives the focus back with Escape, and leaves it where something else has taken it", async () => {
  await then(() => {
    document.activeElement?.dispatchEvent(new KeyboardEvent("keydown", { key: "Escape", bubbles: true }));
  });
  expect([document.activeElement, committed]).toEqual([field(), []]);
  await then(() => open());
  await then(() => element("#other").focus());
  expect(at.host.querySelector("[role=menu]")).toBeNull();
  expect([document.activeElement?.id, committed]).toEqual(["other", [12]]);
});
