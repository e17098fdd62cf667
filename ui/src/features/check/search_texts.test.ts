import { expect, it } from "vitest";
import type { DiagnosticReport, UnfoundReport } from "../../generated/responses";
import { foundSoFar, obstacleOf, reachOf, unsearchedOf } from "./search_texts";

const unfound = (obstacle: string | null, clearance_mm: number) =>
  ({ vertex: 4, body: "nozzle", search: { obstacle, clearance_mm } }) as unknown as DiagnosticReport;

it("says that something would be hit only where nothing has to be stayed away from", () => {
  expect(obstacleOf(unfound("body", 0), "mm")).toBe("At vertex 4 the wire would hit the nozzle");
  expect(obstacleOf(unfound("body", 12), "mm")).toBe("At vertex 4 the wire would come within 12.0 mm of the nozzle");
  expect(obstacleOf(unfound("body", 0.04), "mm")).toBe("At vertex 4 the wire would come within 0.04 mm of the nozzle");
  expect(obstacleOf(unfound("stock", 0), "inch")).toBe(
    "At vertex 4 the wire would hit the wire that is still to be bent",
  );
  expect(obstacleOf(unfound("head-limit", 12), "mm")).toBe("At vertex 4 the head cannot turn far enough");
  expect(obstacleOf(unfound(null, 12), "mm")).toBeNull();
});

it("says what a search has found, and for which part of several", () => {
  const one = { part: 1, parts: 1 };
  expect(foundSoFar({ ...one, best: null }, "mm")).toBe("No program without a collision found so far.");
  const best = { wires: 1, doubled_mm: 0.01 };
  expect(foundSoFar({ ...one, best }, "mm")).toBe("Found so far: 1 wire without a collision.");
  expect(foundSoFar({ ...one, best: { wires: 2, doubled_mm: 24 } }, "mm")).toBe(
    "Found so far: 2 wires without a collision, 24.0 mm doubled.",
  );
  const second = { part: 2, parts: 3 };
  expect(foundSoFar({ ...second, best: null }, "mm")).toBe(
    "No program without a collision found for part 2 of 3 so far.",
  );
  expect(foundSoFar({ ...second, best }, "inch")).toBe("Found for part 2 of 3 so far: 1 wire without a collision.");
});

it("says that nothing was searched only where that is so, and which bends come first", () => {
  const search = { steps_checked: 0, passed: null, of: null, exhausted: false, ended: false } as UnfoundReport;
  const report = (given: Partial<DiagnosticReport>) => ({ vertex: null, search, ...given }) as DiagnosticReport;
  expect(unsearchedOf(report({ vertex: 3 }))).toEqual({
    why: "It was not searched: a bend that no order avoids comes first.",
    where: "The bend at vertex 3",
  });
  expect(unsearchedOf(report({ vertex: 3, vertices: [3, 8] }))).toEqual({
    why: "It was not searched: bends that no order avoids come first.",
    where: "The bends at vertices 3, 8",
  });
  expect(unsearchedOf(report({ vertex: 0, vertices: [0, 1, 2, 3, 4, 5, 6, 7] }))?.where).toMatch(/5 and 2 more$/);
  expect(unsearchedOf(report({ vertex: 3, search: { ...search, steps_checked: 20 } }))).toBeNull();
  expect(unsearchedOf(report({ vertex: 3, search: { ...search, passed: 0, of: 4 } }))).toBeNull();
  // A person has ended it at once: no bend is in its way.
  expect(unsearchedOf(report({}))).toBeNull();
  expect(reachOf({ ...search, ended: true })).toBe("It was ended before it checked a step.");
});
