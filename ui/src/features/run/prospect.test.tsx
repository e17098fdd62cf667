// @vitest-environment happy-dom
import { act } from "react";
import { expect, it, vi } from "vitest";

vi.mock("../../platform", () => ({
  platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {
    refusal = { code: "not-feasible" };
  },
}));

import type { LiveCheck } from "../../generated/responses";
import { Refused } from "../../platform";
import { place } from "../../shared/testing";
import { ofDesign, useDesign } from "../../state/design/design";
import { useProspect } from "./prospect";

const at = place();

function Shown() {
  return JSON.stringify(useProspect());
}

it("refuses to arm what Check refuses, a collision as well as what is beyond a limit", () => {
  const limits = { feasible: true, diagnostics: [], wires: [{ time_s: 60 }] } as unknown as LiveCheck;
  const seen = () => JSON.parse(at.host.textContent ?? "");
  useDesign.setState({ edges: new Map([[0, { id: 0, a: 0, b: 1 }]]), limits, check: limits });
  at.show(<Shown />);
  expect(seen()).toEqual({ machine: null, program: true, feasible: true, file: null });
  act(() => useDesign.setState({ check: { ...limits, feasible: false } }));
  expect(seen()).toEqual({ machine: null, program: true, feasible: false, file: null });
});

it("knows of a refusal that the checks, which were stopped, did not foresee, until the design changes", async () => {
  const limits = { feasible: true, diagnostics: [], wires: [{ time_s: 60 }] } as unknown as LiveCheck;
  const feasible = () => JSON.parse(at.host.textContent ?? "").feasible;
  useDesign.setState({ edges: new Map([[0, { id: 0, a: 0, b: 1 }]]), limits, check: limits });
  at.show(<Shown />);
  const refusal = new Refused({ code: "not-feasible" } as never);
  await act(() => expect(ofDesign(Promise.reject(refusal))).rejects.toBe(refusal));
  expect(feasible()).toBe(false);
  act(() => useDesign.setState(({ version }) => ({ version: version + 1 })));
  expect(feasible()).toBe(true);
});
