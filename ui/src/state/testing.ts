/** What tests of the state need. */

import type { DesignState } from "./design/design";
import type { Because, MachineState, OrderName, Phase } from "./machine/operator";

/** A design of which nothing was done. */
export const designState = (given: Partial<DesignState> = {}): DesignState => ({
  changed: false,
  closed: false,
  doublings: [],
  file: null,
  machine: null,
  material: null,
  name: "A",
  next: [1, 1],
  notes: "",
  redo: null,
  reversed: false,
  walks: [],
  pauses: [],
  collisions: { clearance_mm: 0, sag: false },
  start: null,
  stencils: [],
  construction_mm: [],
  parts: [],
  undo: null,
  units: "mm",
  unkept: null,
  wires: 1,
  ...given,
});

const ORDERS: Readonly<Record<OrderName, true>> = {
  home: true,
  jog: true,
  arm: true,
  disarm: true,
  start: true,
  pause: true,
  resume: true,
  speed: true,
  "resume-run": true,
  abandon: true,
  replay: true,
  "dry-run": true,
  "write-settings": true,
  console: true,
  disconnect: true,
};

/** Every other order than these, refused for one reason. */
export const refused = (because: Because, ...can: OrderName[]): MachineState["cannot"] =>
  (Object.keys(ORDERS) as OrderName[]).filter((order) => !can.includes(order)).map((order) => ({ order, because }));

const MOVING: readonly Phase[] = ["homing", "moving", "making", "holding", "stopping"];

/** A machine that stands so, and takes these orders and no others. */
export const machineState = (phase: Phase, ...can: OrderName[]): MachineState => ({
  phase,
  may_move: MOVING.includes(phase),
  machine: "wirebend-kit",
  port: "/dev/ttyACM0",
  simulated: false,
  simulated_as: { machine: null, material: null },
  identity: null,
  driver: null,
  position: null,
  speed_percent: null,
  cutter_mm: null,
  settings: [],
  wire: null,
  can,
  cannot: refused("busy", ...can),
  busy: false,
  doing: null,
  question: null,
  recorded: 0,
  problem: null,
  unfinished: null,
});
