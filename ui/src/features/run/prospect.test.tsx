// @vitest-environment happy-dom
import { act } from "react";
import { expect, it, vi } from "vitest";

vi.mock("../../platform", () => ({
  platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {},
}));

import type { LiveCheck } from "../../generated/responses";
import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { useProspect } from "./prospect";

const at = place();

function Shown() {
  return JSON.stringify(useProspect());
}

it("lets a person arm what collides, which the summary before it names, and not what is beyond a limit", () => {
  const limits = { feasible: true, diagnostics: [], wires: [{ time_s: 60 }] } as unknown as LiveCheck;
  useDesign.setState({ edges: new Map([[0, { id: 0, a: 0, b: 1 }]]), limits, check: { ...limits, feasible: false } });
  at.show(<Shown />);
  expect(JSON.parse(at.host.textContent ?? "")).toEqual({ program: true, feasible: true, file: null });
  act(() => useDesign.setState({ limits: { ...limits, feasible: false } }));
  expect(JSON.parse(at.host.textContent ?? "")).toEqual({ program: true, feasible: false, file: null });
});
