import { beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
vi.mock("../../platform", () => ({
  platform: { ask },
  Refused: class Refused extends Error {
    readonly refusal: { code: string };
    constructor(code: string) {
      super(code);
      this.refusal = { code };
    }
  },
}));

import { Refused } from "../../platform";
import { useDesign } from "../design/design";
import { designState } from "../testing";
import {
  closeProfile,
  enterSource,
  importedPhrase,
  importProfile,
  measuredToday,
  openProfile,
  setValue,
  takeBack,
  typeDimension,
  useProfile,
} from "./profile";
import { profileView } from "./profile_testing";

beforeEach(() => {
  ask.mockReset();
  ask.mockImplementation(async (name: string) =>
    name.endsWith("profile") || name === "profile-view"
      ? profileView()
      : { machines: [], materials: [], diagnostics: [] },
  );
  closeProfile();
  useDesign.setState({ state: designState({ machine: "mine", material: "steel-1mm" }) });
});

const asked = (name: string) => ask.mock.calls.filter(([asked]) => asked === name).map(([, request]) => request);

it("names the day of a measurement as people write it down", () => {
  expect(measuredToday(new Date(2026, 0, 5))).toBe("measured by me on 2026-01-05");
});

it("sets a value with the source that was entered, and shows the head with the wire of the design", async () => {
  await openProfile("machine", "mine");
  expect(asked("profile-view")).toEqual([{ kind: "machine", id: "mine", material: "steel-1mm" }]);
  enterSource({ text: "drawing of the maker", measured: false });
  expect(await setValue("bend.orbit_radius_mm", 21)).toBe(true);
  expect(asked("set-profile")).toEqual([
    {
      kind: "machine",
      id: "mine",
      values: [{ key: "bend.orbit_radius_mm", value: 21 }],
      source: "drawing of the maker",
      measured: false,
      material: "steel-1mm",
    },
  ]);
});

it("writes one value after the other: each is put into the file that the one before has left", async () => {
  await openProfile("machine", "mine");
  const answers: (() => void)[] = [];
  ask.mockImplementation(() => new Promise((answer) => answers.push(() => answer(profileView()))));
  const both = [setValue("limits.tail_mm", 1), setValue("limits.tail_mm", 2)];
  await vi.waitFor(() => expect(asked("set-profile")).toHaveLength(1));
  answers[0]?.();
  await vi.waitFor(() => expect(asked("set-profile")).toHaveLength(2));
  answers.at(-1)?.();
  for (const answer of answers) answer();
  await Promise.all(both);
});

it("keeps why a value was refused with the value, until the next is set", async () => {
  await openProfile("machine", "mine");
  ask.mockRejectedValueOnce(new Error("limits.tail_mm is -1, expected 0 or more"));
  expect(await setValue("limits.tail_mm", -1)).toBe(false);
  expect(useProfile.getState().refused).toEqual({
    key: "limits.tail_mm",
    message: "limits.tail_mm is -1, expected 0 or more",
  });
  await takeBack("bend.pin_radius_mm");
  expect(asked("revert-profile")).toEqual([
    { kind: "machine", id: "mine", keys: ["bend.pin_radius_mm"], material: "steel-1mm" },
  ]);
  expect(useProfile.getState().refused).toBeNull();
});

it("says whether another id would help a file that is not taken in", async () => {
  ask.mockRejectedValueOnce(new (Refused as unknown as new (code: string) => Error)("id-taken"));
  expect(await importProfile("/a.json", null)).toEqual({ problem: "id-taken", taken: true });
  ask.mockResolvedValueOnce({
    kind: "machine",
    id: "b",
    name: "B (2)",
    own_name: "B",
    known: false,
    with: [{ kind: "material", id: "spool-2" }],
  });
  const taken = await importProfile("/a.json", "b");
  expect(taken).toEqual({ name: "B (2)", ownName: "B", known: false, others: ["spool-2"] });
});

it("tells apart what was taken in, under another name too, from what was there already", () => {
  const taken = { name: "B (2)", ownName: "B", known: false, others: ["spool-2"] };
  expect(importedPhrase(taken)).toBe("“B (2)” is one of your profiles now, with spool-2. Another one is called “B”.");
  const known = { name: "B", ownName: null, known: true, others: ["spool"] };
  expect(importedPhrase(known)).toBe("The profile is here already: it is that of “B”.");
});

const headOf = (orbit: number) => ({
  wire_mm: 3,
  pin_radius_mm: 1.5,
  peg: { radius_mm: 3, orbit_radius_mm: orbit, orbit_offset_mm: 12, at_mm: null, axis_deg: null },
});

it("draws the head with what is typed: the last of it, though an earlier answer comes later", async () => {
  await openProfile("machine", "mine");
  const answers: ((orbit: number) => void)[] = [];
  ask.mockImplementation((name: string) =>
    name === "draw-head"
      ? new Promise((answer) => answers.push((orbit) => answer(headOf(orbit))))
      : Promise.resolve({}),
  );
  const both = [typeDimension("bend.orbit_radius_mm", 2), typeDimension("bend.orbit_radius_mm", 21)];
  answers[1]?.(21);
  answers[0]?.(2);
  await Promise.all(both);
  expect(useProfile.getState().typedHead?.peg?.orbit_radius_mm).toBe(21);
  expect(asked("draw-head")[1]).toEqual({
    id: "mine",
    values: [{ key: "bend.orbit_radius_mm", value: 21 }],
    material: "steel-1mm",
  });
  // What cannot be leaves it as it is; what is given up shows what is written.
  ask.mockRejectedValueOnce(new Error("expected above 0"));
  await typeDimension("bend.orbit_radius_mm", -3);
  expect(useProfile.getState().typedHead?.peg?.orbit_radius_mm).toBe(21);
  await typeDimension("bend.orbit_radius_mm", null);
  expect(useProfile.getState().typedHead).toBeNull();
  await typeDimension("limits.tail_mm", 3);
  expect(asked("draw-head")).toHaveLength(3);
});

it("keeps drawing what was typed until it is written", async () => {
  await openProfile("machine", "mine");
  ask.mockImplementation(async (name: string) => (name === "draw-head" ? headOf(21) : profileView()));
  await typeDimension("bend.orbit_radius_mm", 21);
  const written = setValue("bend.orbit_radius_mm", 21);
  await typeDimension("bend.orbit_radius_mm", null);
  expect(useProfile.getState().typedHead).not.toBeNull();
  await written;
  expect(useProfile.getState().typedHead).toBeNull();
});
