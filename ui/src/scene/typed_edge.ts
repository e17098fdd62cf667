/** The length of the edge that is being drawn, as it is typed: the pointer says the way. Pure. */

import { MM_PER_INCH, type Units } from "./grid_spacing";
import type { Vec3 } from "./interface";
import { NumberEntry } from "./number_entry";
import { along, direction, distance, subtract } from "./vec";

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

  /** Where the edge ends that begins at `from` and goes towards a place; null where no length is typed, or no way is shown. */
  end(from: Vec3, towards: Vec3, units: Units): Vec3 | null {
    const length = this.entry.value;
    const way = direction(subtract(towards, from));
    return length && way ? along(from, way, length * (units === "inch" ? MM_PER_INCH : 1)) : null;
  }

  /** How long the edge is that ends here, or what is typed of it. */
  readout(from: Vec3, to: Vec3, units: Units): string {
    if (this.begun) return `edge ${this.entry.shown}▏ ${units === "inch" ? "in" : "mm"}, Enter places it`;
    const long = distance(from, to);
    return units === "inch" ? `edge ${(long / MM_PER_INCH).toFixed(3)} in` : `edge ${long.toFixed(1)} mm`;
  }
}
