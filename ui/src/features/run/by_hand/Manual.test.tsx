// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { place } from "../../../shared/testing";
import { useRun } from "../../../state/machine/run";
import { machineState } from "../../../state/testing";
import { Manual } from "./Manual";

const at = place();

beforeEach(() => {
  platform.ask.mockReset().mockReturnValue(new Promise(() => {}));
  useRun.setState({ recorded: [] });
  at.show(<Manual state={machineState("ready", "jog")} />);
});

function field(label: string): HTMLInputElement {
  const found = at.host.querySelector<HTMLInputElement>(`input[aria-label^="${label}"]`);
  if (!found) throw new Error(`no field ${label}`);
  return found;
}

function enter(into: HTMLInputElement, text: string): void {
  act(() => {
    // React listens to the setter of the prototype.
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(into, text);
    into.dispatchEvent(new Event("input", { bubbles: true }));
  });
  act(() => void into.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true })));
}

const moves = (): unknown[] =>
  platform.ask.mock.calls.filter(([name]) => name === "order").flatMap(([, { request }]) => request.moves);

describe("Enter in a field of the manual mode", () => {
  it("moves by the number that was just typed: by another one the machine would go where the user does not want it", () => {
    enter(field("Feed by"), "2.5");
    enter(field("Bend by"), "-20");
    enter(field("Rotate by"), "15");
    expect(moves()).toEqual([
      { move: "feed", mm: 2.5 },
      { move: "rotate", deg: 15 },
    ]);
  });

  it.each(["", "abc", "1/0"])("does not move by what is no number: %j", (text) => {
    enter(field("Feed by"), text);
    expect(moves()).toEqual([]);
  });
});
