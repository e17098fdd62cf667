/** The length of the edge that is being drawn, as it is typed: the pointer says the way. Pure. */

import type { LengthFormat, Vec3 } from "../interface";
import { along, direction, distance, subtract } from "../vec";
import { NumberEntry } from "./number_entry";
import type { Asked } from "./strand";

export class TypedEdge {
  private readonly entry = new NumberEntry();

  /** Whether the key belonged to the number; of an edge there is none with a minus. */
  type(key: string): boolean {
    return key !== "-" && (key !== "Backspace" || this.begun) && this.entry.key(key);
  }

  get begun(): boolean {
    return this.entry.shown !== "";
  }

  clear(): void {
    this.entry.clear();
  }

  /**
   * Where the edge ends, from wherever it begins, that goes towards a place; null where no length is typed. It is asked again when the
   * edge is made: edges that are typed quickly each begin at the end of the one before.
   */
  towards(place: Vec3, lengths: LengthFormat): Asked | null {
    const length = (this.entry.value ?? 0) * lengths.mm;
    if (length === 0) return null;
    return (from) => {
      const way = direction(subtract(place, from));
      return way && { kind: "plane", at: along(from, way, length) };
    };
  }

  /** How long the edge is that ends here, or what is typed of it. */
  readout(from: Vec3, to: Vec3, lengths: LengthFormat): string {
    if (this.begun) return `edge ${this.entry.shown}▏ ${lengths.name}, Enter places it`;
    return `edge ${lengths.number(distance(from, to))} ${lengths.name}`;
  }
}
