/** Length and angle of the edge that is being drawn, as they are typed: the pointer says what is not. Pure. */

import type { DrawingPlane, LengthFormat, Vec3 } from "../interface";
import { along, direction, distance, dot, inPlane, planeAngle, subtract } from "../vec";
import { NumberEntry } from "./number_entry";
import type { Asked } from "./strand";

type FieldName = "length" | "angle";

export class TypedEdge {
  private readonly entries: Readonly<Record<FieldName, NumberEntry>> = {
    length: new NumberEntry(),
    angle: new NumberEntry(),
  };
  private field: FieldName = "length";

  /** Whether the key belonged to the number; of a length there is none with a minus. */
  type(key: string): boolean {
    const entry = this.entries[this.field];
    if (key === "-" && this.field === "length") return false;
    return (key !== "Backspace" || this.begun) && entry.key(key);
  }

  /** Goes to the other of the two fields. */
  other(): void {
    this.field = this.field === "length" ? "angle" : "length";
  }

  /** Whether something is typed, or is about to be in the field of the angle. */
  get begun(): boolean {
    return this.field === "angle" || this.entries.length.shown !== "" || this.entries.angle.shown !== "";
  }

  clear(): void {
    this.entries.length.clear();
    this.entries.angle.clear();
    this.field = "length";
  }

  /**
   * Where the edge ends, from wherever it begins, that goes towards a place; null where nothing is typed. It is asked again when the
   * edge is made: edges that are typed quickly each begin at the end of the one before. `plane`: which the angle is in, counted from
   * its first axis to its second.
   */
  towards(place: Vec3, plane: DrawingPlane, lengths: LengthFormat): Asked | null {
    const typed = this.entries.length.value;
    const deg = this.entries.angle.value;
    // No edge is 0 long: that says nothing yet.
    const length = typed === null || typed === 0 ? null : typed * lengths.mm;
    if (length === null && deg === null) return null;
    return (from) => {
      const off = subtract(place, from);
      const way = deg === null ? direction(off) : inPlane(plane, deg);
      if (!way) return null;
      // As far along the typed way as the pointer is, or as it is away where it is behind.
      const shown = dot(off, way) > 0 ? dot(off, way) : distance(place, from);
      return { kind: "plane", at: along(from, way, length ?? shown) };
    };
  }

  /** Length and angle of the edge that ends here, with what is typed of them. */
  dimensions(from: Vec3, to: Vec3, plane: DrawingPlane, lengths: LengthFormat): string {
    const { length, angle } = this.entries;
    const caret = (field: FieldName): string => (this.begun && field === this.field ? "▏" : "");
    const long = length.shown === "" ? lengths.number(distance(from, to)) : length.shown;
    const turned = planeAngle(plane, subtract(to, from));
    const shown = angle.shown === "" ? lengths.angle(turned).replace("°", "") : angle.shown;
    return `${long}${caret("length")} ${lengths.name} · ${shown}${caret("angle")}°`;
  }

  /** The same in the foot of the view, with the keys that go on. */
  readout(dimensions: string, draws: "edge" | "line" = "edge"): string {
    const name = draws === "line" ? "construction line" : "edge";
    if (!this.begun) return `${name} ${dimensions}   Tab: angle`;
    return `${name} ${dimensions}   Tab: ${this.field === "length" ? "angle" : "length"}, Enter: place`;
  }
}
