import { describe, expect, it } from "vitest";
import type { DiagnosticReport, LiveCheck, WireFigures } from "../../generated/responses";
import type { DesignState } from "../../state/design/design";
import { designState } from "../../state/testing";
import { checksOfFile, checksPhrase, figures, savedPhrase, workPhrase } from "./figures";

const wire = (given: Partial<WireFigures> = {}): WireFigures => ({
  bends: 176,
  cost: 23.5,
  stock_cost: 24.3,
  currency: "USD",
  length_mm: 11_821.4,
  mass_g: 226,
  sag: null,
  route: [],
  stock_mm: 12_221.4,
  time_s: 3130,
  ...given,
});

const check = (wires: WireFigures[], diagnostics: DiagnosticReport[] = [], feasible = true): LiveCheck => ({
  wires,
  diagnostics,
  feasible,
  limits_unknown: null,
});
const values = (all: ReturnType<typeof figures>) => all.map(({ value }) => value);

describe("figures", () => {
  it("shows one wire", () => {
    expect(values(figures(check([wire()]), 11_220, "mm"))).toEqual([
      "11\u202f821.4 mm",
      "12.22 m",
      "176",
      "52:10",
      "$24.30",
    ]);
    expect(figures(check([wire()]), 11_220, "mm").at(-1)?.title).toBe(
      "Price of the stock to load, with the unusable tail. Wire in the part: $23.50",
    );
  });

  it("adds wires up, and does not show a sum that is not one", () => {
    const all = figures(
      check([wire({ length_mm: 100, time_s: 60, currency: "EUR" }), wire({ length_mm: 50.5, time_s: null })]),
      150,
      "mm",
    );
    expect(values(all).slice(0, 1)).toEqual(["150.5 mm"]);
    expect(values(all).slice(3)).toEqual(["–", "–"]);
    expect(all[0]?.title).toBe("Designed length of all 2 wires, doubled edges counted twice");
  });

  it("has nothing to show before the first check", () => {
    expect(values(figures(null, 0, "mm"))).toEqual(["–", "–", "–", "–", "–"]);
  });
});

const state = (given: Partial<DesignState>): DesignState => designState({ file: "/there/bunny.wirebend", ...given });

describe("figures of a design without a route", () => {
  it("says how long its wire is at least", () => {
    const all = figures(
      check([wire({ length_mm: null, stock_mm: null, time_s: null, cost: null, stock_cost: null, bends: null })]),
      1218.24,
      "mm",
    );
    expect(values(all)).toEqual(["≥ 1\u202f218.2 mm", "–", "–", "–", "–"]);
    expect(values(figures(null, 25.4, "inch"))[0]).toBe("≥ 1.000 in");
  });
});

describe("savedPhrase", () => {
  it("says what a file has, and passes on that nothing is kept", () => {
    expect(savedPhrase(state({})).text).toBe("saved");
    expect(savedPhrase(state({ changed: true })).text).toBe("unsaved changes");
    expect(savedPhrase(state({ file: null })).text).toBe("not saved yet");
    const unkept = { code: "not-kept", message: "the disk is full", remedies: [{ remedy: "save-design" as const }] };
    expect(savedPhrase(state({ unkept })).warning).toBe("The disk is full. Save the design.");
  });
});

const found = (severity: DiagnosticReport["severity"]): DiagnosticReport => ({
  code: "edge_too_short",
  help: "",
  message: "",
  severity,
});

describe("checksPhrase", () => {
  it("counts what has to be fixed, then what is worth a look", () => {
    expect(checksPhrase(check([], [found("error"), found("warning"), found("error")], false), "checked")).toEqual({
      text: "2 to fix",
      tone: "error",
    });
    expect(checksPhrase(check([], [found("warning"), found("info")]), "checked")).toEqual({
      text: "1 warning",
      tone: "warning",
    });
    expect(checksPhrase(null, "unchecked")).toBeNull();
  });

  it.each([
    ["checked", "no collision found"],
    ["checking", "checking collisions"],
    ["unchecked", "collisions not checked"],
  ] as const)("says of a design that is fine whether collisions are %s", (known, text) => {
    expect(checksPhrase(check([], [found("info")]), known)).toEqual({ text, tone: "fine" });
  });

  it("does not call fine what is not feasible", () => {
    expect(checksPhrase(check([], [], false), "checked")?.tone).toBe("error");
  });
});

describe("checksOfFile", () => {
  const fine = { findings: [], notes: [], feasible: true };

  it("says that nothing is hit of a program alone: of a job that is looked for when it is armed", () => {
    expect(checksOfFile({ ...fine, kind: "program" })).toEqual({ text: "no collision found", tone: "fine" });
    expect(checksOfFile({ ...fine, kind: "job" })).toEqual({ text: "collisions not checked", tone: "fine" });
    expect(checksOfFile({ ...fine, kind: "moves" })).toBeNull();
  });

  it("says first what is wrong", () => {
    const note = { code: "collisions-not-searched", count: 9, message: "not searched", remedies: [] };
    expect(checksOfFile({ ...fine, kind: "program", notes: [note] })?.text).toBe("1 warning");
    expect(checksOfFile({ ...fine, kind: "job", feasible: false })?.tone).toBe("error");
  });
});

describe("workPhrase", () => {
  it("knows what it is called, else says the stage", () => {
    expect(workPhrase("made", "x")).toBe("Bending on the simulated machine");
    expect(workPhrase("other", "counting")).toBe("counting");
  });
});
