// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { Collisions, ContactReport } from "../../generated/responses";
import { type CollisionsOf, useDesign } from "../design/design";
import { designState } from "../testing";
import { metAt, type PlayedContact, setStops, stopBetween, touchesNow } from "./contacts";
import { forgetProgram, goTo } from "./program";
import { program, view } from "./testing";

const contact = (step: number, at: number, body: number | null, wire = 0) =>
  ({ wire, step, at, leg: 0, body, depth_mm: 0.3, finding: { code: "meets_machine" } }) as ContactReport;
const found: Collisions = {
  checked: true,
  stopped: false,
  bodies: 6,
  estimates: 6,
  // One of them is only near.
  contacts: [
    contact(1, 0.5, 2),
    contact(0, 1, null),
    contact(1, 0.25, 4),
    contact(0, 0.5, 3, 1),
    { ...contact(1, 0.1, 5), depth_mm: -0.2 },
  ],
};
const known = (more: Partial<CollisionsOf> = {}): CollisionsOf => ({
  found,
  version: 3,
  profiles: 0,
  dragged: false,
  ...more,
});

beforeEach(async () => {
  forgetProgram();
  setStops(true);
  platform.ask.mockImplementation(async (ask: string) => (ask === "program" ? program : view));
  useDesign.setState({
    state: designState({ machine: "kit", material: "al", name: "U", next: [3, 2] }),
    vertices: new Map(),
    edges: new Map(),
    version: 3,
    collisions: known(),
  });
  await goTo(0);
});

describe("playing", () => {
  it("pauses at each collision of its wire in turn, and goes on from there", () => {
    const first = stopBetween(0, 2);
    expect(first).toBeCloseTo(1, 5);
    expect(first).toBeLessThan(1);
    expect(stopBetween(first ?? 0, 2)).toBe(1.25);
    expect(stopBetween(1.25, 2)).toBe(1.5);
    expect(stopBetween(1.5, 2)).toBeNull();
    expect(stopBetween(1.1, 1.2)).toBeNull();
  });

  it("pauses nowhere where a person does not want it", () => {
    setStops(false);
    expect(stopBetween(0, 2)).toBeNull();
  });

  it.each([
    ["dragged vertices", { collisions: known({ dragged: true }) }],
    ["another version of the design", { collisions: known({ version: 2 }) }],
    ["another profile", { collisions: known({ profiles: 1 }) }],
    ["a design that is not that of the program", { vertices: new Map() }],
    ["a design that nobody has looked at", { collisions: null }],
  ])("does not pause for collisions of %s", (_, state) => {
    useDesign.setState(state);
    expect(stopBetween(0, 2)).toBeNull();
  });
});

describe("what is drawn red", () => {
  it("is what has met in the step that is under way", async () => {
    await goTo(1.1);
    expect(touchesNow()).toEqual([]);
    await goTo(1.25);
    expect(touchesNow()).toEqual([{ leg: 0, body: 4 }]);
    await goTo(1.9);
    expect(touchesNow()).toEqual([
      { leg: 0, body: 2 },
      { leg: 0, body: 4 },
    ]);
  });

  it("is nothing of a step that is over, nor without a program in the view", async () => {
    const contacts: PlayedContact[] = [{ ...contact(0, 0.5, 1), position: 0.5 }];
    expect(metAt(contacts, 0.7)).toHaveLength(1);
    expect(metAt(contacts, 1)).toEqual([]);
    forgetProgram();
    expect(touchesNow()).toEqual([]);
  });
});
