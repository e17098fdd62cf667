/** What tests of the state need. */

import type { DesignState } from "./design";
import type { MachineState, OrderName, Phase } from "./operator";

/** A design of which nothing was done. */
export const designState = (given: Partial<DesignState> = {}): DesignState => ({
  changed: false,
  doublings: [],
  file: null,
  machine: null,
  material: null,
  name: "A",
  next: [1, 1],
  notes: "",
  redo: null,
  start: null,
  stencil: null,
  undo: null,
  units: "mm",
  unkept: null,
  ...given,
});

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
