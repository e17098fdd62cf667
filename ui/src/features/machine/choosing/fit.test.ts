import { describe, expect, it } from "vitest";
import type { MachineEntry, MaterialEntry } from "../../../generated/responses";
import { besideBend, figures, leastLength, misfit } from "./fit";

const material: MaterialEntry = {
  id: "aluminium",
  name: "Aluminium",
  shipped: true,
  file: "",
  diameter_mm: 3.175,
  density_kg_per_m3: 2700,
  price_per_mm: 0.00199,
  currency: "USD",
  springback_measured: true,
  springback_deg: [4.9, 8.6],
  k_factor: 0.3,
  yield_strength_mpa: 117,
};

const machine: MachineEntry = {
  id: "kit",
  name: "WireBend-kit",
  shipped: true,
  file: "",
  driver: "kit",
  has_peg: true,
  noise: null,
  formats: [],
  native: null,
  default_material: "aluminium",
  bend_deg: [-155, 155],
  min_edge_mm: 20.4,
  diameter_mm: [2.8, 3.2],
};

describe("misfit", () => {
  it("names the limit that it breaks", () => {
    expect(misfit(material, machine, "mm")).toBeNull();
    expect(misfit({ ...material, diameter_mm: 1 }, machine, "mm")).toBe("thinner than WireBend-kit takes (2.8 mm)");
    expect(misfit({ ...material, diameter_mm: 4 }, machine, "inch")).toBe("thicker than WireBend-kit takes (0.126 in)");
    expect(misfit(material, null, "mm")).toBeNull();
  });
});

describe("figures", () => {
  const said = (given: Partial<MaterialEntry>, unit: "mm" | "inch" = "mm") =>
    figures({ ...material, ...given }, unit).map((figure) => figure.join(" "));

  it("say what a wire is bent and paid with, and where its springback comes from", () => {
    expect(said({})).toEqual([
      "diameter 3.175 mm",
      "price $1.99 a metre",
      "k factor 0.30",
      "yield 117 MPa",
      "springback 4.9° to 8.6°, measured",
    ]);
    expect(said({}, "inch").slice(0, 2)).toEqual(["diameter 0.125 in", "price $0.61 a foot"]);
  });

  it("say what is not known, and once what is the same for every bend", () => {
    expect(said({ diameter_mm: 3, price_per_mm: null, springback_measured: false, springback_deg: [5, 5] })).toEqual([
      "diameter 3.0 mm",
      "price not known",
      "k factor 0.30",
      "yield 117 MPa",
      "springback 5.0°, estimated",
    ]);
  });
});

it("names what an edge beside a bend needs, rounded up so that it does, where that is more", () => {
  const of = (between: number | null) => besideBend({ min_edge_mm: 20.4, min_edge_between_mm: between }, "mm");
  expect(of(24.92)).toBe(" (25.0 mm beside a bend of 90°)");
  expect(of(20.4)).toBe("");
  expect(of(null)).toBe("");
  expect(besideBend(null, "mm")).toBe("");
});

it("rounds the least length once, in the unit that is shown, and never below it", () => {
  // 24.92 mm are 0.98110 in; by way of 25.0 mm it would be 0.984 in.
  expect(besideBend({ min_edge_mm: 20.4, min_edge_between_mm: 24.92 }, "inch")).toBe(
    " (0.982 in beside a bend of 90°)",
  );
  expect([leastLength(20.41, "mm"), leastLength(20.4, "mm")]).toEqual(["20.5 mm", "20.4 mm"]);
  expect([leastLength(25.41, "inch"), leastLength(25.4, "inch")]).toEqual(["1.001 in", "1.000 in"]);
});
