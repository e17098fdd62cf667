import { describe, expect, it } from "vitest";
import type { Stroke, Vec3 } from "../interface";
import type { SnapTarget } from "../picking/snap";
import { type Asked, Strand } from "./strand";

const place = (x: number): SnapTarget => ({ kind: "surface", at: [x, 0, 0] });
const vertex = (id: number): SnapTarget => ({ kind: "vertex", at: [id * 100, 5, 0], vertex: id });
const edge = (id: number, x: number): SnapTarget => ({ kind: "edge", at: [x, 9, 0], edge: id, along: 0.25 });

/** Clicks in a row; answers with ids from 50 on, or as told. */
async function clicked(targets: (SnapTarget | Asked)[], answer: (n: number) => number | null = (n) => 50 + n) {
  const strokes: Stroke[] = [];
  let ended = 0;
  const strand = new Strand(
    async (stroke) => {
      strokes.push(stroke);
      return answer(strokes.length - 1);
    },
    async () => false,
    () => undefined,
    () => (ended += 1),
  );
  // All at once: the user does not wait for an edge before the next click.
  await Promise.all(targets.map((target) => strand.click(target)));
  return { strokes, strand, ended: () => ended };
}

it("keeps the first place until the second makes an edge of the two", async () => {
  expect((await clicked([place(1)])).strokes).toEqual([]);
  const { strokes } = await clicked([place(1), place(2)]);
  expect(strokes).toEqual([
    {
      from: null,
      through: [
        [1, 0, 0],
        [2, 0, 0],
      ],
      to: null,
      split: null,
    },
  ]);
});

it("begins an edge of a length where the one before it has ended, however soon it is asked for", async () => {
  const long =
    (mm: number): Asked =>
    ([x, y, z]) => ({ kind: "plane", at: [x + mm, y, z] });
  const { strokes } = await clicked([place(1), long(80), long(50)]);
  expect(strokes.map(({ through }) => through.at(-1))).toEqual([
    [81, 0, 0],
    [131, 0, 0],
  ]);
  expect((await clicked([long(80)])).strokes).toEqual([]);
});

it("continues from the vertex that the last stroke has made", async () => {
  const { strokes, strand } = await clicked([vertex(3), place(1), place(2)]);
  expect(strokes).toEqual([
    { from: 3, through: [[1, 0, 0]], to: null, split: null },
    { from: 50, through: [[2, 0, 0]], to: null, split: null },
  ]);
  expect(strand.end).toMatchObject({ kind: "vertex", id: 51 });
});

it("ends at a vertex that is there, and the next click begins anew", async () => {
  const { strokes, strand, ended } = await clicked([place(1), vertex(4), place(7)]);
  expect(strokes).toEqual([{ from: null, through: [[1, 0, 0]], to: 4, split: null }]);
  expect(ended()).toBe(1);
  expect(strand.end).toMatchObject({ kind: "place", at: [7, 0, 0] });
});

it("does not go on while the stroke that ends it is on its way", async () => {
  const made: (() => void)[] = [];
  const strand = new Strand(
    () => new Promise((resolve) => made.push(() => resolve(50))),
    async () => false,
    () => undefined,
    () => undefined,
  );
  const settled = () => new Promise((resolve) => setTimeout(resolve));
  await strand.click(place(1));
  expect(strand.goesOn).toBe(true);
  const between = strand.click(place(2));
  await settled();
  // What is typed meanwhile is of the edge after this one.
  expect(strand.goesOn).toBe(true);
  made.pop()?.();
  await between;
  const last = strand.click(vertex(7));
  await settled();
  expect(strand.end).not.toBeNull();
  expect(strand.goesOn).toBe(false);
  made.pop()?.();
  await last;
  await strand.click(place(3));
  expect(strand.goesOn).toBe(true);
});

it("splits the edge that it begins on", async () => {
  const { strokes } = await clicked([edge(6, 1), place(2)]);
  expect(strokes).toEqual([{ from: null, through: [[2, 0, 0]], to: null, split: { edge: 6, at: 0.25, end: "from" } }]);
});

