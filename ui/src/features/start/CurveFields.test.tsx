// @vitest-environment happy-dom
import { act } from "react";
import { describe, expect, it, vi } from "vitest";
import type { LookResponse } from "../../generated/responses";
import { place } from "../../shared/testing";
import { asInput, CurveFields, cuttingFor } from "./CurveFields";

const at = place();

const edges = { shortest_edge_mm: 27.234, bend_radius_mm: 3 };
const look = {
  machine: "WireBend-kit",
  machine_edges: edges,
  edges: 6,
  bends: 5,
  curves: {
    curves: 1,
    deviation_mm: 1.83,
    at_mm: [0, 0, 0],
    coarser: 1,
    too_short: 0,
    tight: 0,
    tightest_mm: null,
    tightest_at_mm: null,
  },
} as unknown as LookResponse;

describe("how curves are cut", () => {
  it("begins with what the machine can make, and without one with the tolerance alone", () => {
    // Rounded up: what is shown is never too short.
    expect(asInput(cuttingFor({ machine_edges: edges }))).toEqual({ tolerance_mm: 0.1, shortest_edge: { mm: 27.3 } });
    expect(asInput(cuttingFor({ machine_edges: null }))).toEqual({ tolerance_mm: 0.1 });
  });

  it("shows the machine, how far off the result is, and how much is bent", () => {
    const changed = vi.fn();
    at.show(<CurveFields cutting={cuttingFor(look)} look={look} pending={false} onChange={changed} />);
    expect(at.host.textContent).toContain("What WireBend-kit can make");
    expect(at.host.textContent).toContain("Its bend radius is 3.0 mm.");
    expect(at.host.querySelector("[role=status]")?.textContent).toMatch(/Largest deviation1\.8.* mm.*6 edges, 5 bends/);
    act(() => at.host.querySelector<HTMLInputElement>("input[type=checkbox]")?.click());
    expect(changed).toHaveBeenCalledWith({ tolerance: 0.1, limited: false, shortest: 27.3 });
  });

  it("takes any tolerance that is more than nothing, and says so", () => {
    at.show(<CurveFields cutting={cuttingFor(look)} look={look} pending={false} onChange={() => {}} />);
    act(() => {
      const field = at.host.querySelector("input");
      Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(field, "0");
      field?.dispatchEvent(new Event("input", { bubbles: true }));
    });
    expect(at.host.querySelector("[role=alert]")?.textContent).toBe("Expected more than 0 mm, at most 100 mm");
  });

  it("names the bend radius of the machine beside a shortest edge of one\u2019s own, too", () => {
    const cutting = { tolerance: 0.1, limited: true, shortest: 40 };
    at.show(<CurveFields cutting={cutting} look={look} pending={false} onChange={() => {}} />);
    expect(at.host.textContent).toMatch(/WireBend-kit can make 27\.2 mm .* Its bend radius is 3\.0 mm\./);
  });

  it("promises no more than the tolerance where edges may be of any length", () => {
    const cutting = { tolerance: 0.25, limited: false, shortest: 27.3 };
    const free = { ...look, curves: null };
    at.show(<CurveFields cutting={cutting} look={free} pending={false} onChange={() => {}} />);
    expect(at.host.querySelector("[role=status]")?.textContent).toMatch(/up to 0\.[23]/);
  });

  it("shows no figures of other choices until the answer for these is there", () => {
    const cutting = cuttingFor(look);
    for (const of of [look, { ...look, curves: null, edges: 40 }]) {
      at.show(<CurveFields cutting={cutting} look={of} pending onChange={() => {}} />);
      expect(at.host.querySelector("[role=status]")?.textContent).toBe("Largest deviation…Result…");
    }
  });
});
