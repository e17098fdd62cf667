import { describe, expect, it } from "vitest";
import type { DiagnosticReport, LiveCheck, WireFigures } from "../../generated/responses";
import { labelsOf, marksOf, placesOf } from "./marks";

const report = (
  code: DiagnosticReport["code"],
  severity: DiagnosticReport["severity"],
  rest: Partial<DiagnosticReport> = {},
): DiagnosticReport => ({ code, severity, message: code, help: "", ...rest });
const figures = {
  bends: 1,
  cost: 1,
  stock_cost: 2,
  currency: "USD",
  length_mm: 1,
  mass_g: 1,
  sag: null,
  stock_mm: 1,
  time_s: 1,
};
const check = (diagnostics: DiagnosticReport[], route: number[] = []): LiveCheck => ({
  feasible: false,
  diagnostics,
  wires: [{ ...figures, route }],
  limits_unknown: null,
});

describe("marks", () => {
  it("are none before anything was checked", () => {
    expect(marksOf(null)).toEqual({
      vertices: new Map(),
      edges: new Map(),
      odd: new Set(),
      doubled: new Set(),
      colours: new Map(),
      start: null,
      checked: false,
    });
  });

  it("mark a short edge, not the vertex at the bend of its step", () => {
    const marks = marksOf(
      check([report("edge_too_short", "error", { vertex: 4, vertices: [4], edge: 7, edges: [7, 8] })]),
    );
    expect([...marks.edges]).toEqual([
      [7, "error"],
      [8, "error"],
    ]);
    expect(marks.vertices.size).toBe(0);
  });

  it("mark the vertex of a sharp bend, not the edge that leads there", () => {
    const marks = marksOf(check([report("bend_too_sharp", "error", { vertex: 4, edge: 7, edges: [7] })]));
    expect([...marks.vertices]).toEqual([[4, "error"]]);
    expect(marks.edges.size).toBe(0);
  });

  it("keep the worst that is said of a place, whatever comes last", () => {
    const marks = marksOf(
      check([
        report("bend_too_sharp", "error", { vertex: 1 }),
        report("bend_near_limit", "warning", { vertex: 1 }),
        report("bend_near_limit", "warning", { vertex: 2 }),
      ]),
    );
    expect([...marks.vertices]).toEqual([
      [1, "error"],
      [2, "warning"],
    ]);
  });

  it("tell odd vertices and doubled edges apart; a note marks nothing as wrong", () => {
    const marks = marksOf(
      check([
        report("no_euler_path", "error", { vertex: 4, vertices: [4, 5] }),
        report("doubled_edge", "info", { edge: 3 }),
        report("several_wires", "info", { vertices: [9] }),
      ]),
    );
    expect([...marks.odd]).toEqual([4, 5]);
    expect([...marks.doubled]).toEqual([3]);
    expect(marks.vertices.has(9)).toBe(false);
    expect(marks.edges.size).toBe(0);
  });

  it("call green only what went through all of the checks: without a route no bend was looked at", () => {
    const wire: WireFigures = { ...figures, route: [] };
    const of = (...wires: Partial<WireFigures>[]) =>
      marksOf({
        feasible: false,
        diagnostics: [],
        wires: wires.map((one) => ({ ...wire, ...one })),
        limits_unknown: null,
      }).checked;
    expect(of({})).toBe(true);
    expect(of({}, { stock_mm: null })).toBe(false);
    expect(of()).toBe(false);
  });

  it("show where the wire starts and which way", () => {
    expect(marksOf(check([], [5, 2, 3])).start).toEqual({ vertex: 5, towards: 2 });
    expect(marksOf(check([], [5])).start).toBeNull();
  });

  it("fall back on whatever a diagnostic names", () => {
    expect(placesOf(report("arcs_overlap", "error", { vertex: 3 }))).toEqual({ vertices: [3], edges: [] });
    expect(placesOf(report("something_new" as DiagnosticReport["code"], "error", { vertex: 3, edge: 4 }))).toEqual({
      vertices: [3],
      edges: [4],
    });
  });
});

describe("labels", () => {
  const design = {
    vertices: new Map([
      [0, { id: 0, at: [0, 0, 0] as const, support: false }],
      [1, { id: 1, at: [10, 20, 30] as const, support: false }],
    ]),
    edges: new Map([[7, { id: 7, a: 0, b: 1 }]]),
  };
  it("stand in the middle of an edge, at a vertex, and nowhere without a place or a figure", () => {
    const reports = [
      report("edge_too_short", "error", { edge: 7, value: 17.9 }),
      report("bend_too_sharp", "warning", { vertex: 1, value: 151 }),
      report("stock_too_long", "error", { value: 5 }),
      report("fold_back", "error", { vertex: 0 }),
    ];
    const labels = labelsOf(check(reports), design, ({ value }) => (typeof value === "number" ? String(value) : null));
    expect(labels).toEqual([
      { at: [5, 10, 15], text: "17.9", verdict: "error" },
      { at: [10, 20, 30], text: "151", verdict: "warning" },
    ]);
  });
});
