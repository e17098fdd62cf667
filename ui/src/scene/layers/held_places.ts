/** Places that are held, with a square around each, and forces, as arrows that end where they act. */

import type { Shape, Sign } from "../drawing/symbols";
import type { Theme } from "../drawing/theme";
import type { SceneHeld } from "../interface";

/** How far the head of an arrow, and the dots of its shaft, are from the vertex, CSS pixels. */
const HEAD = -20;
const SHAFT = [-32, -39, -46];

export class HeldPlaces {
  shown: SceneHeld = { places: [], forces: [] };

  signs(theme: Theme): Sign[] {
    const squares = this.shown.places.map((at): Sign => ({ at, shape: "square", colour: theme.acted, radius: 8 }));
    const arrows = this.shown.forces.flatMap(([at, way]) => {
      const sign = (shape: Shape, radius: number, off: number): Sign => ({
        at,
        shape,
        colour: theme.acted,
        radius,
        towards: way,
        off,
      });
      return [...SHAFT.map((off) => sign("dot", 5, off)), sign("arrow", 11, HEAD)];
    });
    return [...squares, ...arrows];
  }
}
