// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { AvoidedCollisions, Collisions, ContactReport, EditRequest, Fix } from "../../../generated/responses";
import { useProblems } from "../../asking/problems";
import { useDesign } from "../design";
import { avoidCollisions, endAvoiding, setSearch, useAvoiding, weighsNothing } from "./avoiding";

const finding = { code: "meets_machine" as const, severity: "warning" as const, message: "", help: "" };
const collisions = (): Collisions => ({
  checked: true,
  stopped: false,
  contacts: [{ wire: 0, step: 1, finding } as ContactReport],
  bodies: 6,
  estimates: 6,
});
const walks: EditRequest = {
  edit: "several",
  label: "order of the bends",
  edits: [{ edit: "walks", walks: [{ start: 0, edges: [1, 2] }] }],
};
const fix = (wires = 1): Fix => ({ mends: finding, title: "", edit: walks, after: { wires } }) as Fix;
const outcome = (given: Partial<AvoidedCollisions>): AvoidedCollisions => ({
  found: true,
  steps_checked: 10,
  ended: false,
  best: null,
  unfound: [],
  helps: [],
  ...given,
});
const asked = (name: string) => platform.ask.mock.calls.filter(([ask]) => ask === name);
const answer = (given: AvoidedCollisions) =>
  platform.ask.mockImplementation((ask: string) =>
    ask === "avoid-collisions"
      ? Promise.resolve(given)
      : ask === "edit"
        ? Promise.resolve({ change: null, notes: [] })
        : Promise.reject(new Error(ask)),
  );
const found = (of: Collisions) =>
  useDesign.setState({ collisions: { found: of } as ReturnType<typeof useDesign.getState>["collisions"] });
const said = () => useProblems.getState().problems.map(({ message }) => message);

beforeEach(() => {
  platform.ask.mockReset();
  useAvoiding.setState({ avoiding: null });
  useProblems.setState({ problems: [] });
  useDesign.setState({ limits: null });
  setSearch({ effort: null, seed: null, weights: null, wires: null });
});

it("takes the walks that were found, asked for as a person has set it", async () => {
  found(collisions());
  answer(outcome({ best: fix() }));
  setSearch({ effort: 500, seed: 7 });
  await avoidCollisions();
  expect(asked("avoid-collisions").map(([, request]) => request)).toEqual([
    { settings: { effort: 500, seed: 7, weights: null, wires: null } },
  ]);
  expect(asked("edit").map(([, request]) => request)).toEqual([expect.objectContaining({ request: walks })]);
});

it("asks first where more wires are needed, and takes nothing that still hits something", async () => {
  for (const given of [outcome({ best: fix(2) }), outcome({ found: false, best: fix() })]) {
    found(collisions());
    useDesign.setState({ limits: { wires: [{}] } as ReturnType<typeof useDesign.getState>["limits"] });
    answer(given);
    await avoidCollisions();
    expect(asked("edit")).toHaveLength(0);
    expect(useAvoiding.getState().avoiding?.outcome).toBe(given);
  }
});

it("searches once at a time, and again where it is asked again", async () => {
  found(collisions());
  answer(outcome({ found: false }));
  await Promise.all([avoidCollisions(), avoidCollisions()]);
  expect(asked("avoid-collisions")).toHaveLength(1);
  await avoidCollisions();
  expect(asked("avoid-collisions")).toHaveLength(2);
});

it("ends with the best until then", async () => {
  found(collisions());
  let give: (given: AvoidedCollisions) => void = () => {};
  answer(outcome({}));
  platform.ask.mockImplementation((ask: string) =>
    ask === "avoid-collisions"
      ? new Promise((resolve) => {
          give = resolve;
        })
      : Promise.resolve({ change: null, notes: [] }),
  );
  const over = avoidCollisions();
  endAvoiding();
  expect(asked("stop-avoiding")).toHaveLength(1);
  expect(useAvoiding.getState().avoiding?.ending).toBe(true);
  give(outcome({ best: fix(), ended: true }));
  await over;
  expect(asked("edit")).toHaveLength(1);
});

it("ends for another design, whose wire has no use for it", async () => {
  found(collisions());
  let give: (given: AvoidedCollisions) => void = () => {};
  platform.ask.mockImplementation((ask: string) =>
    ask === "avoid-collisions"
      ? new Promise((resolve) => {
          give = resolve;
        })
      : Promise.resolve({}),
  );
  const over = avoidCollisions();
  found(collisions());
  expect(asked("stop-avoiding")).toHaveLength(1);
  give(outcome({ best: fix() }));
  await over;
  expect(asked("edit")).toHaveLength(0);
  expect([useAvoiding.getState().avoiding, said()]).toEqual([null, []]);
});

it("knows weights with which no order is better than another", () => {
  expect(weighsNothing({ weights: { wire: 0, doubled_mm: 0, second: 0 } })).toBe(true);
  expect(weighsNothing({ weights: { wire: 0, doubled_mm: 1, second: 0 } })).toBe(false);
  expect(weighsNothing({ weights: null })).toBe(false);
});
