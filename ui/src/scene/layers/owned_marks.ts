/** Signs and lines over the picture, each set kept by its owner's name. */

import type { Sign } from "../drawing/symbols";
import type { Guide } from "../drawing/tubes";

interface Marks {
  readonly signs: readonly Sign[];
  readonly lines: readonly Guide[];
}

export class OwnedMarks {
  private readonly owned = new Map<string, Marks>();

  /** Instead of those that the owner had; whether there is anything to be drawn anew. */
  set(owner: string, signs: readonly Sign[], lines: readonly Guide[]): boolean {
    if (signs.length === 0 && lines.length === 0) return this.owned.delete(owner);
    this.owned.set(owner, { signs, lines });
    return true;
  }

  get signs(): readonly Sign[] {
    return [...this.owned.values()].flatMap(({ signs }) => signs);
  }

  get lines(): readonly Guide[] {
    return [...this.owned.values()].flatMap(({ lines }) => lines);
  }
}
