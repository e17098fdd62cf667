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
import { preview, useExports } from "./exports";

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
