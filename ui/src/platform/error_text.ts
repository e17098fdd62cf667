/** What a person at the window reads of an error: the fact as the Rust side states it, and what to do in the words of the window. */

import type { ErrorRemedy, InputName } from "../generated/responses";

type Kind = ErrorRemedy["remedy"];

/** What is to be given, as it is called in the window. */
const INPUTS: Readonly<Record<InputName, string>> = {
  format: "the format",
  scale: "the scale",
  units: "the unit",
  weld: "the weld distance",
  "face-edges": "the edges of faces",
  "centreline-radius": "the bend radius",
  tolerance: "the tolerance",
  "shortest-edge": "the shortest edge",
  layers: "the layers",
  handedness: "the direction of rotations",
  program: "the kind of program",
  machine: "the machine",
  material: "the material",
  double: "doubled edges",
  detours: "detours",
  wires: "the number of wires",
  closed: "the closed route",
  start: "the start",
  reverse: "the direction of the wire",
  "keep-order": "the order of the program",
  collisions: "the check for collisions",
  "avoid-collisions": "the search for a program without collisions",
  clearance: "the clearance",
  sag: "the sag",
  runs: "the number of runs",
  within: "the accuracy",
  supports: "the supports",
  gravity: "gravity",
  loads: "loads",
  modes: "the number of modes",
  pieces: "the number of pieces",
  bow: "the bow of struts",
  faces: "the faces",
  requirements: "what is required",
  vary: "the motions that vary",
  "feed-share": "the share for feeds",
  continuum: "the truss of closed formulas",
  expected: "the exact expectation",
  epsilon: "the largest sag",
  "time-limit": "the time limit",
  "group-by": "the groups",
  "profile-id": "the id",
  "profile-name": "the name",
  "format-settings": "the settings of the format",
  moves: "the moves",
  resume: "resuming",
  "simulated-as": "the simulated bender and wire",
  abandon: "giving up",
  readings: "the readings",
  "profile-values": "the values",
  "profile-keys": "the keys",
  date: "the date",
};

/** "Choose one of a, b and c." */
const oneOf = (names: readonly string[], otherwise: string): string =>
  names.length > 0 ? `Choose one of: ${names.join(", ")}.` : otherwise;

const stated = (text: string): string => (/[.!?]$/.test(text) ? text : `${text}.`);

