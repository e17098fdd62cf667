// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import { useDesign } from "../design/design";
import { designState } from "../testing";
import { forgetProgram, isUpToDate, makeProgram, useProgram } from "./program";
import { program, view } from "./testing";

const state = designState({ machine: "kit", material: "al", name: "U", next: [3, 2] });

beforeEach(() => {
  forgetProgram();
  useDesign.setState({ state, vertices: new Map(), edges: new Map(), check: null });
  platform.ask.mockReset();
  platform.ask.mockImplementation(async (ask: string) => (ask === "program" ? program : view));
});

const asked = (name: string): number => platform.ask.mock.calls.filter(([ask]) => ask === name).length;

describe("makeProgram", () => {
  it("asks once for the same design, and again for another", async () => {
    expect(await makeProgram()).toBe(true);
    expect(await makeProgram()).toBe(true);
    expect(asked("program")).toBe(1);
    useDesign.setState({ vertices: new Map() });
    expect(isUpToDate()).toBe(false);
    await makeProgram();
    expect(asked("program")).toBe(2);
  });

  it("asks for the design as it is once the question of the one before is answered", async () => {
    const both = [makeProgram()];
    useDesign.setState({ vertices: new Map() });
    both.push(makeProgram(), makeProgram());
    expect(asked("program")).toBe(1);
    expect(await Promise.all(both)).toEqual([true, true, true]);
    expect(isUpToDate()).toBe(true);
    expect(asked("program")).toBe(2);
  });

  it("does not ask in the place of a program that is forgotten meanwhile", async () => {
    const both = [makeProgram()];
    useDesign.setState({ vertices: new Map() });
    both.push(makeProgram());
    forgetProgram();
    expect(await Promise.all(both)).toEqual([false, false]);
    expect(asked("program")).toBe(1);
    expect(useProgram.getState()).toMatchObject({ program: null, asking: false });
  });

  it("takes a design for the same when only its notes or its file have changed", async () => {
    await makeProgram();
    useDesign.setState({ state: { ...state, notes: "for Ada", file: "/there/u.wirebend", changed: false } });
    expect(isUpToDate()).toBe(true);
    useDesign.setState({ state: { ...state, doublings: [1] } });
    expect(isUpToDate()).toBe(false);
  });

  it("keeps why there is none", async () => {
    platform.ask.mockRejectedValue(new Error("No machine is chosen."));
    expect(await makeProgram()).toBe(false);
    expect(useProgram.getState()).toMatchObject({ program: null, problem: "No machine is chosen.", asking: false });
  });
});
