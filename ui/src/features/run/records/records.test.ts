import { expect, it } from "vitest";
import type { RunEntry } from "../../../generated/responses";
import { machineState } from "../../../state/testing";
import { bentNow, madePhrase } from "./records";

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

it("numbers the first wire, too, of a job of which another one was begun", () => {
  const job = (hash: string | null, wire: number) => ({ ...RUN, job_hash: hash, wire });
  const runs = [job("a", 1), job("a", 0), job("b", 0), job(null, 0)];
  expect(runs.map((run) => madePhrase(run, "mm", null, runs).what)).toEqual([
    "House, wire 2",
    "House, wire 1",
    "House",
    "House",
  ]);
});

it("tells the wire that the machine is bending from those that were interrupted, and with the machine's own step", () => {
  const open: RunEntry = { ...RUN, job_hash: "a", outcome: "unfinished", made: 0, worst_deviation_mm: null };
  const older: RunEntry = { ...open, id: "0" };
  const elsewhere: RunEntry = { ...open, id: "2", machine: "pensa" };
  const runs = [elsewhere, open, older];
  const wire = {
    job_hash: "a",
    name: "House",
    wire: 0,
    piece: null,
    made: 2,
    of: 5,
    sent: 3,
    in_step: 0,
    done_by: "machine" as const,
    elapsed_s: 4,
    remaining_s: 6,
    stock_left_mm: null,
  };
  const making = { ...machineState("making"), wire };
  expect(bentNow(runs, making)).toBe(open);
  expect(madePhrase(open, "mm", making)).toEqual({
    tone: "info",
    what: "House",
    sub: "being bent: 2 of 5 steps done · wirebend-kit",
  });
  const held = { ...machineState("holding"), wire: { ...wire, done_by: "clock" as const } };
  expect(madePhrase(open, "mm", held).sub).toContain("paused: 2 of 5 steps by the clock");
  // Neither another piece or wire, nor one that the machine has let go of.
  expect(
    bentNow(
      [
        { ...open, piece: { number: 1, of: 2 } },
        { ...open, wire: 1 },
      ],
      making,
    ),
  ).toBeNull();
  expect(bentNow(runs, { ...machineState("stopped"), wire })).toBeNull();
  expect(bentNow(runs, null)).toBeNull();
});
