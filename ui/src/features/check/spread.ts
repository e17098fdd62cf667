/** How far vertices scatter, as balls in the view, and what matters most of it. */

import type { Prediction, SimulatedWire } from "../../generated/responses";
import type { PlayedBall, SceneBall, SceneVertex } from "../../scene/interface";
import { distance } from "../../state/design/geometry";
import { rising } from "../frame/ramp";

/** How far a vertex is off: on average, and in 95 % of the wires at most. */
interface Scatter {
  readonly mean: number;
  readonly radius: number;
}

/** How far the vertices are off, by vertex: of one that is passed more than once the largest figures. */
export function scatters({ wires }: Prediction): Map<number, Scatter> {
  const found = new Map<number, Scatter>();
  for (const { vertices } of wires)
    for (const { vertex, mean_mm, radius_95_mm } of vertices) {
      const { mean, radius } = found.get(vertex) ?? { mean: 0, radius: 0 };
      found.set(vertex, { mean: Math.max(mean, mean_mm), radius: Math.max(radius, radius_95_mm) });
    }
  return found;
}

/** The largest distance that a vertex is off on average, which has the hottest colour. */
export const hottest = (prediction: Prediction): number =>
  Math.max(0, ...[...scatters(prediction).values()].map(({ mean }) => mean));

/** Balls in which 95 % of the wires have a vertex, in the colour of how far it is off on average. */
export function ballsOf(prediction: Prediction, vertices: ReadonlyMap<number, SceneVertex>): SceneBall[] {
  const most = hottest(prediction);
  return [...scatters(prediction)].flatMap(([vertex, { mean, radius }]) => {
    const at = vertices.get(vertex)?.at;
    return at && radius > 0 ? [{ at, radius, colour: rising(mean / most) }] : [];
  });
}

/** The balls of one wire in its order, each pass of a vertex with its own; colours are those of all wires. */
export function playedBallsOf(
  prediction: Prediction,
  wire: number,
  vertices: ReadonlyMap<number, SceneVertex>,
): PlayedBall[] {
  const most = hottest(prediction);
  let along = 0;
  let before: SceneVertex["at"] | null = null;
  return (prediction.wires[wire]?.vertices ?? []).flatMap(({ vertex, mean_mm: mean, radius_95_mm: radius }) => {
    const at = vertices.get(vertex)?.at;
    if (!at) return [];
    along += before ? distance(before, at) : 0;
    before = at;
    return radius > 0 ? [{ at, radius, colour: rising(mean / most), along }] : [];
  });
}

interface Widest extends Scatter {
  readonly vertex: number;
}

/** How far every vertex is off on average and in 95 % of the wires, and how far its passes are apart in as many; the worst first. */
export function byVertex({ wires }: Prediction): (Widest & { readonly gap: number | null })[] {
  const worst = new Map<number, Widest>();
  const gaps = new Map<number, number>();
  for (const { vertices, gaps: apart } of wires) {
    for (const { vertex, mean_mm: mean, radius_95_mm: radius } of vertices)
      if (radius >= (worst.get(vertex)?.radius ?? 0)) worst.set(vertex, { vertex, mean, radius });
    for (const { vertex, radius_95_mm } of apart) gaps.set(vertex, Math.max(gaps.get(vertex) ?? 0, radius_95_mm));
  }
  return [...worst.values()]
    .map((one) => ({ ...one, gap: gaps.get(one.vertex) ?? null }))
    .toSorted((a, b) => b.radius - a.radius || a.vertex - b.vertex);
}

/** The vertex that is farthest off. */
export const farthest = ({ wires }: Prediction): Widest | null =>
  largest(
    wires.flatMap(({ vertices }) =>
      vertices.map(({ vertex, mean_mm, radius_95_mm }) => ({ vertex, mean: mean_mm, radius: radius_95_mm })),
    ),
  );

/** The vertex whose passes are farthest apart. */
export const widest = ({ wires }: Prediction): Widest | null =>
  largest(
    wires.flatMap(({ gaps }) =>
      gaps.map(({ vertex, mean_mm, radius_95_mm }) => ({ vertex, mean: mean_mm, radius: radius_95_mm })),
    ),
  );

const largest = (some: readonly Widest[]): Widest | null =>
  some.reduce<Widest | null>((most, one) => (most && most.radius >= one.radius ? most : one), null);

type Source = SimulatedWire["sources"][number]["source"];

/** How far each kind of error alone moves all wires, the largest first: root mean squares. */
export function sources({ wires }: Prediction): { source: Source; rms: number }[] {
  const sums = new Map<Source, { squares: number; vertices: number }>();
  for (const wire of wires)
    for (const { source, rms_mm } of wire.sources) {
      const { squares, vertices } = sums.get(source) ?? { squares: 0, vertices: 0 };
      const n = wire.vertices.length;
      sums.set(source, { squares: squares + n * rms_mm ** 2, vertices: vertices + n });
    }
  return [...sums]
    .map(([source, { squares, vertices }]) => ({ source, rms: Math.sqrt(squares / Math.max(vertices, 1)) }))
    .toSorted((a, b) => b.rms - a.rms);
}

/** The bends whose errors move the wire most. */
export const bends = ({ wires }: Prediction, count: number): { vertex: number; rms: number }[] =>
  wires
    .flatMap(({ steps }) => steps.map(({ vertex, bend_mm }) => ({ vertex, rms: bend_mm })))
    .filter(({ rms }) => rms > 0)
    .toSorted((a, b) => b.rms - a.rms)
    .slice(0, count);
