// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from "vitest";

const ask = vi.hoisted(() => vi.fn());
vi.mock("../../platform", () => ({
  platform: { ask, stop: vi.fn(), listen: vi.fn() },
  Refused: class Refused extends Error {},
}));

import type { EditRequest } from "../../generated/requests";
import type { EditOutcome } from "../../generated/responses";
import { askForOutcome, useOutcomes } from "./outcomes";

const fillet = (radius_mm: number): EditRequest => ({ edit: "fillet", vertices: [1], radius_mm, step_deg: 15 });
const made = (shortest_mm: number): EditOutcome => ({
  outcome: "fillet",
  chords: [2],
  shortest_mm,
  needed_mm: 0,
  clear_mm: null,
});

/** Questions that are on their way, with what answers them. */
let answers: ((outcome: EditOutcome | Error) => void)[] = [];
beforeEach(() => {
  answers = [];
  ask.mockReset().mockImplementation(
    () =>
      new Promise((answer, refuse) => {
        answers.push((outcome) => (outcome instanceof Error ? refuse(outcome) : answer({ outcome })));
      }),
  );
});

it("asks for the figures that were typed last, and for none of those between", async () => {
  for (const radius of [1, 12, 120]) askForOutcome("fillet", `radius ${radius}`, fillet(radius));
  expect(ask.mock.calls).toEqual([["outcome", { request: fillet(1) }]]);
  answers[0]?.(made(1));
  await vi.waitFor(() => expect(ask).toHaveBeenCalledTimes(2));
  expect(ask).toHaveBeenLastCalledWith("outcome", { request: fillet(120) });
  expect(useOutcomes.getState().fillet?.to).toBe("radius 1");
  answers[1]?.(made(120));
  await vi.waitFor(() => expect(useOutcomes.getState().fillet).toMatchObject({ to: "radius 120", outcome: made(120) }));
  expect(ask).toHaveBeenCalledTimes(2);
});

it("says why an edit would be refused, and asks again afterwards", async () => {
  askForOutcome("fillet", "held", fillet(5));
  answers[0]?.(new Error("vertex 1 is held"));
  const refused = { to: "held", outcome: null, problem: "vertex 1 is held" };
  await vi.waitFor(() => expect(useOutcomes.getState().fillet).toEqual(refused));
  askForOutcome("fillet", "free", fillet(5));
  answers[1]?.(made(5));
  await vi.waitFor(() => expect(useOutcomes.getState().fillet).toMatchObject({ to: "free", problem: null }));
});
