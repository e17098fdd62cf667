// @vitest-environment happy-dom
import { act } from "react";
import { expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { PlayedWire } from "../../generated/responses";
import type { Played } from "../../scene/interface";
import { place } from "../../shared/testing";
import { useProblems } from "../../state/asking/problems";
import { useDesign } from "../../state/design/design";
import { useByHand } from "../../state/machine/by_hand";
import { useProgram } from "../../state/program/program";
import { designState } from "../../state/testing";
import { Timeline } from "./Timeline";

const at = place();
const step: PlayedWire["steps"][number] = {
  designed: { feed_mm: 30, rotate_deg: 0, bend_deg: 0 },
  told: null,
  seconds: [1, 0, 0, 0],
  vertex: null,
  edges: [],
  place: null,
  pause: null,
  pose: { turn: [0, 0, 0, 1], bend_axis: [0, 0, 1], bend_deg: 0 },
  moments: [],
};
const wire: PlayedWire = { bend_axis: [0, 0, 1], corners_mm: [], steps: [step], stock_mm: null, time_s: 1 };
const byHand: Played = {
  steps: [],
  designed: { corners: [], poses: [] },
  made: null,
  bodies: [],
  wireDiameter: 2,
  orbitOffset: 0,
  pegTop: 0,
};

it("says that the view shows moves by hand, and goes back from there", () => {
  useProgram.setState({
    program: {
      job_hash: "a1",
      diameter_mm: 3,
      feasible: true,
      machine: "kit",
      material: "al",
      wires: [wire],
      without: 0,
      left_out: [],
    },
  });
  at.show(<Timeline />);
  expect(at.host.textContent).toContain("step 1 / 1");
  act(() => useByHand.setState({ moves: 1, played: byHand }));
  expect(at.host.textContent).toContain("1 move by hand, not this program");
  expect(at.host.textContent).not.toContain("step 1 / 1");
  act(() => at.host.querySelector<HTMLButtonElement>('[aria-label="Back to the design"]')?.click());
  expect(at.host.textContent).toContain("step 1 / 1");
});

it("keeps its place while there is no program, and says so", () => {
  useByHand.setState({ moves: 0, played: null });
  useProgram.setState({ program: null });
  at.show(<Timeline />);
  expect(at.host.textContent).toContain("no program yet");
  expect(at.host.querySelector<HTMLInputElement>("input[type=range]")?.disabled).toBe(true);
  const why = [...at.host.querySelectorAll("button")].map((button) => button.title);
  expect(why).toEqual(["The design is empty.", "The design is empty.", "The design is empty."]);
});

it("does not deny a program that is made when it is played", () => {
  useByHand.setState({ moves: 0, played: null });
  useProgram.setState({ program: null });
  useDesign.setState({
    vertices: new Map([[0, { id: 0, at: [0, 0, 0], support: false }]]),
    state: designState({ machine: "kit" }),
  });
  at.show(<Timeline />);
  expect(at.host.textContent).toContain("not played yet");
  const why = [...at.host.querySelectorAll("button")].map((button) => button.title);
  expect(why).toEqual(["Press Play first.", "Play (Space)", "Press Play first."]);
});

it("plays nothing where there is no program, and says so, until the design is another one", async () => {
  useByHand.setState({ moves: 0, played: null });
  useProblems.setState({ problems: [] });
  useProgram.setState({ program: null, basis: null });
  useDesign.setState({
    vertices: new Map([[0, { id: 0, at: [0, 0, 0], support: false }]]),
    edges: new Map(),
    state: designState({ machine: "kit" }),
  });
  platform.ask.mockImplementation(async (ask: string) => {
    if (ask === "program") throw new Error("Vertex 3 needs a bend that the machine cannot make.");
    return null;
  });
  at.show(<Timeline />);
  const buttons = () => [...at.host.querySelectorAll("button")];
  await act(async () => {
    buttons()[1]?.click();
    await new Promise((resolve) => setTimeout(resolve));
  });
  const none = "There is no program: see Check.";
  expect(buttons().map(({ title }) => title)).toEqual([none, none, none]);
  expect(buttons()[1]?.getAttribute("aria-disabled")).toBe("true");
  expect(useProblems.getState().problems.map(({ message }) => message)).toEqual([none]);
  act(() => useDesign.setState({ edges: new Map([[0, { id: 0, a: 0, b: 1 }]]) }));
  expect(buttons()[1]?.title).toBe("Play (Space)");
});
