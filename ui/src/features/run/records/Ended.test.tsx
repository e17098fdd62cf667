// @vitest-environment happy-dom
import { act } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";

vi.mock("../../../platform", () => ({
  platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {},
}));

import { place } from "../../../shared/testing";
import { useProblems } from "../../../state/asking/problems";
import type { WireRun } from "../../../state/machine/operator";
import { useRun } from "../../../state/machine/run";
import { Ended } from "./Ended";

const at = place();
const run = { outcome: "stopped", made: 3, steps: 8, elapsed_s: 4, piece: null, problem: null } as unknown as WireRun;
const said = () => useProblems.getState().problems.map(({ message }) => message);

/** The panel reaches from 0 to 700; the line is at so many px of it. */
function show(top: number, pointed: boolean): ReturnType<typeof vi.fn> {
  vi.spyOn(Element.prototype, "getBoundingClientRect").mockImplementation(function (this: Element) {
    return this.tagName === "UL" ? new DOMRect(0, top, 300, 40) : new DOMRect(0, 0, 340, 700);
  });
  const matches = Element.prototype.matches;
  vi.spyOn(Element.prototype, "matches").mockImplementation(function (this: Element, to: string) {
    return to === ":hover" ? pointed : matches.call(this, to);
  });
  const scrolled = vi.fn();
  Element.prototype.scrollIntoView = scrolled;
  at.show(
    <div className="panel-sections">
      <Ended />
    </div>,
  );
  act(() => useRun.setState({ ended: run }));
  return scrolled;
}

beforeEach(() => useProblems.setState({ problems: [] }));
afterEach(() => {
  vi.restoreAllMocks();
  act(() => useRun.setState({ ended: null }));
});

it("is scrolled to below the edge of the panel, where nothing is pointed at", () => {
  expect(show(800, false)).toHaveBeenCalledOnce();
  expect(said()).toEqual([]);
});

it("is told over the view where the pointer rests in the panel, until there is another", () => {
  expect(show(800, true)).not.toHaveBeenCalled();
  expect(said()).toEqual(["Stopped after step 3 of 8. Home the machine, then resume the wire or give it up."]);
  act(() => useRun.setState({ ended: null }));
  expect(said()).toEqual([]);
});

it("is said once where it can be read", () => {
  expect(show(300, true)).not.toHaveBeenCalled();
  expect(said()).toEqual([]);
});
