// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it } from "vitest";
import { MenuBar } from "./Menu";
import { place } from "./testing";

const at = place();

let ran: string[];

const item = (label: string, why: string | null = null) => ({ kind: "item" as const, label, why, run: () => void ran.push(label) });

beforeEach(() => {
  ran = [];
  const menus = [
    { label: "File", items: () => [item("New"), item("Save", "Nothing to save"), { kind: "menu" as const, label: "Recent", items: [item("a.obj"), item("b.obj")] }] },
    { label: "Edit", items: () => [item("Undo")] },
  ];
  at.show(<MenuBar menus={menus} />);
});

const focused = () => document.activeElement?.textContent;
function press(...keys: string[]): void {
  for (const key of keys) act(() => void document.activeElement?.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true })));
}
function open(): void {
  act(() => at.host.querySelector<HTMLElement>(".menu-head")?.focus());
  press("ArrowDown");
}

it("goes down, around and across with the arrows", () => {
  open();
  expect(focused()).toBe("New");
  press("ArrowUp");
  expect(focused()).toBe("Recent");
  press("ArrowDown", "ArrowDown");
  expect(focused()).toBe("Save");
  press("ArrowLeft");
  expect(focused()).toBe("Undo");
});

it("opens what is inside, and comes back to where that hangs", () => {
  open();
  press("End", "ArrowRight");
  expect(focused()).toBe("a.obj");
  press("ArrowDown", "ArrowLeft");
  expect(focused()).toBe("Recent");
  expect(at.host.querySelectorAll("[role=menu]").length).toBe(1);
});

it("runs what is chosen and closes, but not what cannot be used", () => {
  open();
  press("ArrowDown");
  act(() => (document.activeElement as HTMLElement).click());
  expect(ran).toEqual([]);
  press("Home");
  act(() => (document.activeElement as HTMLElement).click());
  expect(ran).toEqual(["New"]);
  // Where nothing has the focus the next key would be for the whole window.
  expect(focused()).toBe("File");
  expect(at.host.querySelector("[role=menu]")).toBeNull();
});

it("closes with Escape and gives the focus back", () => {
  open();
  press("Escape");
  expect(focused()).toBe("File");
  expect(at.host.querySelector("[role=menu]")).toBeNull();
});
