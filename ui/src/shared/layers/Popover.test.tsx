// @vitest-environment happy-dom
import { act, useState } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { place } from "../testing";
import { Popover } from "./Popover";

const at = place();

function Picker() {
  const [open, setOpen] = useState(false);
  return (
    <Popover label="Wire" open={open} onOpenChange={setOpen} button={<button type="button">Steel</button>}>
      <button type="button">Brass</button>
    </Popover>
  );
}

beforeEach(() => {
  vi.useFakeTimers();
  at.show(<Picker />);
});
afterEach(() => vi.useRealTimers());

const shown = () => document.querySelector("[role=dialog]");
const focused = () => document.activeElement?.textContent;
async function open(): Promise<void> {
  await act(async () => at.host.querySelector("button")?.click());
  await act(async () => void (await vi.runAllTimersAsync()));
}

it("has a name, and the focus; what is behind it can be clicked: STOP is", async () => {
  await open();
  expect(shown()?.getAttribute("aria-label")).toBe("Wire");
  expect(focused()).toBe("Brass");
  expect(document.body.style.pointerEvents).toBe("");
  expect(at.host.closest("[aria-hidden]")).toBeNull();
});

it("closes with Escape, which goes no further, and gives the focus back at once", async () => {
  await open();
  const pressed = new KeyboardEvent("keydown", { key: "Escape", bubbles: true, cancelable: true });
  act(() => void document.activeElement?.dispatchEvent(pressed));
  expect(pressed.defaultPrevented).toBe(true);
  expect([shown(), focused()]).toEqual([null, "Steel"]);
});

it("closes when the focus goes elsewhere, and leaves it there", async () => {
  await open();
  const elsewhere = document.createElement("button");
  at.host.append(elsewhere);
  await act(async () => elsewhere.focus());
  await act(async () => void (await vi.runAllTimersAsync()));
  expect(shown()).toBeNull();
  expect(document.activeElement).toBe(elsewhere);
});
