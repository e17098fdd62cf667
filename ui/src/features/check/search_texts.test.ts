import { expect, it } from "vitest";
import type { DiagnosticReport } from "../../generated/responses";
import { bestSoFar, obstacleOf } from "./search_texts";

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

it("says what a search would end with now", () => {
  expect(bestSoFar(null, "mm")).toBe("No program without a collision found so far.");
  expect(bestSoFar({ wires: 1, doubled_mm: 0 }, "mm")).toBe("Found so far: 1 wire without a collision.");
  expect(bestSoFar({ wires: 2, doubled_mm: 24 }, "mm")).toBe(
    "Found so far: 2 wires without a collision, 24.0 mm doubled.",
  );
});
