/** What tests of the Run section need. */

import type { MachineState, OrderName, Phase } from "../../state/operator";

/** A machine that stands so, and can be told these orders. */
export const machineState = (phase: Phase, ...can: OrderName[]): MachineState => ({
  phase,
  machine: "wirebend-kit",
  port: "/dev/ttyACM0",
  simulated: false,
  identity: null,
  driver: null,
  position: null,
  settings: [],
  wire: null,
  can,
  busy: false,
  doing: null,
  question: null,
  recorded: 0,
  problem: null,
  unfinished: null,
});
