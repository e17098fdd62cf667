import { beforeEach, expect, it } from "vitest";
import { forgetRow, hearRow, setPieces, useRow } from "./row";

type Heard = Parameters<typeof hearRow>[0];

const ended = (outcome: string, made: number, of: number, stock_left_mm: number | null = null): Heard =>
  ({ wires: [{ outcome }], pieces: { made, of, stock_left_mm } }) as unknown as Heard;

beforeEach(() => useRow.setState({ pieces: 1, stockMm: null, row: null }));

it("offers the pieces that remain after a stop, with the one that was stopped", () => {
  setPieces(5);
  useRow.setState({ stockMm: 1300 });
  hearRow(ended("made", 1, 5, 1014.2));
  expect(useRow.getState()).toEqual({ pieces: 4, stockMm: 1014, row: { of: 5, left: 4 } });
  hearRow(ended("stopped", 1, 5, 1014.2));
  expect(useRow.getState(), "what was fed of it is not known").toEqual({
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
  expect(useRow.getState(), "and what is left of the wire").toEqual({ pieces: 4, stockMm: 900, row: null });
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
