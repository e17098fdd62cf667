// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from "vitest";

vi.mock("../platform", () => ({
  platform: { ask: vi.fn(), stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {
    refusal = { code: "not-feasible" };
  },
}));

import type { Fix, LiveCheck, RunFileReport } from "../generated/responses";
import { platform, Refused } from "../platform";
import { ofDesign, useDesign } from "../state/design/design";
import { showFix, useFixes } from "../state/design/fixes/fixes";
import { select, useSelection } from "../state/design/selection";
import { useFiles } from "../state/files/files";
import { useFrame } from "../state/frame/frame";
import { useShape } from "../state/frame/shape";
import { useMachines } from "../state/machine/machines";
import type { WireRun } from "../state/machine/operator";
import { setWanted, useRow } from "../state/machine/row";
import { useRun } from "../state/machine/run";
import { usePrediction } from "../state/prediction/prediction";
import { useRunFile } from "../state/program/run_file";
import { useSequence } from "../state/sequence/sequence";
import { designState } from "../state/testing";
import { setConstructionShown, shownLines, useView } from "../state/window/view";
import { followDesign } from "./design";

let end = () => {};
beforeEach(() => {
  end = followDesign();
});
afterEach(() => end());

const check = { diagnostics: [], wires: [] } as unknown as LiveCheck;
const nothing = { moved: [], doubled: [], gone_edges: [], new_edges: [], detached: [] };

it("the preview of a fix goes away with the first checks of a drag", () => {
  useDesign.setState({
    vertices: new Map([0, 1].map((id) => [id, { id, at: [id * 10, 0, 0] as const, support: false }])),
    edges: new Map([[5, { id: 5, a: 0, b: 1 }]]),
    limits: { ...check },
  });
  showFix({ preview: { ...nothing, doubled: [5] } } as unknown as Fix);
  expect(useView.getState().preview?.edges).toHaveLength(1);
  // What a drag changes at first is what the checks say.
  useDesign.setState({ limits: { ...check } });
  expect(useFixes.getState().shown).toBeNull();
  expect(useView.getState().preview).toBeNull();
});

it("keeps nothing that was said, shown or wanted with the profiles before", async () => {
  vi.mocked(platform.ask).mockResolvedValue({ errors: ["new"] } as never);
  useDesign.setState({ refused: useDesign.getState().version });
  setWanted({ version: 1, file: null });
  useFrame.setState({ choices: { errors: ["old"] } as never, problem: "no modulus", toleranceProblem: "no force" });
  usePrediction.setState({ problem: "no errors" });
  useSequence.setState({ problem: "no head", shown: true });
  useShape.setState({ view: { kind: "loaded" } });
  useMachines.setState(({ changes }) => ({ changes: changes + 1 }));
  expect(useDesign.getState().refused).toBeNull();
  expect(useRow.getState().wanted).toBeNull();
  expect(useFrame.getState()).toMatchObject({ problem: null, toleranceProblem: null });
  expect(usePrediction.getState().problem).toBeNull();
  expect(useSequence.getState()).toMatchObject({ problem: null, shown: false });
  expect(useShape.getState().view).toBeNull();
  await vi.waitFor(() => expect(useFrame.getState().choices?.errors).toEqual(["new"]));
});

it.each(["program", "job", "moves"] as const)(
  "checks what is open to be run with the profiles as they are, but for a job, which has its own: %s",
  (kind) => {
    vi.mocked(platform.ask)
      .mockReset()
      .mockResolvedValue(null as never);
    useRunFile.setState({ file: { path: "/a.txt", kind } as RunFileReport });
    useMachines.setState(({ changes }) => ({ changes: changes + 1 }));
    const asked = vi.mocked(platform.ask).mock.calls.filter(([name]) => name === "check-run-file");
    expect(asked.length).toBe(kind === "job" ? 0 : 1);
  },
);

it("closes a program that cannot be checked with a changed profile, and keeps what is told where it can be", async () => {
  const file = { path: "/a.txt", kind: "program", name: "a.txt" } as RunFileReport;
  useRunFile.setState({ file });
  useRun.setState({ ended: { outcome: "made" } as WireRun });
  vi.mocked(platform.ask)
    .mockReset()
    .mockResolvedValue({ file: { ...file, feasible: false } } as never);
  useMachines.setState(({ changes }) => ({ changes: changes + 1 }));
  await vi.waitFor(() => expect(useRunFile.getState().file?.feasible).toBe(false));
  expect(useRun.getState().ended).not.toBeNull();
  vi.mocked(platform.ask).mockImplementation(async (name) => {
    if (name === "check-run-file") throw new Refused({ code: "format-of-another" } as never);
    return { file: null } as never;
  });
  useMachines.setState(({ changes }) => ({ changes: changes + 1 }));
  await vi.waitFor(() => expect(useRunFile.getState().file).toBeNull());
});

it("keeps no refusal that comes after a profile was changed", async () => {
  let refuse = (_: Error) => {};
  const asked = ofDesign(new Promise((_, reject) => (refuse = reject)));
  useMachines.setState(({ changes }) => ({ changes: changes + 1 }));
  refuse(new Refused({ code: "not-feasible" } as never));
  await expect(asked).rejects.toThrow();
  expect(useDesign.getState().refused).toBeNull();
});

it("says what became of the last wire beside no other design", () => {
  useRun.setState({ ended: { outcome: "made" } as WireRun });
  useFiles.setState({ busy: "b.wirebend" });
  expect(useRun.getState().ended).not.toBeNull();
  useFiles.setState(({ opened }) => ({ opened: opened + 1 }));
  expect(useRun.getState().ended).toBeNull();
});

it("keeps the construction lines selected that were, and none that are hidden; a new line shows all again", () => {
  const line = (mm: number) => [[0, 0, 0] as const, [mm, 0, 0] as const] as const;
  const have = (...all: readonly number[]) =>
    useDesign.setState({ state: designState({ construction_mm: all.map(line) as never }) });
  const selected = () => [...useSelection.getState().lines];
  have(1, 2, 3);
  select([], [], [1, 2]);
  have(2, 3);
  expect(selected()).toEqual([0, 1]);
  // Undone: it is there again, before them.
  have(1, 2, 3);
  expect(selected()).toEqual([1, 2]);
  setConstructionShown(false);
  expect([selected(), shownLines()]).toEqual([[], []]);
  have(1, 2);
  expect(shownLines()).toEqual([]);
  have(1, 2, 4);
  expect(shownLines()).toHaveLength(3);
});
