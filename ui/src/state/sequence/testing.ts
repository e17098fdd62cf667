/** What tests of sequences need: an order in which the small frame of the tests of frames is built. */

import type { DrawnSequence } from "../../generated/responses";

const UP: [number, number, number] = [0, 0, 1];

export const sequenceDrawn = (edges: readonly number[] = [0, 1]): DrawnSequence => ({
  sequence: {
    machine: "builder",
    material: "wire",
    steps: edges.map((edge) => ({
      edge,
      from_vertex: edge,
      type: "ground",
      direction: UP,
      free_directions: 2,
      max_displacement_mm: 0.1 * (edge + 1),
    })),
    max_displacement_mm: 0.2,
    epsilon_mm: 0.65,
    sharing: 1,
    travel_mm: 10,
    min_free_directions: 2,
    layers: [[0], [1]],
    feasible: true,
    proved: true,
    strategy: "from-ground",
    obstacle: null,
    partial: null,
    diagnostics: [],
    notes: [],
    time_s: 30,
    timings_ms: {},
  },
  head_mm: [
    [0, 0],
    [20, 10],
  ],
  strut_radius_mm: 0.75,
  directions: [UP, [1, 0, 0]],
  moves: edges.map((edge) => ({ from_mm: edge === 0 ? [0, 0, 0] : [100, 0, 0], to_mm: [0, 0, 100], free: [0, 1] })),
  stopped: false,
});

/** The same as it is answered where it was given, with a direction for each step. */
export function sequenceChecked(edges?: readonly number[]): DrawnSequence {
  const { sequence, ...drawn } = sequenceDrawn(edges);
  const steps = sequence.steps.map((step) => ({ ...step, free_directions: 1 }));
  const unknown = { travel_mm: null, min_free_directions: null, strategy: null, time_s: null };
  return { ...drawn, sequence: { ...sequence, ...unknown, steps } };
}
