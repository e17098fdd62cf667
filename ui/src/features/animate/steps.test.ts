import { describe, expect, it } from "vitest";
import type { DiagnosticReport, MadeResponse, PlayedWire } from "../../generated/responses";
import { namedSteps, phrase, shownSpeeds, spoken, stepRow, worst } from "./steps";

const pose: PlayedWire["steps"][number]["pose"] = { turn: [0, 0, 0, 1], bend_axis: [0, 0, 1], bend_deg: 0 };
const wire: PlayedWire = {
  bend_axis: [0, 0, 1],
  corners_mm: [
    [0, 0, 0],
    [35, 0, 0],
    [35, 35, 0],
  ],
  steps: [
    {
      designed: { feed_mm: 35, rotate_deg: 0.01, bend_deg: -90 },
      told: { feed_mm: 33.9, rotate_deg: 0, bend_deg: -112.42 },
      seconds: [0.3, 0, 14.9, 5],
      vertex: 1,
      edges: [0],
      place: { vertex: 1, pass: 1 },
      pause: "turn the part",
      pose,
      moments: [],
    },
    {
      designed: { feed_mm: 35, rotate_deg: 0, bend_deg: 0 },
      told: null,
      seconds: [0.3, 0, 0, 0],
      vertex: 2,
      edges: [1],
      place: null,
      pause: null,
      pose,
      moments: [],
    },
  ],
  stock_mm: 470,
  time_s: 20.5,
};

describe("stepRow", () => {
  it("shows what is designed and sent, a dash where nothing turns, and counts from 1", () => {
    expect(stepRow(wire, 0, "mm")).toEqual({
      number: 1,
      designed: ["35.0", "–", "−90.0"],
      told: ["33.9", "–", "−112.4"],
      vertex: 1,
      edges: { short: "0", all: "0" },
    });
    expect(stepRow(wire, 1, "mm")?.told).toBeNull();
    expect(stepRow(wire, 2, "mm")).toBeNull();
  });

  it("names the edges that it comes from, the first and how many more where they are many", () => {
    const along = (...edges: number[]) =>
      stepRow({ ...wire, steps: wire.steps.map((step) => ({ ...step, edges })) }, 0, "mm")?.edges;
    expect(along(12, 7)).toEqual({ short: "12, 7", all: "12, 7" });
    expect(along(12, 7, 9)).toEqual({ short: "12 +2", all: "12, 7, 9" });
    expect(along()).toEqual({ short: "–", all: "" });
  });

  it("shows inches with their digits: 35 mm is 1.378 in", () => {
    expect(stepRow(wire, 0, "inch")?.designed[0]).toBe("1.378");
  });
});

describe("spoken", () => {
  it("names what moves", () => {
    expect(spoken(wire, 0, (mm) => `${mm} mm`)).toBe(
      "step 1 of 2: feed 35 mm along edge 0, bend −90.0°; then pause: turn the part",
    );
  });
});

const error = (step: number | null, severity: DiagnosticReport["severity"] = "error"): DiagnosticReport => ({
  code: "edge_too_short",
  help: "",
  message: "",
  severity,
  step,
});

describe("namedSteps", () => {
  it("takes each error's step once", () => {
    expect(namedSteps([error(5), error(2), error(5), error(null), error(3, "warning")], 1)).toEqual([2, 5]);
  });

  it("leaves collisions out, which have marks of their own", () => {
    expect(namedSteps([{ ...error(5), code: "meets_stock" }], 1)).toEqual([]);
  });

  it("does not guess whose steps they are", () => {
    expect(namedSteps([error(5)], 2)).toEqual([]);
  });
});

describe("worst", () => {
  it("says how far the worst vertex is off", () => {
    const made: MadeResponse = {
      by_machine: true,
      notes: [],
      wires: [{ corners_mm: [], poses: [], wire_mm: [], deviations_mm: [0.01, 0.0762], worst_mm: 0.0762 }],
    };
    expect(worst(made, 0, "mm")).toBe("worst vertex 0.08 mm");
    expect(worst(made, 0, "inch")).toBe("worst vertex 0.0030 in");
    expect(worst(null, 0, "mm")).toBeNull();
  });
});

describe("phrase", () => {
  it("adds the wires up", () => {
    expect(phrase([{ time_s: 3130 }], 0)).toBe("52:10");
    expect(phrase([{ time_s: 60 }, { time_s: 61 }], 1)).toBe("2 wires · 2:01 · 1 without a program");
    expect(phrase([], 1)).toBe("no program: see Check");
    expect(phrase([], 0)).toBe("no steps");
  });
});

describe("shownSpeeds", () => {
  // The published machine: 110.2 mm/s, 131.3°/s, 15.1°/s.
  const rates = [110.2, 131.3, 15.1] as const;
  it("multiplies the machine's own speeds, in the unit that is shown", () => {
    expect(shownSpeeds(rates, { feed: 1, rotate: 1, bend: 4, all: 1 }, "mm")).toEqual({
      feed: "110.2 mm/s",
      rotate: "131.3°/s",
      bend: "60.4°/s",
    });
    expect(shownSpeeds(rates, { feed: 1, rotate: 1, bend: 4, all: 2 }, "inch")).toEqual({
      feed: "8.677 in/s",
      rotate: "262.6°/s",
      bend: "120.8°/s",
    });
  });

  it("says nothing of a machine that is not known", () => {
    expect(shownSpeeds(null, { feed: 1, rotate: 1, bend: 4, all: 1 }, "mm")).toEqual({});
  });
});
