import { describe, expect, it } from "vitest";
import type { DiagnosticReport, LiveCheck, WireFigures } from "../../generated/responses";
import { estimatesOf, figuresOf, fineOf, groupsOf, phraseOf, refusalOf, titleOf, valueText, whatOf } from "./texts";

const short = (edge: number, value: number): DiagnosticReport => ({
  code: "edge_too_short",
  severity: "error",
  edge,
  edges: [edge],
  value,
  limit: 25,
  limit_source: "the head needs room [wirebend-kit, limits.min_edge_mm]",
  limit_reason: "the head needs room",
  unit: "mm",
  message: `edge ${edge} is ${value} mm long`,
  help: "make it longer",
});
const odd: DiagnosticReport = {
  code: "no_euler_path",
  severity: "error",
  vertices: [4, 5],
  value: 22,
  limit: 2,
  message: "needs more than one wire (22 odd corners)",
  help: "run the wire along 11 edges twice",
};
const near: DiagnosticReport = {
  code: "bend_near_limit",
  severity: "warning",
  vertex: 17,
  value: -151.3,
  limit: -155,
  unit: "deg",
  message: "close",
  help: "leave it",
};
const wire: WireFigures = {
  bends: 7,
  cost: 1,
  stock_cost: 2,
  currency: "USD",
  length_mm: 100,
  mass_g: 1,
  sag: null,
  stock_mm: 120,
  time_s: 10,
  route: [0, 1],
};
const check = (diagnostics: DiagnosticReport[], wires: WireFigures[] = [wire]): LiveCheck => ({
  feasible: !diagnostics.some(({ severity }) => severity === "error"),
  diagnostics,
  wires,
  limits_unknown: null,
});

