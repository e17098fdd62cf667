// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { AvoidedCollisions, Collisions, DiagnosticReport, UnfoundReport } from "../../generated/responses";
import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { avoidCollisions, setSearch, useAvoiding } from "../../state/design/fixes/avoiding";
import { Avoid } from "./Avoid";

const at = place();
const text = () => at.host.textContent ?? "";
const again = () =>
  [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent?.includes("Search again"));
const found: Collisions = { checked: true, stopped: false, bodies: 6, estimates: 0, contacts: [] };
const search = {
  steps_checked: 0,
  passed: null,
  of: null,
  exhausted: false,
  tried: [],
  helps: [],
} as unknown as UnfoundReport;
const report = { code: "no_clear_program", vertex: 3, vertices: [3, 8], search } as unknown as DiagnosticReport;
const outcome = (unfound: DiagnosticReport[]): AvoidedCollisions => ({
  found: false,
  steps_checked: 0,
  ended: false,
  best: null,
  unfound,
  helps: [],
});

async function searched(unfound: DiagnosticReport[]): Promise<void> {
  platform.ask.mockReset().mockResolvedValue(outcome(unfound));
  at.show(<Avoid />);
  await act(avoidCollisions);
}

beforeEach(() => {
  useAvoiding.setState({ avoiding: null });
  setSearch({ effort: null, seed: null, weights: null, wires: null });
  useDesign.setState({ collisions: { found, version: 0, profiles: 0, dragged: false } });
});

it("says that nothing was searched, and not that nothing was found, and offers no search that would say the same", async () => {
  await searched([report]);
  expect(text()).toContain("It was not searched: bends that no order avoids come first.");
  expect(text()).toContain("The bends at vertices 3, 8");
  expect(text()).not.toContain("No order of the bends");
  expect(again()?.getAttribute("aria-disabled")).toBe("true");
  // Other wires may have no such bend.
  act(() => setSearch({ wires: 3 }));
  expect(again()?.getAttribute("aria-disabled")).toBeNull();
});

it("can search again where a part was searched", async () => {
  const other = { ...report, search: { ...search, steps_checked: 40, exhausted: true } };
  await searched([report, other]);
  expect(text()).toContain("No order of the bends without a collision was found.");
  expect(again()?.getAttribute("aria-disabled")).toBeNull();
});
