// @vitest-environment happy-dom
import { act } from "react";
import { beforeEach, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(async () => {}), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { ProgramResponse } from "../../generated/responses";
import { place } from "../../shared/testing";
import { useDesign } from "../../state/design/design";
import { makeProgram, show, useProgram } from "../../state/program/program";
import { program, view, wire } from "../../state/program/testing";
import { designState } from "../../state/testing";
import { Pause } from "./Pause";

const at = place();
const [first, last] = wire.steps;
if (!first || !last) throw new Error("two steps");
const pausing: ProgramResponse = {
  ...program,
  wires: [{ ...wire, steps: [{ ...first, place: { vertex: 4, pass: 2 }, pause: "turn the part" }, last] }],
  left_out: [{ vertex: 7, pass: 1, note: "clip the joint", why: "no wire comes there" }],
};

beforeEach(async () => {
  const state = designState({ machine: "kit" });
  const nothing = { vertices: [], gone_vertices: [], edges: [], gone_edges: [], stencil: false, state };
  platform.ask.mockReset().mockImplementation(async (name: string) => {
    if (name === "program") return pausing;
    return name === "machine-view" ? view : { change: nothing };
  });
  useDesign.setState({ state, edges: new Map([[0, { id: 0, a: 0, b: 1 }]]) });
  useProgram.setState({ program: null, basis: null });
  await makeProgram();
});

const asked = () => platform.ask.mock.calls.filter(([name]) => name === "edit").map(([, { request }]) => request);
const field = () => at.host.querySelector("input");
const press = (name: string, index = 0) =>
  act(async () =>
    [...at.host.querySelectorAll("button")].filter(({ textContent }) => textContent === name)[index]?.click(),
  );

it("sets and removes the pause after the step that is shown, by its vertex and pass", async () => {
  act(() => show(0));
  at.show(<Pause />);
  const input = field();
  if (!input) throw new Error("no field");
  expect(input.value).toBe("turn the part");
  act(() => {
    Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set?.call(input, "turn it over");
    input.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await press("Set");
  await press("Remove");
  expect(asked()).toEqual([
    { edit: "pause", vertex: 4, pass: 2, note: "turn it over" },
    { edit: "pause", vertex: 4, pass: 2, note: null },
  ]);
});

it("offers none after the last step", async () => {
  act(() => show(1));
  at.show(<Pause />);
  expect(field()?.disabled).toBe(true);
  await press("Set");
  expect(asked()).toEqual([]);
});

it("names a pause that no wire comes to, which can be removed", async () => {
  act(() => show(1));
  at.show(<Pause />);
  expect(at.host.textContent).toContain("Pause left out: clip the joint");
  expect(at.host.textContent).toContain("Vertex 7: no wire comes there.");
  await press("Remove", 1);
  expect(asked()).toEqual([{ edit: "pause", vertex: 7, pass: 1, note: null }]);
});
