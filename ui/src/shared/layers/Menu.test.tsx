// @vitest-environment happy-dom
import { act } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { place } from "../testing";
import { MenuBar } from "./Menu";

const at = place();

let ran: string[];
let recent: string[];

const item = (label: string, why: string | null = null) => ({
  kind: "item" as const,
  label,
  why,
  run: () => void ran.push(label),
});

beforeEach(() => {
  vi.useFakeTimers();
  ran = [];
  recent = ["a.obj", "b.obj"];
  const menus = [
    {
      label: "File",
      items: () => [
        item("New"),
        item("Save", "Nothing to save"),
        { kind: "menu" as const, label: "Recent", items: recent.map((name) => item(name)) },
      ],
    },
    { label: "Edit", items: () => [item("Undo")] },
  ];
  at.show(<MenuBar menus={menus} />);
});

afterEach(() => vi.useRealTimers());

const focused = () => document.activeElement?.textContent;
/** Does something, and what follows from it a moment later, such as where the focus goes. */
async function then(does: () => void): Promise<void> {
  await act(async () => does());
  await act(async () => void (await vi.runAllTimersAsync()));
}
/** Whether the browser does with it what it does. */
const stroke = (key: string): boolean =>
  document.activeElement?.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true })) ??
  false;
async function press(...keys: string[]): Promise<void> {
  for (const key of keys) await then(() => void stroke(key));
}
async function open(): Promise<void> {
  await then(() => at.host.querySelector<HTMLElement>(".menu-head")?.focus());
  await press("ArrowDown");
}
const click = () => then(() => (document.activeElement as HTMLElement).click());

it("goes down, around and across with the arrows", async () => {
  await open();
  expect(focused()).toBe("New");
  // STOP and all else behind it can be clicked.
  expect(document.body.style.pointerEvents).toBe("");
  await press("ArrowUp");
  expect(focused()).toBe("Recent");
  await press("ArrowDown", "ArrowDown");
  expect(focused()).toBe("Save");
  await press("ArrowLeft");
  expect(focused()).toBe("Undo");
});

it("loses no key of those that are pressed at once, and none goes to the window", async () => {
  await then(() => {
    at.host.querySelector<HTMLElement>(".menu-head")?.focus();
    for (const key of ["ArrowRight", "ArrowLeft", "ArrowDown"]) stroke(key);
  });
  act(() => {
    for (const key of ["ArrowDown", "ArrowDown"]) stroke(key);
  });
  expect(focused()).toBe("Recent");
  act(() => stroke("Escape"));
  expect(focused()).toBe("File");
});

it("leaves the menus with Tab", async () => {
  await open();
  act(() => expect(stroke("Tab")).toBe(true));
  // From here the browser takes over.
  expect(focused()).toBe("File");
  expect(at.host.querySelector("[role=menu]")).toBeNull();
});

it("opens what is inside, and comes back to where that hangs", async () => {
  await open();
  await press("End", "ArrowRight");
  expect(focused()).toBe("a.obj");
  await press("ArrowDown", "ArrowLeft");
  expect(focused()).toBe("Recent");
  expect(at.host.querySelectorAll("[role=menu]").length).toBe(1);
});

it("runs what is chosen and closes, but not what cannot be used", async () => {
  await open();
  await press("ArrowDown");
  await click();
  expect(ran).toEqual([]);
  await press("Home");
  await click();
  expect(ran).toEqual(["New"]);
  // Where nothing has the focus the next key would be for the whole window.
  expect(focused()).toBe("File");
  expect(at.host.querySelector("[role=menu]")).toBeNull();
});

it("shows what there is when it is opened", async () => {
  await open();
  await press("Escape");
  recent = ["c.obj"];
  await press("ArrowDown", "End", "ArrowRight");
  expect(focused()).toBe("c.obj");
});

it("closes with Escape and gives the focus back", async () => {
  await open();
  await press("Escape");
  expect(focused()).toBe("File");
  expect(at.host.querySelector("[role=menu]")).toBeNull();
});
