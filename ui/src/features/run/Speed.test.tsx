// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const order = vi.hoisted(() => vi.fn(async (_: { readonly order: "speed"; readonly percent: number }) => true));
vi.mock("../../state/machine/run", () => ({ order }));

import { place } from "../../shared/testing";
import { Speed } from "./Speed";

const at = place();
const press = (label: string) =>
  act(() => at.host.querySelector<HTMLButtonElement>(`[aria-label="${label}"]`)?.click());
const asked = () => order.mock.calls.map(([{ percent }]) => percent);

beforeEach(() => void order.mockClear());

it("goes on from what was asked for, while the machine has not reported it", () => {
  at.show(<Speed percent={100} why={null} />);
  for (const _ of "123") press("Slower");
  press("Faster");
  expect(asked()).toEqual([90, 80, 70, 80]);
});

it("goes on from what the machine has, once what was asked for is long ago", () => {
  const now = vi.spyOn(performance, "now").mockReturnValue(0);
  at.show(<Speed percent={100} why={null} />);
  press("Faster");
  now.mockReturnValue(5000);
  // A firmware that goes no faster than its program.
  press("Slower");
  expect(asked()).toEqual([110, 90]);
  now.mockRestore();
});

it("asks for no more than a machine may be asked for", () => {
  at.show(<Speed percent={190} why={null} />);
  for (const _ of "12") press("Faster");
  expect(asked()).toEqual([200, 200]);
});

it("goes on from what the machine has, where it has refused", async () => {
  order.mockResolvedValueOnce(false);
  at.show(<Speed percent={100} why={null} />);
  press("Faster");
  await act(async () => {});
  press("Slower");
  expect(asked()).toEqual([110, 90]);
});