/** A sentence for every remedy: one that is new does not compile before it has one. */
const REMEDIES: { readonly [K in Kind]: (remedy: Extract<ErrorRemedy, { remedy: K }>) => string } = {
  "check-readable": () => "Check that it exists and may be read.",
  "check-right-file": () => "Check that it is the right file.",
  "check-disk": () => "Check that the folder can be written to and the disk has room.",
  "correct-file": () => "Correct the file there, or export it again.",
  "export-again": () => "Export or download the file again.",
  "export-without": ({ part }) => `Export the file again without ${part}.`,
  "export-as": ({ form }) => `Export or save it as ${form}.`,
  "export-resolved": () => "Export the file again with its parts resolved.",
  "open-model": () => "Open the model or the drawing itself.",
  "put-files-beside": () => "Put these files beside it.",
  "open-from-folder": () => "Open the file from its folder, with these files beside it.",
  "simplify-model": () => "Simplify the model, or export less of it.",
  "repair-mesh": () => "Repair the mesh and export it again.",
  "name-columns": ({ columns }) => `Name the columns in a header line: ${columns}.`,
  "split-bend": () => "Write it as two bends.",
  "choose-file-format": () => "Export it in one of these formats.",
  "choose-unit": () => "Choose the unit when you open it.",
  "check-scale": () => "Check unit and scale.",
  "leave-out-layers": () => "Open it without choosing layers.",
  "read-again": () => "Press “Read again” beside the file to run it as it is now.",
  "import-again": () => "Import the model again.",
  "use-last-copy": () => "Take its last good copy, or undo what was changed by hand.",
  "open-as-it-is": () => "Open it as what it is.",
  "update-program": () => "Update the program.",
  "choose-other-file": () => "Choose another name.",
  overwrite: () => "Or confirm that it may be replaced.",
  "correct-input": ({ input }) => `Correct ${INPUTS[input]}.`,
  "leave-out": ({ inputs }) => `Leave out ${inputs.map((input) => INPUTS[input]).join(", ")}.`,
  "choose-known": ({ near, known }) =>
    near.length > 0 ? `Did you mean ${near.join(" or ")}?` : oneOf(known, "There is none yet."),
  "choose-load-case": ({ known }) => `Choose one of its load cases: ${known.join(", ")}.`,
  "enter-length": () => "Type a length of more than 0.",
  "enter-angle": () => "Type an angle of more than 0° and at most 180°.",
  "select-two-edges": () => "Select the two edges that the angle is between.",
  "move-ends-apart": () => "Move one of its ends first.",
  "move-out-of-line": () => "Move one of the vertices out of the line first.",
  "move-end-alone": () => "Switch off \u201cThe rest follows\u201d.",
  "free-vertex": () => "Free the support, or remove the joint, first.",
  "use-radius": ({ radius }) => `Use a radius of ${radius}, the nearest that can be made.`,
  "lengthen-edges": () => "Make the edges at the corner longer: no radius fits.",
  "correct-profile": () => "Correct the profile.",
  "add-key": ({ text }) => `Add ${text}.`,
  "see-schema": () => "See the JSON Schema of profiles.",
  "move-file": ({ folder }) => `Move the file to ${folder}.`,
  "rename-file": ({ name }) => `Rename the file to ${name}.`,
  "choose-other-id": () => "Choose another id.",
  "inherit-from": ({ ids }) =>
    ids.length > 0 ? `Inherit from ${ids.join(" or ")}.` : "Inherit from a complete profile.",
  "use-child": () => "Choose a profile that inherits from it.",
  "remove-parent": () => "Remove one \u201cinherits\u201d.",
  "choose-kind": ({ kinds }) => `Choose one of these kinds: ${kinds.join(", ")}.`,
  "copy-profile": () => "Copy it to your own profiles under Machine, and change the copy.",
  "set-home": () => "Set HOME, and start the program again.",
  "choose-machine": () => "Choose a machine in the bar at the top.",
  "choose-machine-and-material": () => "Choose the machine and the material that it was compensated for.",
  "take-as-nominal": () => "Or open it as a nominal program.",
  "turn-back": () => "If it was compensated, open it as a compensated program.",
  "take-face-edges": () => "Open it to bend along the edges of its faces.",
  "import-face-edges": () => "Open its model again to bend along the edges of its faces.",
  "trace-surface": () => "Open it to trace on its surface.",
  "open-as-wireframe": () => "Open it as a wireframe.",
  "export-format": ({ format }) => `Export the machine\u2019s own program (${format}).`,
  "watch-first-wire": () => "Run the first wire slowly, and watch for collisions.",
  "plan-again": () => "Open its design, and save the job again.",
  "plan-for-machine": ({ machine }) =>
    machine === null || machine === undefined
      ? "Choose a machine that reads it."
      : `Open its design, and choose the machine ${machine}.`,
  "plan-within-limit": () => "Set the limit in the machine\u2019s profile, and check the design again.",
  "make-job": () => "Open a design, and save its job.",
  "use-job": () => "Open the job to run or to export it.",
  "use-design": () => "Open its design.",
  "use-program-file": () => "Open the file of a program.",
  "import-original": () => "Open the original again.",
  "fix-findings": () => "Fix the problems in Check.",
  "ignore-findings": () => "Or go on anyway.",
  "save-design": () => "Save the design.",
  "open-design": () => "Open the design that it was planned from.",
  "trust-driver": ({ again }) =>
    again
      ? "If that was an update of yours, accept it again under Machine, Drivers."
      : "If you trust its author, accept it under Machine, Drivers.",
  "restrict-access": () =>
    "Keep other users from writing to the driver and to the folder that it is in, or put it elsewhere.",
  "install-font": () => "Write an SVG, or install a font, such as DejaVu.",
  "bend-test-piece": () => "Bend a test piece first, and enter its springback in the material\u2019s profile.",
  "list-drivers": () => "See Machine, Drivers.",
  "name-driver-folder": () => "Put the driver into your folder of drivers.",
  "report-to-author": () => "Report this to the author of the driver.",
  "follow-driver": ({ advice }) => stated(capitalized(advice)),
  "update-driver": () => "Use a newer build of the driver.",
  "change-driver-setting": () => "Or change the setting under Machine.",
  "reset-trust": () => "Correct the list, or delete it and accept the drivers again.",
  "choose-port": () => "Choose the port that the machine is at.",
  "export-file": () => "Write a file under Export, and use the machine\u2019s own program.",
  "answer-each-piece": () => "Answer before each piece.",
  "confirm-motion": () => "Check that it is safe, then confirm.",
  "confirm-zero": () => "Bring every axis to zero, then confirm.",
  "state-head": () => "Look at the head, and state where it stands.",
  "turn-head-back": () => "Switch the motors off, turn the head back to zero by hand, and state that it stands there.",
  "turn-head-less": () => "Turn it less, or the other way.",
  "turn-axes-back": () => "Turn the axes back by hand.",
  home: () => "Home the machine before it moves again.",
  "arm-again": () => "Arm the machine again.",
  "arm-or-jog": () => "Arm the machine, or move it by hand.",
  "start-or-disarm": () => "Start the wire, or disarm it first.",
  "continue-or-stop": () => "Continue the wire, or stop it first.",
  "pause-or-stop": () => "Pause or stop it first.",
  wait: () => "Wait until that is over.",
  stop: () => "Or stop the machine.",
  "cut-power": () => "Cut the power of the machine, then look at it.",
  "check-power-and-port": () => "Check that it has power and that the port is right.",
  connect: () => "Connect it first.",
  "connect-again": () => "Connect the machine again.",
  "connect-at": ({ port }) => `Connect the machine at ${port}.`,
  "ask-again": () => "Try again, and confirm it.",
  answer: () => "Answer the question first.",
  "use-other-machine": () => "Use another machine, or do it by hand.",
  "look-at-wire": () => "Look at the wire.",
  "write-settings": () => "Write the settings of the profile to the machine in Run.",
  "set-machine": () => "Set the machine with its own program, or correct the profile.",
  "accept-settings": () => "Or confirm in Run that wires are bent anyway.",
  "close-other-programs": () => "Close other programs and try again.",
  "choose-wire": () => "Choose a wire of the job.",
  "choose-job": () => "Choose a wire of the open design.",
  "resume-run": () => "Resume it in Run.",
  "abandon-run": () => "Or give it up in Run.",
  "answer-doubt": ({ step }) =>
    `Look at the wire, resume it, and state how much of step ${step} is done. If you do not know, give the wire up and cut it off.`,
  "resume-without-answer": () => "Resume it again.",
  "stop-and-answer": () => "Stop the machine, then state step by step what is done.",
  "measure-step": () => "Measure it.",
  "cut-by-hand": () => "Turn off \u201cCut each piece off\u201d, and cut the pieces off by hand.",
  "begin-anew": () => "Give the wire up, and bend it anew.",
  "name-runs-folder": () => "",
  "list-runs": () => "See the records in Run.",
  "record-again": () => "Record the moves again.",
  "replay-here": () => "They can be replayed anyway, if the machine has room for them.",
  "record-first": () => "Move the machine by hand with recording on.",
};

/** A message begins with a capital; the name of a file that it begins with stays as it is. */
function capitalized(text: string): string {
  return /^[a-z]+[ ,]/.test(text) ? text.charAt(0).toUpperCase() + text.slice(1) : text;
}

/** What can be done about it, as a sentence of the window. */
export function remedyText(remedy: ErrorRemedy): string {
  // The function for a kind takes the remedy of that kind: TypeScript does not follow that through the table.
  const text = REMEDIES[remedy.remedy] as (remedy: ErrorRemedy) => string;
  return text(remedy);
}

/** An error as the window states it. */
export function errorText(problem: {
  readonly message: string;
  readonly remedies?: readonly ErrorRemedy[] | undefined;
}): string {
  const fact = capitalized(problem.message);
  const advice = (problem.remedies ?? []).map(remedyText).filter((text) => text !== "");
  return advice.length > 0 ? [stated(fact), ...advice].join(" ") : fact;
}
