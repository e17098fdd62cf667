// @vitest-environment happy-dom
import { act } from "react";
import { expect, it, vi } from "vitest";

vi.mock("../../../platform", () => ({
  platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {},
}));

import type { CalibrationRow } from "../../../generated/responses";
import { place } from "../../../shared/testing";
import { useCalibration } from "../../../state/calibration/calibration";
import { Measure } from "./Measure";

const at = place();

it("brings the newest column of readings into sight, also one that was just added", () => {
  const brought: (string | null)[] = [];
  vi.spyOn(Element.prototype, "scrollIntoView").mockImplementation(function (this: Element) {
    brought.push(this.textContent);
  });
  const row = { line: 2, row: 1, coupon: "60", what: "angle", unit: "deg", readings: [59, 58] };
  const sheet = { rows: [row as unknown as CalibrationRow], jobs: [] };
  useCalibration.setState({ sheet } as unknown as Parameters<typeof useCalibration.setState>[0]);
  at.show(<Measure />);
  expect(brought).toEqual(["Reading 2"]);
  const more = [...at.host.querySelectorAll("button")].find(({ textContent }) => textContent === "Column");
  act(() => more?.click());
  expect(brought).toEqual(["Reading 2", "Reading 3"]);
});
