/** Several pieces in a row: how many, from how much wire, and what is left of a row that ended before its last piece. */

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
  /** How many pieces are armed next. */
  readonly pieces: number;
  /** Length of the wire that is loaded, mm; null where it is not known. */
  readonly stockMm: number | null;
  readonly row: Row | null;
}

export const useRow = create<RowStore>()(() => ({ pieces: 1, stockMm: null, row: null }));

/** What a person sets is a new row. */
export function setPieces(pieces: number): void {
  useRow.setState({ pieces, row: null });
}

export function setStock(stockMm: number | null): void {
  useRow.setState({ stockMm });
}

/** It was of another design. */
export function forgetRow(): void {
  useRow.setState({ row: null });
}

const WHOLE: ReadonlySet<string> = new Set(["made", "sent", "made-before"]);

/** Offers what remains of a row: a wire came to its end, of a row or one that is resumed. */
export function hearRow({ wires, pieces: { made, of, stock_left_mm } }: Pick<Ended, "wires" | "pieces">): void {
  const last = wires.at(-1);
  if (!last) return;
  const whole = WHOLE.has(last.outcome);
  const { row } = useRow.getState();
  // How much of an interrupted piece is fed is not counted.
  setStock(whole && stock_left_mm !== null ? Math.floor(stock_left_mm) : null);
  if (of > 1) {
    const left = of - made;
    if (left > 0) useRow.setState({ pieces: left, row: { of, left } });
    else useRow.setState({ pieces: of, row: null });
  } else if (row && whole) {
    const left = row.left - 1;
    useRow.setState(left > 0 ? { pieces: left, row: { of: row.of, left } } : { pieces: 1, row: null });
  }
}
