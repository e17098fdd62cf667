import { describe, expect, it } from "vitest";
import { chordOf, commandOf, KEYS } from "./keys";

const press = (key: string, held: Partial<Record<"ctrlKey" | "metaKey" | "shiftKey" | "altKey", boolean>> = {}) =>
  chordOf({ key, ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, ...held });

describe("keys", () => {
  it("are written the same however they are typed", () => {
    expect(press("g")).toBe("G");
    expect(press("Z", { ctrlKey: true, shiftKey: true })).toBe("Ctrl+Shift+Z");
    expect(press("z", { metaKey: true })).toBe("Ctrl+Z");
    expect(press("?", { shiftKey: true })).toBe("?");
    expect(press(" ", { ctrlKey: true })).toBe("Ctrl+Space");
    expect(press("Escape")).toBe("Escape");
  });

  it("have one meaning each", () => {
    const all = KEYS.flatMap(({ keys }) => keys);
    expect(new Set(all).size).toBe(all.length);
  });

  it("leave letters to a field, but never STOP", () => {
    expect(commandOf("G", true)).toBeNull();
    expect(commandOf("Ctrl+Z", true)).toBeNull();
    expect(commandOf("Ctrl+S", true)?.command).toBe("save");
    expect(commandOf("Ctrl+Space", true)?.command).toBe("stop");
    expect(commandOf("G", false)?.command).toBe("move");
  });

  it("delete with X, so that a strange key does nothing", () => {
    expect(commandOf("X", false)?.command).toBe("delete");
    expect(commandOf("Alt+X", false)).toBeNull();
  });
});
