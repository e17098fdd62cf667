import { expect, it } from "vitest";
import type { RunFileReport } from "../../../generated/responses";
import { findingsOf, HOW } from "./phrases";

type Finding = RunFileReport["findings"][number];

const file = (given: Partial<RunFileReport>): RunFileReport => ({
  name: "two.txt",
  path: null,
  kind: "program",
  machine: "kit",
  material: "al",
  job_hash: "1",
  wires: [],
  moves: 0,
  feasible: true,
  findings: [],
  notes: [],
  ...given,
});
const finding = (severity: Finding["severity"], message: string) =>
  ({ severity, message, limit_source: null }) as unknown as Finding;

it("says of a program that nothing is compensated, and that it is within the limits", () => {
  expect(HOW.program.sub).toContain("Nothing of it is compensated");
  expect(findingsOf(file({}))).toEqual([{ tone: "fine", what: "Within the machine's limits", sub: null }]);
});

it("lists what the machine cannot make before anything else, and how much more there is", () => {
  const findings = ["a", "b", "c", "d"].map((message) => finding("error", message));
  const said = findingsOf(file({ feasible: false, findings: [...findings, finding("info", "e")] }));
  expect(said.map(({ what }) => what)).toEqual(["A", "B", "C", "And 1 more"]);
});

it("says first of a program that it was not searched to its end, and not that it is within the limits", () => {
  const note = { code: "collisions-not-searched", count: 9, message: "not searched", remedies: [] };
  const warned = ["a", "b", "c"].map((message) => finding("warning", message));
  const said = findingsOf(file({ findings: warned, notes: [note as RunFileReport["notes"][number]] }));
  expect(said.map(({ what }) => what)).toEqual(["Not searched", "A", "B", "And 1 more"]);
});

it("does not hold recorded moves against limits before they run", () => {
  expect(findingsOf(file({ kind: "moves", findings: [finding("error", "a")] }))).toEqual([]);
});
