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

/** Whether a step places several edges at once. */
const isWire = ({ edges }: DrawnSequence["sequence"]["steps"][number]): boolean => (edges?.length ?? 0) > 1;

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
  const ends = (id: number): readonly [Vec3, Vec3] | null => {
    const edge = edges.get(id);
    const [a, b] = [edge && vertices.get(edge.a)?.at, edge && vertices.get(edge.b)?.at];
    return a && b ? [a, b] : null;
  };
  const lay = (id: number, index: number) => {
    const at = ends(id);
    if (!at) return;
    const layer = layers?.get(id);
    const built = layer === undefined ? BUILT : layerColour(layer);
    if (index < now) lines.push({ at, by: null, colours: [built] });
    else if (index > now) lines.push({ at, by: null, colours: [built], width: 0.6, dim: FAINT });
    else lines.push({ at, by: null, colours: [PRESENT], width: 1.5 });
  };
  for (const [index, step] of steps.entries()) {
    const move = drawn.moves[index];
    if (index !== now || !move || isWire(step)) {
      // A wire is there as a whole as soon as its step begins.
      for (const id of isWire(step) ? (step.edges ?? []) : [step.edge]) lay(id, index);
      continue;
    }
    const { from_mm: from, to_mm: to } = move;
    const tip = evenly(from, to, part);
    lines.push({ at: [from, tip], by: null, colours: [PRESENT], width: 1.5 });
    if (part < 1) lines.push({ at: [tip, to], by: null, colours: [PRESENT], width: 0.6, dim: FAINT });
  }
  const [step, move] = [steps[now], drawn.moves[now]];
  const head =
    step?.direction && move
      ? {
          outline: drawn.head_mm,
          // At a wire the head stands where it fastens it first.
          tip: isWire(step) ? move.from_mm : evenly(move.from_mm, move.to_mm, Math.min(part, 1)),
          axis: step.direction,
          free: move.free.flatMap((place) => (drawn.directions[place] ? [drawn.directions[place]] : [])),
        }
      : null;
  return { lines, ghost: false, worst: null, head };
}