it("splits the edge that it ends on", async () => {
  const { strokes, ended } = await clicked([place(1), edge(6, 2)]);
  expect(strokes).toEqual([{ from: null, through: [[1, 0, 0]], to: null, split: { edge: 6, at: 0.25, end: "to" } }]);
  expect(ended()).toBe(1);
});

it("splits two edges one after the other", async () => {
  const { strokes } = await clicked([edge(6, 1), edge(8, 2)]);
  expect(strokes).toEqual([
    { from: null, through: [], to: null, split: { edge: 6, at: 0.25, end: "from" } },
    { from: 50, through: [], to: null, split: { edge: 8, at: 0.25, end: "to" } },
  ]);
});

it("does not ask for an edge without length", async () => {
  expect((await clicked([place(1), place(1)])).strokes).toEqual([]);
  expect((await clicked([vertex(1), vertex(1)])).strokes).toEqual([]);
});

it("ends when it is told to, and does nothing with clicks from before", async () => {
  const { strand, ended } = await clicked([place(1)]);
  const late = strand.click(place(2));
  expect(strand.cancel()).toBe(true);
  await late;
  expect(strand.end).toBeNull();
  expect(ended()).toBe(1);
  expect(strand.cancel()).toBe(false);
});

it("is over when the listener says so, and when a stroke cannot be made", async () => {
  expect((await clicked([place(1), place(2)], () => null)).strand.end).toBeNull();
  const strand = new Strand(
    () => Promise.reject(new Error("no such edge")),
    async () => false,
    () => undefined,
    () => undefined,
  );
  await strand.click(place(1));
  await expect(strand.click(place(2))).rejects.toThrow("no such edge");
  expect(strand.end).toBeNull();
});

describe("a strand of construction lines", () => {
  /** Clicks in a row, each of an edge or a line. */
  async function drawn(clicks: readonly (readonly [SnapTarget, "edge" | "line"])[], made = true) {
    const lines: (readonly [Vec3, Vec3])[] = [];
    const strokes: Stroke[] = [];
    let ended = 0;
    const strand = new Strand(
      async (stroke) => 50 + strokes.push(stroke),
      async (from, to) => {
        lines.push([from, to]);
        return made;
      },
      () => undefined,
      () => (ended += 1),
    );
    await Promise.all(clicks.map(([target, draws]) => strand.click(target, draws)));
    return { lines, strokes, strand, ended };
  }

  it("goes on from line to line, and makes no edge", async () => {
    const { lines, strokes, strand } = await drawn([
      [place(1), "line"],
      [place(2), "line"],
      [place(3), "line"],
    ]);
    expect(lines.map(([[from], [to]]) => [from, to])).toEqual([
      [1, 2],
      [2, 3],
    ]);
    expect([strokes, strand.end]).toEqual([[], { kind: "line", at: [3, 0, 0] }]);
  });

  it.each([
    ["a vertex", vertex(4)],
    ["an edge, which is not split", edge(7, 2)],
    ["another construction line", { kind: "construction", at: [9, 0, 0] } as const],
  ])("begins and ends at %s", async (_, target) => {
    const { lines, strokes, strand, ended } = await drawn([
      [vertex(1), "line"],
      [target, "line"],
    ]);
    expect(lines).toEqual([[[100, 5, 0], target.at]]);
    expect([strokes, strand.end, ended]).toEqual([[], null, 1]);
  });

  it("goes on as edges, from the vertex that it began at or from where the last line ends", async () => {
    const { strokes } = await drawn([
      [vertex(1), "line"],
      [place(2), "edge"],
    ]);
    expect(strokes).toEqual([{ from: 1, through: [[2, 0, 0]], to: null, split: null }]);
    const mixed = await drawn([
      [place(1), "line"],
      [place(2), "line"],
      [place(3), "edge"],
    ]);
    expect(mixed.strokes).toMatchObject([{ from: null, through: [place(2).at, place(3).at] }]);
  });

  it("is over where a line could not be made", async () => {
    const { strand, ended } = await drawn(
      [
        [place(1), "line"],
        [place(2), "line"],
      ],
      false,
    );
    expect([strand.end, ended]).toEqual([null, 1]);
  });
});
