// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { WireFigures } from "../../generated/responses";
import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { useRunFile } from "../../state/program/run_file";
import { designState } from "../../state/testing";
import { CollisionSettings } from "./CollisionSettings";

const at = place();
const wire: WireFigures = {
  length_mm: 400,
  stock_mm: 800,
  bends: 3,
  time_s: 60,
  cost: null,
  stock_cost: null,
  currency: null,
  mass_g: null,
  sag: { deflection_mm: 3.24, step: 4, reach_mm: 300, joint: { off_mm: 0.44, step: 2, vertex: 7 } },
  route: [],
};

beforeEach(() => {
  const state = designState({ collisions: { clearance_mm: 0.5, sag: false } });
  const nothing = { vertices: [], gone_vertices: [], edges: [], gone_edges: [], stencil: false, state };
  platform.ask.mockReset().mockImplementation(async (_, { request }) => {
    const { clearance_mm, sag } = request;
    return { change: { ...nothing, state: { ...state, collisions: { clearance_mm, sag } } } };
  });
  useRunFile.setState({ file: null });
  useDesign.setState({ state, check: { feasible: true, diagnostics: [], wires: [wire], limits_unknown: null } });
});

const asked = () => platform.ask.mock.calls.filter(([name]) => name === "edit").map(([, { request }]) => request);
const open = () => act(() => at.host.querySelector<HTMLButtonElement>(".fold-head")?.click());

it("sets the clearance, and whether the part hangs, and neither takes the other back", async () => {
  at.show(<CollisionSettings />);
  expect(at.host.textContent).toBe("Collision settings0.5 mm clear");
  const kept = (collisions: { clearance_mm: number; sag: boolean }) => {
    act(() => useDesign.setState({ state: designState({ collisions }) }));
    return at.host.querySelector(".fold-phrase")?.textContent;
  };
  expect(kept({ clearance_mm: 0, sag: false })).toBe("no clearance");
  expect(kept({ clearance_mm: 12, sag: true })).toBe("12.0 mm clear, with sag");
  expect(kept({ clearance_mm: 0, sag: true })).toBe("with sag");
  kept({ clearance_mm: 0.5, sag: false });
  open();
  const [clearance, hangs] = at.host.querySelectorAll("input");
  expect([clearance?.value, hangs?.checked]).toEqual(["0.5", false]);
  // The second before the first is answered.
  await act(async () => {
    clearance?.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowUp", bubbles: true }));
    hangs?.click();
  });
  expect(asked()).toEqual([
    { edit: "collisions", clearance_mm: 1.5, sag: false },
    { edit: "collisions", clearance_mm: 1.5, sag: true },
  ]);
});

it("says how far each wire sags", () => {
  at.show(<CollisionSettings />);
  open();
  const one = "Its free end sags by up to 3.2 mm, in step 5. It is 0.4 mm off where step 3 comes back to vertex 7.";
  expect(at.host.textContent).toContain(one);
  const straight = { ...wire, sag: wire.sag && { ...wire.sag, joint: null } };
  const wires = [{ ...wire, bends: null }, straight, { ...wire, sag: null }, wire];
  act(() => useDesign.setState({ check: { feasible: true, diagnostics: [], wires, limits_unknown: null } }));
  expect(at.host.textContent).toContain("Wire 1: its free end sags by up to 3.2 mm, in step 5.Wire 3: its free end");
});
