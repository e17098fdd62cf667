import { describe, expect, it } from "vitest";
import { nameOf, pressedKey, STEPS } from "./jog_keys";

const press = (key: string, more: Partial<KeyboardEvent> = {}) =>
  pressedKey({ key, repeat: false, ctrlKey: false, altKey: false, metaKey: false, ...more }, STEPS.medium, "medium");

describe("moving by keys", () => {
  it.each([
    ["ArrowRight", "feed", 1],
    ["ArrowLeft", "feed", -1],
    ["ArrowUp", "bend", 5],
    ["ArrowDown", "bend", -5],
    ["PageUp", "rotate", 5],
    ["PageDown", "rotate", -5],
  ])("%s moves %s by the step that is shown", (key, axis, by) => {
    expect(press(key)).toEqual({ kind: "move", axis, by });
  });

  it("moves once for a key that is held down", () => {
    expect(press("ArrowUp", { repeat: true })).toEqual({ kind: "nothing" });
  });

  it("takes no letter, no Ctrl and no Space: STOP has Ctrl-Space", () => {
    for (const key of ["m", "x", " ", "Enter", "Tab"]) expect(press(key)).toBeNull();
    expect(press(" ", { ctrlKey: true })).toBeNull();
    expect(press("ArrowUp", { ctrlKey: true })).toBeNull();
  });

  it("goes through the steps, and no farther", () => {
    expect(press("+")).toEqual({ kind: "step", name: "coarse" });
    expect(press("-")).toEqual({ kind: "step", name: "fine" });
    const event = { key: "+", repeat: false, ctrlKey: false, altKey: false, metaKey: false };
    expect(pressedKey(event, STEPS.coarse, "coarse")).toEqual({ kind: "step", name: "coarse" });
    expect(pressedKey(event, { feed: 3, bend: 1, rotate: 1 }, null)).toEqual({ kind: "step", name: "medium" });
  });

  it("has no name for steps that a person has typed", () => {
    expect([nameOf(STEPS.fine), nameOf({ ...STEPS.fine, feed: 3 })]).toEqual(["fine", null]);
  });
});
