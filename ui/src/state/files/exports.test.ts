// @vitest-environment happy-dom
import { expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
class Refused extends Error {
  constructor(readonly refusal: { code: string; kind: string; message: string }) {
    super(refusal.message);
  }
}
vi.mock("../../platform", () => ({
  platform,
  get Refused() {
    return Refused;
  },
}));

import type { FormatEntry } from "../../generated/responses";
import { asSet, preview, settingsOf, useExports } from "./exports";

const format = { id: "gcode", name: "G-code", extension: "gcode", settings: {} } as unknown as FormatEntry;

it.each([
  ["not-feasible", true],
  ["stage-not-reached", false],
])("of a refusal for %s, that a person may want it anyway is %s", async (code, errors) => {
  useExports.setState({ formats: [format], chosen: null });
  platform.ask.mockRejectedValue(new Refused({ code, kind: "not-feasible", message: "no" }));
  await preview();
  expect(useExports.getState().preview?.refused).toEqual({ message: "no", errors });
});

const properties = { paper: {}, units: {} };
const sheet = {
  id: "job-sheet",
  driver: null,
  settings: {},
  settings_schema: { properties },
} as unknown as FormatEntry;

it("writes what a person reads in the unit of the window, unless another is set", () => {
  const none = new Map();
  expect(settingsOf(sheet, none, "inch")).toEqual({ units: "in" });
  expect(settingsOf(sheet, none, "mm")).toEqual({ units: "mm" });
  expect(settingsOf(sheet, new Map([["job-sheet", { units: "mm" }]]), "inch")).toEqual({ units: "mm" });
  // A driver's unit is that of its machine.
  expect(settingsOf({ ...sheet, driver: "tables" }, none, "inch")).toEqual({});
  expect(settingsOf({ ...sheet, settings_schema: null } as never, none, "inch")).toEqual({});
});

it("goes on following the window when another setting is changed", () => {
  const changed = asSet(sheet, { ...settingsOf(sheet, new Map(), "inch"), paper: "letter" }, "inch");
  expect(changed).toEqual({ paper: "letter" });
  expect(settingsOf(sheet, new Map([["job-sheet", changed]]), "mm")).toEqual({ paper: "letter", units: "mm" });
  expect(asSet(sheet, { units: "mm", paper: "a4" }, "inch")).toEqual({ units: "mm", paper: "a4" });
});
