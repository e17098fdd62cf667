// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from "vitest";

const platform = vi.hoisted(() => ({ ask: vi.fn(), stop: vi.fn(), listen: vi.fn(), stencilMesh: vi.fn() }));
vi.mock("../../platform", () => ({ platform, Refused: class Refused extends Error {} }));

import type { DesignView, EditMade, ViewChange } from "../../generated/responses";
import { useProblems } from "../asking/problems";
import { designState as state } from "../testing";
import { edit, redo, showDesign, undo, useDesign } from "./design";
import { inTurn, replacingDesign } from "./turns";

const view = (given: Partial<DesignView> = {}): DesignView =>
  ({ state: state(), vertices: [], edges: [], ...given }) as DesignView;
const made = (x: number): EditMade => {
  const change: Partial<ViewChange> = {
    vertices: [{ id: 0, at_mm: [x, 0, 0], support: false }],
    edges: [],
    gone_vertices: [],
    gone_edges: [],
    state: state({ name: `${x}` }),
  };
  return { change: change as ViewChange, notes: [] };
};

/** Answers that come when the test says so, in the order of the questions. */
let answers: {
  readonly ask: string;
  readonly answer: (with_: unknown) => void;
  readonly refuse: (why: Error) => void;
}[];
/** What has to be waited for without an answer is over after this. */
const turns = () => new Promise((resolve) => setTimeout(resolve));

beforeEach(() => {
  answers = [];
  platform.ask.mockReset();
  platform.ask.mockImplementation(
    (ask: string) => new Promise((answer, refuse) => answers.push({ ask, answer, refuse })),
  );
  platform.stencilMesh.mockReset();
  useDesign.setState({
    vertices: new Map(),
    edges: new Map(),
    state: state(),
    surfaces: new Map(),
    check: null,
    notes: [],
  });
  useProblems.setState({ problems: [] });
});

describe("changes", () => {
  it("are asked for one after the other, so that an older answer does not come over a newer one", async () => {
    const all = [edit({ edit: "delete", vertices: [1], edges: [] }), undo(), redo()];
    await turns();
    expect(answers.map(({ ask }) => ask)).toEqual(["edit"]);
    answers[0]?.answer(made(1));
    await turns();
    expect(answers.map(({ ask }) => ask)).toEqual(["edit", "undo"]);
    answers[1]?.answer(made(2));
    await turns();
    answers[2]?.answer(made(3));
    await Promise.all(all);
    expect(useDesign.getState().vertices.get(0)?.at).toEqual([3, 0, 0]);
  });

  it("continue after one that was refused", async () => {
    const first = edit({ edit: "delete", vertices: [1], edges: [] });
    const second = edit({ edit: "delete", vertices: [2], edges: [] });
    await turns();
    answers[0]?.refuse(new Error("There is no vertex 1."));
    await turns();
    answers[1]?.answer(made(2));
    expect([await first, await second].map((change) => change === null)).toEqual([true, false]);
    expect(useProblems.getState().problems.map(({ message }) => message)).toEqual(["There is no vertex 1."]);
  });

  it("say that they give a chosen order of the bends up, and no more once undo has brought it back", async () => {
    const walk = { start: 0, edges: [1, 2] };
    const answered = (walks: (typeof walk)[]) => ({
      change: { ...made(1).change, state: state({ walks }) },
      notes: [],
    });
    const said = () => useProblems.getState().problems.map(({ message }) => message);
    const makes = async (change: Promise<unknown>, walks: (typeof walk)[]) => {
      await turns();
      answers.at(-1)?.answer(answered(walks));
      await change;
    };
    await makes(edit({ edit: "walks", walks: [walk] }), [walk]);
    await makes(edit({ edit: "notes", text: "" }), [walk]);
    expect(said()).toEqual([]);
    await makes(edit({ edit: "reversed", reversed: true }), []);
    expect(said()).toEqual([
      "The chosen order of the bends is given up: it was for the route before. Undo brings it back.",
    ]);
    await makes(undo(), [walk]);
    expect(said()).toEqual([]);
    // It is what was asked for, or done before.
    await makes(edit({ edit: "walks", walks: [] }), []);
    await makes(edit({ edit: "walks", walks: [walk, walk] }), [walk, walk]);
    await makes(redo(), []);
    expect(said()).toEqual([]);
    await makes(undo(), [walk, walk]);
    await makes(edit({ edit: "wires", wires: 3 }), []);
    expect(said()[0]).toContain("The chosen orders of the bends of 2 wires are given up");
  });

  it("are not made of another design that is on its way, and the person reads why", async () => {
    let there: () => void = () => {};
    const replaced = replacingDesign(() => new Promise<void>((resolve) => (there = resolve)));
    expect(await edit({ edit: "delete", vertices: [1], edges: [] })).toBeNull();
    await undo();
    expect(answers).toEqual([]);
    expect(useProblems.getState().problems[0]?.message).toMatch(/^A file is being read\./);
    there();
    await replaced;
    const again = edit({ edit: "delete", vertices: [1], edges: [] });
    await turns();
    answers[0]?.answer(made(1));
    expect(await again).not.toBeNull();
  });
});

/** A stencil whose surface has so many faces. */
const stencil = (id: number) => ({ id, surface: { faces: 1 } }) as unknown as DesignView["state"]["stencils"][number];
const triangle = () => {
  const bytes = new ArrayBuffer(8 + 3 * 12 + 12);
  new Uint32Array(bytes, 0, 2).set([3, 1]);
  return bytes;
};

describe("stencils", () => {
  it("are read once each, and forgotten when they are gone", async () => {
    platform.stencilMesh.mockImplementation(async () => triangle());
    await showDesign(view({ state: state({ stencils: [stencil(0)] }) }), []);
    const first = useDesign.getState().surfaces.get(0);
    expect(first?.triangles.length).toBe(3);
    const answer = async (stencils: DesignView["state"]["stencils"]) => {
      const asked = edit({ edit: "remove-stencil", stencil: 0 });
      await turns();
      answers.at(-1)?.answer({ ...made(0), change: { ...made(0).change, state: state({ stencils }) } });
      await asked;
    };
    await answer([stencil(0), stencil(1)]);
    expect(useDesign.getState().surfaces.get(0)).toBe(first);
    expect(platform.stencilMesh.mock.calls).toEqual([[0], [1]]);
    await answer([stencil(1)]);
    await answer([stencil(0), stencil(1)]);
    expect(platform.stencilMesh.mock.calls).toEqual([[0], [1], [0]]);
  });

  it("of a design that was shown before does not come over the next one", async () => {
    let first: (bytes: ArrayBuffer) => void = () => {};
    platform.stencilMesh.mockImplementationOnce(() => new Promise((resolve) => (first = resolve)));
    const before = view({ state: state({ stencils: [stencil(0)] }) });
    const shown = [inTurn(() => showDesign(before, [])), inTurn(() => showDesign(view(), []))];
    await turns();
    first(new Uint32Array([0, 0]).buffer);
    await Promise.all(shown);
    expect(useDesign.getState().surfaces.size).toBe(0);
  });

  it("that cannot be read is reported, and the design is there", async () => {
    platform.stencilMesh.mockRejectedValue(new Error("The window does not answer."));
    await showDesign(view({ state: state({ name: "B", stencils: [stencil(0)] }) }), []);
    expect(useDesign.getState()).toMatchObject({ state: { name: "B" }, surfaces: new Map() });
    expect(useProblems.getState().problems.map(({ message }) => message)).toEqual(["The window does not answer."]);
  });
});
