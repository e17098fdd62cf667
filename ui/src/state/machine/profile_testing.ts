/** What tests of the profile editor need. */

import type { ProfileView, ValueReport } from "../../generated/responses";

const valueReport = (key: string, value: unknown, given: Partial<ValueReport> = {}): ValueReport => ({
  key,
  value: value as ValueReport["value"],
  set_by: "wirebend-kit",
  file: "machine-profiles/machines/wirebend-kit.json",
  line: 1,
  source: "SCF25",
  measured: false,
  instead_of: null as unknown as ValueReport["instead_of"],
  ...given,
});

/** A copy of the kit in which the pin was measured. */
export const profileView = (given: Partial<ProfileView> = {}): ProfileView => ({
  file: "/own/machines/mine.json",
  has_last_change: true,
  shipped: false,
  shapes: [],
  profile: {
    kind: "machine",
    id: "mine",
    name: "Mine",
    abstract: false,
    chain: [
      { id: "mine", file: "/own/machines/mine.json", shipped: false },
      { id: "wirebend-kit", file: "machine-profiles/machines/wirebend-kit.json", shipped: true },
    ],
    values: [
      valueReport("bend.method", "peg", { source: null as unknown as string }),
      valueReport("bend.orbit_radius_mm", 20.4),
      valueReport("bend.pin_radius_mm", 1.5875, {
        set_by: "mine",
        source: "caliper",
        measured: true,
        instead_of: { value: 1.5 as unknown as ValueReport["value"], set_by: "wirebend-kit" },
      }),
    ],
  },
  head: {
    wire_mm: 3,
    pin_radius_mm: 1.5875,
    peg: { radius_mm: 3.175, orbit_radius_mm: 20.4, orbit_offset_mm: 12, at_mm: [7.7, 19.9], axis_deg: 102.24 },
  },
  ...given,
});
