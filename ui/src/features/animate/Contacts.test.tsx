// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { Collisions, ContactReport, RunFileReport } from "../../generated/responses";
import { place } from "../../shared/testing";
import { useCollisions } from "../../state/design/collisions";
import { useDesign } from "../../state/design/design";
import { forgetProgram, makeProgram } from "../../state/program/program";
import { useRunFile } from "../../state/program/run_file";
import { program, view } from "../../state/program/testing";
import { designState } from "../../state/testing";
import { Contacts } from "./Contacts";

const at = place();
const none: Collisions = { checked: true, stopped: false, bodies: 6, estimates: 0, contacts: [] };
const contact = { wire: 0, step: 0, at: 0.5, leg: 0, body: 2, depth_mm: 0.3, finding: { code: "meets_machine" } };
const some: Collisions = { ...none, contacts: [contact as ContactReport] };
const text = () => at.host.textContent ?? "";

beforeEach(async () => {
  platform.ask.mockReset().mockImplementation(async (ask: string) => (ask === "program" ? program : view));
  forgetProgram();
  useRunFile.setState({ file: null });
  useCollisions.setState({ stands: "done", long: false, problem: null });
  const collisions = { found: none, version: 3, profiles: 0, dragged: false };
  useDesign.setState({
    state: designState({ machine: "kit" }),
    vertices: new Map(),
    edges: new Map(),
    version: 3,
    collisions,
  });
  await makeProgram();
  at.show(<Contacts />);
});

it("says that nothing is hit of the program as it is", () => {
  expect(text()).toContain("No collision found.");
});

it.each([
  ["what was found before a change", () => useDesign.setState({ version: 4 }), "Checking for collisions…"],
  [
    "where vertices are dragged to",
    () => useDesign.setState({ collisions: { found: none, version: 3, profiles: 0, dragged: true } }),
    "Checking for collisions…",
  ],
  [
    "another profile",
    () => useDesign.setState({ collisions: { found: none, version: 3, profiles: 1, dragged: false } }),
    "Checking for collisions…",
  ],
  ["a check that is under way", () => useCollisions.setState({ stands: "running" }), "Checking for collisions…"],
  ["a program of the design before", () => useDesign.setState({ vertices: new Map() }), "Waiting for the program…"],
  [
    "collisions of a design that has another program",
    () =>
      useDesign.setState({
        vertices: new Map(),
        version: 4,
        collisions: { found: some, version: 4, profiles: 0, dragged: false },
      }),
    "Waiting for the program…",
  ],
  [
    "a check that was stopped",
    () => {
      useDesign.setState({ collisions: null });
      useCollisions.setState({ stands: "stopped" });
    },
    "Collisions are not checked.",
  ],
])("does not say so for %s", (_, change, expected) => {
  act(change);
  expect(text()).toContain(expected);
  expect(text()).not.toContain("No collision");
});

it("says nothing of a file by what the design behind it has", () => {
  const show = (kind: RunFileReport["kind"]) =>
    act(() => useRunFile.setState({ file: { kind, machine: "kit" } as RunFileReport }));
  show("job");
  expect(text()).toBe("Run shows what the checks say of this file.");
  show("moves");
  expect(text()).toBe("Recorded moves are not checked for collisions.");
});
