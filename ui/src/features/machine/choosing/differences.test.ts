import { describe, expect, it } from "vitest";
import type { Findings, MachineSide, OtherSide, WireDiagnostic } from "../../../generated/responses";
import { differences, figures } from "./differences";

const side: MachineSide = {
  bends: 176,
  cost: 23.5,
  currency: "USD",
  errors: 4,
  feasible: false,
  feeds: 177,
  machine: "wirebend-kit",
  mass_g: 225,
  material: "aluminium-6061-t6-3mm",
  name: "WireBend-kit",
  stock_mm: 12_220,
  stock_cost: 24.44,
  time_s: 3130,
  warnings: 0,
  collisions: null,
};

const diagnostic = (code: WireDiagnostic["code"]): WireDiagnostic => ({
  code,
  help: "",
  message: `${code} here`,
  severity: "error",
  wire: 0,
});
const findings = (...codes: WireDiagnostic["code"][]): Findings => ({
  diagnostics: codes.map(diagnostic),
  edges: [],
  steps: [],
  vertices: [],
});

const other = (given: Partial<OtherSide>): OtherSide => ({
  ...side,
  machine: "pensa",
  fits: true,
  own_wire: null,
  change: { bends: 0, cost: 0, mass_g: 0, stock_cost: 0, stock_mm: 0, time_s: 0 },
  newly_warned: findings(),
  newly_feasible: findings(),
  newly_infeasible: findings(),
  ...given,
});

describe("differences", () => {
  it("puts the same kind together, what gets better first", () => {
    const to = other({
      newly_feasible: findings(
        "edge_too_short",
        "edge_too_short",
        "bend_too_sharp",
        "edge_too_short",
        "edge_too_short",
      ),
      newly_infeasible: findings("rotation_out_of_range"),
    });
    expect(differences(side, to)).toEqual([
      { tone: "fine", what: "4 short edges become feasible", sub: null },
      { tone: "fine", what: "1 sharp bend becomes feasible", sub: null },
      { tone: "error", what: "1 rotation out of range becomes infeasible", sub: "rotation_out_of_range here" },
    ]);
  });

  it("says first whether it is within the limits at all, where that changes", () => {
    const to = other({ feasible: true, errors: 0, newly_feasible: findings("edge_too_short") });
    expect(differences(side, to)[0]).toEqual({
      tone: "fine",
      what: "It is within the machine's limits; collisions not checked",
      sub: null,
    });
    const back = differences({ ...side, feasible: true }, other({ newly_infeasible: findings("edge_too_short") }));
    expect(back[0]?.tone).toBe("error");
  });

  it("does not count what is true of the whole", () => {
    expect(differences(side, other({ newly_infeasible: findings("wire_does_not_fit") }))[0]?.what).toBe(
      "The wire does not fit",
    );
  });

  it("says that nothing changes", () => {
    expect(differences(side, other({}))).toEqual([{ tone: "warning", what: "The same 4 errors on both", sub: null }]);
    expect(differences({ ...side, feasible: true }, other({ feasible: true }))).toEqual([
      { tone: "fine", what: "Within the limits of both; collisions there not checked", sub: null },
    ]);
  });

  it("names a warning that is new on the other machine", () => {
    const to = other({ feasible: true, newly_warned: findings("bend_radius_small") });
    expect(differences({ ...side, feasible: true }, to)).toEqual([
      { tone: "fine", what: "Within the limits of both; collisions there not checked", sub: null },
      { tone: "warning", what: "A new warning", sub: "bend_radius_small here" },
    ]);
  });

  it("names a kind that it does not know by its code", () => {
    expect(
      differences(side, other({ newly_feasible: findings("peg_hits_wire" as WireDiagnostic["code"]) }))[0]?.what,
    ).toBe("1 peg hits wire becomes feasible");
  });
});

describe("figures", () => {
  it("shows before and after, once where they look the same, and says what is not known any more", () => {
    const to = other({ time_s: 2285, stock_mm: 12_220.2, bends: null, stock_cost: 12.22, currency: "EUR" });
    expect(figures(side, to, "mm")).toEqual([
      ["Time", "52:10 → 38:05"],
      ["Stock", "12.22 m"],
      ["Bends", `${side.bends} → not known`],
      ["Cost", "€12.22"],
    ]);
    const unknown = other({ bends: null, stock_cost: null, currency: null });
    expect(figures({ ...side, bends: null }, unknown, "mm").map(([name]) => name)).toEqual(["Time", "Stock", "Cost"]);
    expect(figures(side, unknown, "mm").at(-1)).toEqual(["Cost", "$24.44 → not known"]);
  });

  it("has the cost of the stock, and not that of the wire in the part", () => {
    const from = { ...side, stock_mm: 858.1, cost: 0.91, stock_cost: 1.708 };
    const to = other({ stock_mm: 669, cost: 0.93, stock_cost: 1.331 });
    expect(figures(from, to, "mm").slice(1)).toEqual([
      ["Stock", "858.1 mm → 669.0 mm"],
      ["Bends", "176"],
      ["Cost", "$1.71 → $1.33"],
    ]);
  });
});
