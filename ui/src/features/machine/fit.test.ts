import { describe, expect, it } from "vitest";
import type { MachineEntry, MaterialEntry } from "../../generated/responses";
import { known, misfit } from "./fit";

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
};

const machine: MachineEntry = {
  id: "kit",
  name: "WireBend-kit",
  shipped: true,
  file: "",
  driver: "kit",
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

describe("known", () => {
  it("says diameter, price and where springback comes from", () => {
    expect(known(material, "mm")).toBe("3.175 mm · $1.99 a metre · springback measured");
    expect(known({ ...material, diameter_mm: 3, price_per_mm: null, springback_measured: false }, "mm")).toBe("3.0 mm · price not known · springback estimated");
    expect(known(material, "inch")).toBe("0.125 in · $0.61 a foot · springback measured");
  });
});
