import { beforeEach, expect, it } from "vitest";
import { forgetRow, hearRow, setPieces, setWire, useRow } from "./row";

type Heard = Parameters<typeof hearRow>[0];

const ended = (outcome: string, made: number, of: number, stock_left_mm: number | null = null): Heard =>
  ({ wires: [{ wire: 0, outcome }], left: [], pieces: { made, of, stock_left_mm } }) as unknown as Heard;

/** The end of one of several wires of a piece. */
const wireEnded = (wire: number, outcome: string, left: readonly number[], made = 0, of = 1): Heard =>
  ({ wires: [{ wire, outcome }], left, pieces: { made, of, stock_left_mm: null } }) as unknown as Heard;

beforeEach(() => useRow.setState(useRow.getInitialState(), true));

it("offers the pieces that remain after a stop, with the one that was stopped", () => {
  setPieces(5);
  useRow.setState({ stockMm: 1300 });
  hearRow(ended("made", 1, 5, 1014.2));
  expect(useRow.getState()).toMatchObject({ pieces: 4, stockMm: 1014, row: { of: 5, left: 4 } });
  hearRow(ended("stopped", 1, 5, 1014.2));
  expect(useRow.getState(), "what was fed of it is not known").toMatchObject({
    pieces: 4,
    stockMm: null,
    row: { of: 5, left: 4 },
  });
  // It is resumed to its end as a wire of its own.
  hearRow(ended("made", 1, 1));
  expect(useRow.getState()).toMatchObject({ pieces: 3, row: { of: 5, left: 3 } });
});

it("offers them again where it was given up, and counts a row of the rest as its own", () => {
  setPieces(3);
  hearRow(ended("stopped", 1, 3));
  hearRow(ended("abandoned", 0, 1));
  expect(useRow.getState()).toMatchObject({ pieces: 2, row: { of: 3, left: 2 } });
  hearRow(ended("made", 1, 2));
  expect(useRow.getState()).toMatchObject({ pieces: 1, row: { of: 2, left: 1 } });
  hearRow(ended("made", 1, 1));
  expect(useRow.getState()).toMatchObject({ pieces: 1, row: null });
});

it("keeps the number of a row that was finished, and of one that a person has set", () => {
  setPieces(4);
  for (const made of [1, 2, 3, 4]) hearRow(ended("made", made, 4, 900));
  expect(useRow.getState(), "and what is left of the wire").toMatchObject({ pieces: 4, stockMm: 900, row: null });
  hearRow(ended("made", 1, 1, 613.9));
  expect(useRow.getState().stockMm).toBe(613);
  hearRow(ended("stopped", 2, 4));
  setPieces(7);
  hearRow(ended("made", 1, 1));
  expect(useRow.getState()).toMatchObject({ pieces: 7, row: null });
  hearRow(ended("stopped", 2, 7));
  forgetRow();
  expect(useRow.getState().row).toBeNull();
});

it("knows which wires of a piece are left, and comes back to all of them", () => {
  hearRow(wireEnded(0, "made", [1, 2]));
  expect(useRow.getState().rest).toEqual([1, 2]);
  hearRow(wireEnded(1, "stopped", [2]));
  expect(useRow.getState().rest, "the interrupted one is the first").toEqual([1, 2]);
  hearRow(wireEnded(1, "abandoned", []));
  expect(useRow.getState().rest, "it is bent anew").toEqual([1, 2]);
  hearRow(wireEnded(1, "made", [], 1));
  hearRow(wireEnded(2, "made", [], 1));
  expect(useRow.getState()).toMatchObject({ rest: [], wire: null, pieces: 1, row: null });
  // The last one of a piece, which no other follows.
  hearRow(wireEnded(0, "made", [1]));
  hearRow(wireEnded(1, "stopped", []));
  expect(useRow.getState().rest).toEqual([1]);
  setWire(0);
  expect(useRow.getState(), "a person wants another one").toMatchObject({ rest: [], wire: 0 });
  hearRow(wireEnded(0, "stopped", []));
  expect(useRow.getState().rest, "one that was armed alone").toEqual([]);
});

it("counts a piece when its last wire is finished", () => {
  setPieces(3);
  hearRow(wireEnded(0, "made", [1], 0, 3));
  hearRow(wireEnded(1, "made", [], 1, 3));
  hearRow(wireEnded(0, "stopped", [1], 1, 3));
  expect(useRow.getState()).toMatchObject({ rest: [0, 1], row: { of: 3, left: 2 } });
  hearRow(wireEnded(0, "made", [], 1));
  expect(useRow.getState()).toMatchObject({ rest: [1], row: { of: 3, left: 2 } });
  hearRow(wireEnded(1, "made", [], 1));
  expect(useRow.getState()).toMatchObject({ rest: [], pieces: 1, row: { of: 3, left: 1 } });
});
