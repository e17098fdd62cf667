/** What tests of frames need: a design of two struts that stand on the ground and meet. */

import type { FrameShown } from "../../generated/responses";
import type { SceneDesign, SceneEdge, SceneVertex, Vec3 } from "../../scene/interface";

const PLACES: readonly Vec3[] = [
  [0, 0, 0],
  [100, 0, 0],
  [0, 0, 100],
];

export const smallFrame = (): SceneDesign => ({
  vertices: new Map(PLACES.map((at, id): [number, SceneVertex] => [id, { id, at, support: id < 2 }])),
  edges: new Map<number, SceneEdge>([
    [0, { id: 0, a: 0, b: 2 }],
    [1, { id: 1, a: 1, b: 2 }],
  ]),
});

/** The same with its upper vertex elsewhere. */
export function movedFrame(): SceneDesign {
  const { vertices, edges } = smallFrame();
  return { vertices: new Map(vertices).set(2, { id: 2, at: [0, 0, 120], support: false }), edges };
}

const line = (from: [number, number, number], to: [number, number, number]): [number, number, number][] => [from, to];

export const frameShown = (): FrameShown => ({
  result: {
    material: "wire",
    frame: { nodes: 3, members: 2, supports: 2, length_mm: 241.4, mass_g: 12.5 },
    static: {
      max_displacement_mm: 0.5,
      at_vertex: 2,
      work_n_mm: 1,
      reactions: [],
      members: [
        {
          edge: 0,
          axial_n: -4,
          moment_n_mm: 1,
          torque_n_mm: 0,
          von_mises_mpa: 20,
          utilisation: 0.1,
          buckling_ratio: 0.3,
        },
        {
          edge: 1,
          axial_n: 2,
          moment_n_mm: 1,
          torque_n_mm: 0,
          von_mises_mpa: 30,
          utilisation: 0.2,
          buckling_ratio: -0.1,
        },
      ],
      residual: 0,
    },
    modes: [
      { frequency_hz: 0, kind: "rigid" },
      { frequency_hz: 12.34, kind: "global" },
    ],
    bowed: null,
    closing: null,
    runs: null,
    of_runs: null,
    resources: null,
    holds: true,
    diagnostics: [],
    notes: [],
    timings_ms: {},
    files: [],
  },
  shapes: {
    struts: [
      { edge: 0, at_mm: line([0, 0, 0], [0, 0, 100]) },
      { edge: 1, at_mm: line([100, 0, 0], [0, 0, 100]) },
    ],
    loaded: [line([0, 0, 0], [0, 0, -0.5]), line([0, 0, 0], [0, 0, -0.5])],
    modes: [
      [line([1, 0, 0], [1, 0, 0]), line([1, 0, 0], [1, 0, 0])],
      [line([0, 0, 0], [0, 1, 0]), line([0, 0, 0], [0, 1, 0])],
    ],
    closed: null,
  },
});
