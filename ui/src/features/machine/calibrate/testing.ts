import type { CalibrationReport } from "../../../generated/responses";

/** What is told of a sheet without readings. */
export const NOTHING_FITTED: CalibrationReport = {
  machine: "",
  material: "",
  kinds: [],
  shape: null,
  other_shape: null,
  other_shape_name: null,
  left_out: [],
  doubts: [],
  gaps: [],
};
