/** What tests of the program need: a wire with one bend, bent by a machine. */

import type {
  MachineViewResponse,
  MadeResponse,
  PlayedWire,
  PoseReport,
  ProgramResponse,
} from "../../generated/responses";

const pose: PoseReport = { turn: [0, 1, 0, 0], bend_axis: [0, 0, 1], bend_deg: 90 };
const BEGIN = { at: 0, fed: 0, bent: 0, head_deg: 0, bend_axis_deg: 0, peg_out: 0 };
const step = (feed: number, bend: number): PlayedWire["steps"][number] => ({
  designed: { feed_mm: feed, rotate_deg: 0, bend_deg: bend },
  told: { feed_mm: feed, rotate_deg: 0, bend_deg: bend + 20 },
  seconds: [1, 0, 4, 1],
  vertex: null,
  edges: [],
  place: null,
  pause: null,
  pose,
  moments: [BEGIN, { at: 0.5, fed: 1, bent: 1, head_deg: 0, bend_axis_deg: bend + 20, peg_out: 1 }],
});

export const wire: PlayedWire = {
  bend_axis: [0, 0, 1],
  corners_mm: [
    [0, 0, 0],
    [30, 0, 0],
    [30, 30, 0],
  ],
  steps: [step(30, 90), step(30, 0)],
  stock_mm: 460,
  time_s: 12,
};
export const program: ProgramResponse = {
  job_hash: "a1",
  diameter_mm: 3,
  feasible: true,
  machine: "kit",
  material: "al",
  wires: [wire],
  without: 0,
  left_out: [],
};
export const view = { id: "kit", shapes: [], pivot_mm: [12, 0, 0], peg_top_mm: 9 } as unknown as MachineViewResponse;
export const made: MadeResponse = {
  by_machine: true,
  notes: [],
  wires: [
    { corners_mm: wire.corners_mm, poses: [pose, pose], wire_mm: [], deviations_mm: [0, 0.1, 0.2], worst_mm: 0.2 },
  ],
};
