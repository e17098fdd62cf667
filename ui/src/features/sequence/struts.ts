/** A sequence as the view draws it: what is built, what is being built, what is to come, and the head. */

import type { DrawnSequence } from "../../generated/responses";
import type { Colour, SceneDesign, SceneLine, SceneStruts, Vec3 } from "../../scene/interface";
import { stepAt } from "../../state/sequence/sequence";
import { layerColour, UNKNOWN } from "../frame/ramp";

const BUILT: Colour = UNKNOWN;
const PRESENT: Colour = [0.35, 0.63, 1];
/** How faint what is to come is. */
const FAINT = 0.78;

/** The layer of each edge. */
export function layersOf({ sequence }: DrawnSequence): ReadonlyMap<number, number> {
  const layers = new Map<number, number>();
  for (const [layer, edges] of (sequence.layers ?? []).entries()) for (const edge of edges) layers.set(edge, layer);
  return layers;
}

const evenly = (a: Vec3, b: Vec3, part: number): Vec3 => [
  a[0] + (b[0] - a[0]) * part,
  a[1] + (b[1] - a[1]) * part,
  a[2] + (b[2] - a[2]) * part,
];

/** `layers`: the layer of each edge, where struts are coloured so. */
export function drawnSequence(
  drawn: DrawnSequence,
  at: number,
  { vertices, edges }: SceneDesign,
  layers: ReadonlyMap<number, number> | null,
): SceneStruts {
  const { steps } = drawn.sequence;
  const now = stepAt(at, steps.length);
  const part = at - now;
  const lines: SceneLine[] = [];
  for (const [index, step] of steps.entries()) {
    const edge = edges.get(step.edge);
    const [a, b] = [edge && vertices.get(edge.a)?.at, edge && vertices.get(edge.b)?.at];
    if (!a || !b) continue;
    const layer = layers?.get(step.edge);
    const built = layer === undefined ? BUILT : layerColour(layer);
    if (index < now) lines.push({ at: [a, b], by: null, colours: [built] });
    else if (index > now) lines.push({ at: [a, b], by: null, colours: [built], width: 0.6, dim: FAINT });
    else {
      const move = drawn.moves[index];
      const [from, to] = move ? [move.from_mm, move.to_mm] : [a, b];
      const tip = evenly(from, to, part);
      lines.push({ at: [from, tip], by: null, colours: [PRESENT], width: 1.5 });
      if (part < 1) lines.push({ at: [tip, to], by: null, colours: [PRESENT], width: 0.6, dim: FAINT });
    }
  }
  const [step, move] = [steps[now], drawn.moves[now]];
  const head =
    step?.direction && move
      ? {
          outline: drawn.head_mm,
          tip: evenly(move.from_mm, move.to_mm, Math.min(part, 1)),
          axis: step.direction,
          free: move.free.flatMap((place) => (drawn.directions[place] ? [drawn.directions[place]] : [])),
        }
      : null;
  return { lines, ghost: false, worst: null, head };
}
