import { expect, it } from "vitest";
import type { RunEntry } from "../../../generated/responses";
import { madePhrase } from "./records";

const RUN: RunEntry = {
  id: "1",
  problem: null,
  name: "House",
  job_hash: null,
  wire: 0,
  piece: null,
  machine: "wirebend-kit",
  material: null,
  started: null,
  ended: null,
  outcome: "finished",
  made: 5,
  steps: 5,
  interruptions: 0,
  pauses: 0,
  worst_deviation_mm: 0.245,
};

it("says what became of a wire, as far as it is known", () => {
  expect(madePhrase(RUN, "mm")).toEqual({
    tone: "fine",
    what: "House",
    sub: "5 steps done · worst vertex 0.24 mm · wirebend-kit",
  });
  expect(madePhrase({ ...RUN, worst_deviation_mm: 25.4 }, "inch").sub).toContain("worst vertex 1.0000 in");
  expect(
    madePhrase({ ...RUN, wire: 2, outcome: "unfinished", made: 3, interruptions: 1, worst_deviation_mm: null }, "mm"),
  ).toEqual({
    tone: "warning",
    what: "House, wire 3",
    sub: "interrupted after step 3 of 5 · 1 interruption · wirebend-kit",
  });
  expect(madePhrase({ ...RUN, pauses: 2 }, "mm").sub).toContain("· 2 pauses ·");
  expect(madePhrase({ ...RUN, outcome: null, problem: "line 4 is cut" }, "mm")).toEqual({
    tone: "error",
    what: "House",
    sub: "line 4 is cut",
  });
});
