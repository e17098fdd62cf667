/** What is armed next: which wires, how many pieces of them, from how much wire; and what is left of a row that ended before its last one. */

import { create } from "zustand";
import type { OperatorEvent } from "./operator";

type Ended = Extract<OperatorEvent, { event: "run-ended" }>;

/** A row that ended before its last piece. */
export interface Row {
  /** How many there were to be. */
  readonly of: number;
  /** How many of them are not finished; one that was interrupted is among them. */
  readonly left: number;
}

interface RowStore {
  /** The one wire that is armed, by its index; null for all, one after the other. */
  readonly wire: number | null;
  /** Wires of a piece that was begun and is not finished, by their indices: one that was interrupted, and those that follow. */
  readonly rest: readonly number[];
  /** How many pieces are armed. */
  readonly pieces: number;
  /** Length of the wire that is loaded, mm; null where it is not known. */
  readonly stockMm: number | null;
  /** Whether a machine that can cuts each piece off. */
  readonly cut: boolean;
  readonly row: Row | null;
  /** What the machine said of itself when a person accepted that it is set otherwise than its profile says. */
  readonly accepted: string | null;
  /** What a person wants bent although the machine cannot make it: the design as it was, or the file. */
  readonly wanted: { readonly version: number; readonly file: unknown } | null;
}

export const useRow = create<RowStore>()(() => ({
  wire: null,
  rest: [],
  pieces: 1,
  stockMm: null,
  cut: true,
  row: null,
  accepted: null,
  wanted: null,
}));

/** What a person sets is a new row. */
export function setPieces(pieces: number): void {
  useRow.setState({ pieces, rest: [], row: null });
}

export function setWire(wire: number | null): void {
  useRow.setState({ wire, rest: [], row: null });
}

export function setStock(stockMm: number | null): void {
  useRow.setState({ stockMm });
}

export function setCut(cut: boolean): void {
  useRow.setState({ cut });
}

export function setAccepted(accepted: string | null): void {
  useRow.setState({ accepted });
}

export function setWanted(wanted: RowStore["wanted"]): void {
  useRow.setState({ wanted });
}

/** It was of another design. */
export function forgetRow(): void {
  useRow.setState({ wire: null, rest: [], row: null, wanted: null });
}

const WHOLE: ReadonlySet<string> = new Set(["made", "sent", "made-before"]);

/** The wires of the piece that are not finished after one came to its end, or was interrupted. */
function restAfter(
  wire: number,
  whole: boolean,
  follow: readonly number[],
  before: readonly number[],
): readonly number[] {
  if (!whole) return follow.length > 0 ? [wire, ...follow] : before;
  return follow.length > 0 ? follow : before.filter((one) => one !== wire);
}

/** Offers what remains of a row: a wire came to its end, of a row or one that is resumed. */
export function hearRow({ wires, left: follow, pieces }: Pick<Ended, "wires" | "left" | "pieces">): void {
  const last = wires.at(-1);
  if (!last) return;
  const { made, of, stock_left_mm } = pieces;
  const whole = WHOLE.has(last.outcome);
  const { row, rest: before } = useRow.getState();
  const rest = restAfter(last.wire, whole, follow, before);
  useRow.setState({ rest });
  // How much of an interrupted piece is fed is not counted.
  setStock(whole && stock_left_mm !== null ? Math.floor(stock_left_mm) : null);
  if (of > 1) {
    const left = of - made;
    if (left > 0) useRow.setState({ pieces: left, row: { of, left } });
    else useRow.setState({ pieces: of, row: null });
  } else if (row && whole && rest.length === 0) {
    const left = row.left - 1;
    useRow.setState(left > 0 ? { pieces: left, row: { of: row.of, left } } : { pieces: 1, row: null });
  }
}
