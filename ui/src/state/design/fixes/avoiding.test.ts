// @vitest-environment happy-dom
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { Collisions, ContactReport, EditRequest, Fix } from "../../../generated/responses";
import { useDesign } from "../design";
import { avoidCollisions, useFixes } from "./fixes";

const finding = { code: "meets_machine" as const, severity: "warning" as const, message: "", help: "" };
const collisions = (): Collisions => ({
  checked: true,
  stopped: false,
  contacts: [{ wire: 0, step: 1, finding } as ContactReport],
  bodies: 6,
  estimates: 6,
});
const fix = (edit: EditRequest): Fix => ({ mends: finding, title: "", edit, after: { wires: 1 } }) as Fix;
const turned: EditRequest = { edit: "reversed", reversed: true };
const walks: EditRequest = {
  edit: "several",
  label: "order of the bends",
  edits: [{ edit: "walks", walks: [{ start: 0, edges: [1, 2] }] }],
};
const asked = (name: string) => platform.ask.mock.calls.filter(([ask]) => ask === name);
const offer = (fixes: Fix[]) =>
  platform.ask.mockImplementation((ask: string) =>
    ask === "fixes" ? Promise.resolve({ fixes }) : Promise.reject(new Error(ask)),
  );
const found = (of: Collisions) =>
  useDesign.setState({ collisions: { found: of } as ReturnType<typeof useDesign.getState>["collisions"] });

beforeEach(() => {
  platform.ask.mockReset();
  useFixes.setState({ fixes: [], of: null, ofCollisions: null, avoiding: null });
});

it("takes the walks that were found, and no other fix", async () => {
  found(collisions());
  offer([fix(turned), fix(walks)]);
  await avoidCollisions();
  expect(asked("edit").map(([, request]) => request)).toEqual([expect.objectContaining({ request: walks })]);
});

it("says where none were found, searches once, and again for another design", async () => {
  const of = collisions();
  found(of);
  offer([fix(turned)]);
  await Promise.all([avoidCollisions(), avoidCollisions()]);
  expect(useFixes.getState().avoiding).toEqual({ of, failed: true });
  expect([asked("fixes").length, asked("edit").length]).toEqual([1, 0]);
  found(collisions());
  await avoidCollisions();
  expect(asked("fixes")).toHaveLength(2);
});
