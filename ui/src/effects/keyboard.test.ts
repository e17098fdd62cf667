// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

const ran: string[] = [];
let why: string | null = null;
vi.mock("../state/window/commands", () => ({ run: (id: string) => ran.push(id), whyNot: () => why }));
const platform = vi.hoisted(() => ({ ask: vi.fn(async () => null), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../platform", () => ({ platform, Refused: class Refused extends Error {} }));
const { useDesign } = await import("../state/design/design");
const { useProblems } = await import("../state/asking/problems");
const { useSelection } = await import("../state/design/selection");
const { listenToKeys } = await import("./keyboard");
const { KEYS } = await import("../state/window/keys");
const { useView } = await import("../state/window/view");

let end = () => {};
beforeEach(() => {
  ran.length = 0;
  why = null;
  document.body.innerHTML = "";
  useView.setState({ handle: null });
  end = listenToKeys();
});
afterEach(() => end());

function press(key: string, target: EventTarget = document.body, held: KeyboardEventInit = {}): KeyboardEvent {
  const event = new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...held });
  target.dispatchEvent(event);
  return event;
}

function add(html: string): Element {
  document.body.innerHTML = html;
  const element = document.body.querySelector("[data-target]");
  if (!element) throw new Error("nothing to press on");
  return element;
}

describe("keys of the window", () => {
  it("do what the table says, and nothing else of the browser", () => {
    expect(press("g").defaultPrevented).toBe(true);
    expect(press("Tab").defaultPrevented).toBe(false);
    expect(ran).toEqual(["move"]);
  });

  it("are letters in a field, where saving still works", () => {
    const field = add('<input type="text" data-target>');
    press("g", field);
    press("z", field, { ctrlKey: true });
    press("s", field, { ctrlKey: true });
    expect(ran).toEqual(["save"]);
  });

  it("save what stands in a field, which goes on being written in", () => {
    const field = add('<input type="text" data-target>') as HTMLInputElement;
    field.addEventListener("blur", () => ran.push("taken"));
    field.focus();
    press("s", field, { ctrlKey: true });
    expect(ran).toEqual(["taken", "save"]);
    expect(document.activeElement).toBe(field);
  });

  it("undo what a field has changed, while nothing else is typed in it", () => {
    const field = add('<input type="text" data-undo="design" data-target>');
    press("z", field, { ctrlKey: true });
    press("m", field);
    field.removeAttribute("data-undo");
    press("z", field, { ctrlKey: true });
    expect(ran).toEqual(["undo"]);
  });

  it("do nothing to the design while a field was used last, although it has lost the focus", () => {
    const field = add('<div><input type="text" data-target><p>mm</p></div><canvas class="work" tabindex="0"></canvas>');
    (field as HTMLElement).focus();
    (field as HTMLElement).blur();
    for (const key of ["m", "x", "Delete", "1", " "]) expect(press(key).defaultPrevented).toBe(true);
    expect(ran).toEqual([]);
    expect(useProblems.getState().problems.map(({ code }) => code)).toEqual(["keys_of_view"]);
    press("s", document.body, { ctrlKey: true });
    press("Escape");
    expect(ran).toEqual(["save", "end"]);
    document.querySelector("canvas")?.dispatchEvent(new PointerEvent("pointerdown", { bubbles: true }));
    press("m");
    expect(ran.at(-1)).toBe("merge");
    useProblems.setState({ problems: [] });
  });

  it("that only look work after a field too, but none that changes what there is or what the next letters do", () => {
    const field = add('<div><input type="text" data-target><p>mm</p></div>');
    (field as HTMLElement).focus();
    (field as HTMLElement).blur();
    // Every sign that a key of the window has.
    const signs = KEYS.filter(({ native }) => !native).flatMap(({ keys }) => keys.filter((key) => key.length === 1));
    for (const key of [...signs, "Delete", "Backspace", " "])
      press(key.toLowerCase() === "delete" ? key : key.toLowerCase());
    expect(ran).toEqual(["frame", "dimensions", "keys"]);
    useProblems.setState({ problems: [] });
  });

  it("do nothing to the design after Tab from a field to a button, which takes its own", () => {
    const field = add('<input type="text" data-target><button>Arm</button><canvas class="work" tabindex="0"></canvas>');
    (field as HTMLElement).focus();
    const button = document.querySelector("button");
    button?.focus();
    for (const key of ["m", "Delete"]) expect(press(key, button ?? undefined).defaultPrevented).toBe(true);
    expect(press(" ", button ?? undefined).defaultPrevented).toBe(false);
    expect(ran).toEqual([]);
    document.querySelector("canvas")?.focus();
    press("m");
    expect(ran).toEqual(["merge"]);
    useProblems.setState({ problems: [] });
  });

  it("work again once a button was clicked, and after a dialog with fields", () => {
    const field = add('<input type="text" data-target><button>Arm</button><dialog><input type="text"></dialog>');
    (field as HTMLElement).focus();
    document.querySelector("button")?.dispatchEvent(new PointerEvent("pointerdown", { bubbles: true }));
    document.querySelector("button")?.focus();
    press("m");
    const asked = document.querySelector<HTMLInputElement>("dialog input");
    asked?.focus();
    asked?.blur();
    press("c");
    expect(ran).toEqual(["merge", "connect"]);
  });

  it("do not load the page anew", () => {
    for (const held of [{}, { ctrlKey: true }]) expect(press("F5", document.body, held).defaultPrevented).toBe(true);
    expect(press("r", document.body, { ctrlKey: true }).defaultPrevented).toBe(true);
    expect(ran).toEqual([]);
  });

  it("stop the machine wherever the focus is, also under a question, also while composing, once a press", () => {
    const field = add('<dialog open><input type="text" data-target></dialog>');
    press(" ", field, { ctrlKey: true, isComposing: true });
    press(" ", field, { ctrlKey: true, repeat: true });
    press("Delete");
    expect(ran).toEqual(["stop"]);
  });

  it("leave Space to a button that has the focus", () => {
    press(" ", add("<button data-target>Arm</button>"));
    expect(ran).toEqual([]);
    press(" ");
    expect(ran).toEqual(["play"]);
  });

  it("are not for the design while a menu is open over it", () => {
    const entry = add('<div role="menu"><button role="menuitem" data-target>Undo</button></div>');
    for (const key of ["x", "Delete", "g", "s"]) expect(press(key, entry).defaultPrevented).toBe(false);
    expect(ran).toEqual([]);
    press("s", entry, { ctrlKey: true });
    expect(ran).toEqual(["save"]);
  });

  it("belong to a move while there is one", () => {
    const taken: string[] = [];
    const handle = { handleKey: (event: KeyboardEvent) => taken.push(event.key) > 0 } as unknown as NonNullable<
      ReturnType<typeof useView.getState>["handle"]
    >;
    useView.setState({ handle });
    press("x");
    expect([taken, ran]).toEqual([["x"], []]);
  });

  it("paste, and the middle button does not", () => {
    why = "Nothing may be pasted now";
    useProblems.setState({ problems: [] });
    const paste = () => {
      const event = new ClipboardEvent("paste", { bubbles: true, cancelable: true, clipboardData: new DataTransfer() });
      document.body.dispatchEvent(event);
      return [event.defaultPrevented, useProblems.getState().problems.length];
    };
    document.body.dispatchEvent(new PointerEvent("pointerdown", { button: 1, bubbles: true }));
    expect(paste()).toEqual([true, 0]);
    press("v", document.body, { ctrlKey: true });
    expect(paste()).toEqual([true, 1]);
    useProblems.setState({ problems: [] });
  });

  it("do not cut or paste what may not be changed, and say why", () => {
    useDesign.setState({ vertices: new Map([[1, { id: 1, at: [0, 0, 0], support: false }]]) });
    useSelection.setState({ vertices: new Set([1]), edges: new Set() });
    why = "A machine is bending the wire.";
    for (const type of ["cut", "paste"])
      document.body.dispatchEvent(
        new ClipboardEvent(type, { bubbles: true, cancelable: true, clipboardData: new DataTransfer() }),
      );
    expect(platform.ask).not.toHaveBeenCalled();
    expect(useProblems.getState().problems.map(({ message }) => message)).toEqual(["A machine is bending the wire."]);
  });

  it("repeat only where that makes sense", () => {
    press("x", document.body, { repeat: true });
    press("z", document.body, { repeat: true, ctrlKey: true });
    expect(ran).toEqual(["undo"]);
  });
});