describe("the list of checks", () => {
  const all = check([odd, short(3, 19.4), short(8, 17.9), near]);
  const groups = groupsOf(all);

  it("has one line for what is of a kind", () => {
    expect(groups.map(titleOf)).toEqual([
      "Needs more than one wire (22 odd corners)",
      "2 edges too short",
      "Bend at vertex 17 close to the limit",
    ]);
  });

  it("says how many wires are too few for the odd corners", () => {
    expect(whatOf({ ...odd, value: 8, limit: 4 })).toBe("Needs more than 2 wires (8 odd corners)");
    expect(whatOf({ ...odd, value: 6, limit: 0 })).toBe("Cannot be a closed wire (6 odd corners)");
    expect(groupsOf(check([odd, odd])).map(titleOf)).toEqual(["2 parts with too many odd corners"]);
  });

  it("names the worst value, its limit and where that comes from", () => {
    expect(groups.map((group) => figuresOf(group, "mm"))).toEqual([
      "Run the wire along 11 edges twice",
      "least 17.9 mm, limit 25.0 mm \u00b7 the head needs room",
      "\u2212151.3°, limit \u2212155.0°",
    ]);
  });

  it("takes the smallest of what is close to a least, though it is above it", () => {
    const close = (edge: number, value: number): DiagnosticReport => ({
      ...short(edge, value),
      code: "edge_near_limit",
      severity: "warning",
    });
    const [group] = groupsOf(check([close(1, 26.1), close(2, 25.4), close(3, 26)]));
    expect(group && figuresOf(group, "mm")).toMatch(/^least 25\.4 mm/);
  });

  it("shows a value beyond a limit as another than the limit", () => {
    const small: DiagnosticReport = { ...short(1, 1.5), code: "bend_radius_small", severity: "warning" };
    const of = (value: number, limit: number, unit: "mm" | "inch") => {
      const [group] = groupsOf(check([{ ...small, value, limit }]));
      return group && figuresOf(group, unit);
    };
    expect(of(1.5, 1.503, "mm")).toMatch(/^1\.500 mm, limit 1\.503 mm/);
    expect(of(1.49, 1.5, "mm")).toMatch(/^1\.49 mm, limit 1\.50 mm/);
    expect(of(1.5, 4.5, "mm")).toMatch(/^1\.5 mm, limit 4\.5 mm/);
    expect(of(1.5, 1.503, "inch")).toMatch(/^0\.0591 in, limit 0\.0592 in/);
  });

  it("names what meets where, and how near, of a warning as of an error", () => {
    const meet = (severity: "error" | "warning", value: number): DiagnosticReport => ({
      code: "edges_meet",
      severity,
      edge: 2,
      edges: [2, 7],
      value,
      limit: 3,
      limit_source: "the diameter of the wire",
      unit: "mm",
      message: "edges 2 and 7 meet",
      help: "join them there",
    });
    expect(whatOf(meet("error", 0))).toBe("Edges 2 and 7 meet");
    expect(whatOf({ ...meet("error", 0), vertex: 4 })).toBe("Edges 2 and 7 meet at vertex 4");
    expect(whatOf({ ...meet("warning", 2), vertex: 4, vertices: [4, 9] })).toBe("Vertices 4 and 9 meet");
    const [group] = groupsOf(check([meet("warning", 2.5), meet("warning", 1.8)]));
    expect(group && titleOf(group)).toBe("2 places where the wire meets itself");
    expect(group && figuresOf(group, "mm")).toMatch(/^least 1\.8 mm, limit 3\.0 mm/);
  });

  it("says what a collision hits and how deep, and takes the deepest of several", () => {
    const hit = (step: number, value: number, more: Partial<DiagnosticReport> = {}): DiagnosticReport => ({
      ...short(1, value),
      code: "meets_machine",
      severity: "warning",
      body: "head",
      step,
      limit: 0,
      remedies: [{ remedy: "measure_body" }],
      ...more,
    });
    expect(whatOf(hit(2, 3.7))).toBe("The wire hits the head in step 3");
    const [one, several] = [[hit(2, 3.7)], [hit(2, 3.7), hit(4, 5.2), hit(6, 1)]].map((all) => groupsOf(check(all))[0]);
    expect(one && figuresOf(one, "mm")).toBe("3.7 mm deep; dimensions are estimates");
    expect(several && figuresOf(several, "mm")).toBe("up to 5.2 mm deep; dimensions are estimates");
    const [measured] = groupsOf(check([hit(2, 3.7, { severity: "error", remedies: [] })]));
    expect(measured && figuresOf(measured, "mm")).toBe("3.7 mm deep");
    expect(whatOf(hit(0, 3, { code: "meets_stock", body: null }))).toBe("The wire hits itself in step 1");
    // What only comes nearer than the clearance hits nothing.
    const [hits, near] = groupsOf(check([hit(2, 3.7), hit(2, -11), hit(4, -6, { body: "peg" })]));
    expect(hits && [titleOf(hits), figuresOf(hits, "mm")]).toEqual([
      "The wire hits the head in step 3",
      "3.7 mm deep; dimensions are estimates",
    ]);
    expect(near && [titleOf(near), figuresOf(near, "mm")]).toEqual([
      "The wire comes near 2 bodies of the machine",
      "within 6.0 mm; dimensions are estimates",
    ]);
    expect(whatOf(hit(0, -3, { code: "meets_stock", body: null }))).toBe("The wire comes near itself in step 1");
  });

  it("says that a strut buckles where its load is reached, as the message does, and else that it is near that", () => {
    const strut = (edges: number[], value: number): DiagnosticReport => ({
      code: "strut_near_buckling",
      severity: value >= 1 ? "error" : "warning",
      edge: edges[0] ?? null,
      edges,
      value,
      limit: 0.5,
      message: "",
      help: "",
    });
    expect(whatOf(strut([2], 0.63))).toBe("Edge 2 is near buckling");
    expect(whatOf(strut([2, 3], 0.63))).toBe("Edges 2, 3 are near buckling");
    expect(whatOf(strut([2], 1.2))).toBe("Edge 2 buckles");
    expect(whatOf(strut([2], 1))).toBe("Edge 2 buckles");
    // How far the others are is not known: the worst comes first.
    expect(whatOf(strut([2, 3, 5], 1.2))).toBe("Edge 2 buckles; 2 more are near buckling");
    const title = (value: number) => groupsOf(check([strut([2], value), strut([4], value)])).map(titleOf);
    expect([title(0.7), title(1.1)]).toEqual([["2 edges are near buckling"], ["2 edges buckle"]]);
  });

  it("says of how many bodies the dimensions are estimates", () => {
    expect(estimatesOf({ bodies: 6, estimates: 0 })).toBeNull();
    expect(estimatesOf({ bodies: 6, estimates: 5 })).toBe("5 of 6 bodies of the machine are estimates.");
    expect(estimatesOf({ bodies: 6, estimates: 6 })).toBe("All 6 bodies of the machine are estimates.");
    expect(estimatesOf({ bodies: 0, estimates: 0 })).toMatch(/no bodies/);
  });

  it("says what it does not know in the words that came", () => {
    expect(whatOf({ code: "stock_too_long", severity: "error", message: "the spool is empty", help: "" })).toBe(
      "The spool is empty",
    );
  });

  it("says values in the unit that is shown", () => {
    expect([
      valueText(25.4, "mm", "inch"),
      valueText(90, "deg", "inch"),
      valueText(3, null, "mm"),
      valueText(null, "mm", "mm"),
    ]).toEqual(["1.000 in", "90.0°", "3", null]);
  });

  it("counts each place in its phrase", () => {
    expect(phraseOf(all, true, false, "unchecked")).toEqual({ phrase: "3 to fix", tone: "error" });
    expect(phraseOf(check([near]), true, false, "unchecked")).toEqual({
      phrase: "1 to look at; no collision check",
      tone: "warning",
    });
    expect(phraseOf(check([near]), true, false, "checked").phrase).toBe("1 to look at");
    expect(phraseOf(check([]), true, false, "unchecked")).toEqual({
      phrase: "within limits; no collision check",
      tone: "fine",
    });
    expect(phraseOf(check([]), true, false, "checking").phrase).toBe("within limits; checking collisions");
    expect(phraseOf(check([]), true, false, "checked").phrase).toBe("within limits; no collision found");
    expect(phraseOf(null, false, false, "unchecked").phrase).toBe("no machine chosen");
    expect(phraseOf(check([]), true, true, "unchecked").phrase).toBe("nothing to check yet");
  });
});

describe("what is fine", () => {
  it("is only what was checked: without a route nothing of bends is said", () => {
    const through: DiagnosticReport = { code: "edges_meet", severity: "error", edges: [2, 7], message: "", help: "" };
    expect(fineOf(check([through]))).not.toContain("No wire through another");
    expect(fineOf(check([]))).toContain("No wire through another");
    const unrouted = { ...wire, length_mm: null, stock_mm: null, bends: null };
    expect(fineOf(check([odd], [unrouted]))).toEqual([]);
    expect(fineOf(check([], [{ ...wire, stock_mm: null }]))).toEqual(["One wire runs through every edge"]);
  });

  it("leaves out what is near a limit", () => {
    const fine = fineOf(check([near]));
    expect(fine).toContain("Rotation within the head's limits");
    expect(fine.some((text) => text.includes("bend"))).toBe(false);
    expect(fineOf(check([], [wire, wire]))).toContain("14 bends within reach");
  });
});

describe("refusalOf", () => {
  const of = (...diagnostics: DiagnosticReport[]) =>
    refusalOf({ feasible: false, diagnostics, wires: [], limits_unknown: null } as unknown as LiveCheck);
  const hit: DiagnosticReport = { ...short(1, 5), code: "meets_stock" };

  it("names collisions, and that going on all the same drives the wire into something", () => {
    expect(of(hit).sub).toContain("Check found 1 collision.");
    expect(of(hit).consequence).toMatch(/will hit the machine or itself: watch it/);
    expect(of(hit, short(2, 5)).sub).toContain("Check found 2 errors, 1 collision among them.");
  });

  it("says of limits what becomes of the wire, and does not count warnings", () => {
    const { sub, consequence } = of(short(1, 5), { ...hit, severity: "warning" });
    expect(sub).toContain("Check found 1 error.");
    expect(consequence).not.toContain("hit");
  });
});
