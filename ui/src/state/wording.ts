/**
 * What a person at the window is told where a message of the Rust side speaks of the command line: by its code alone. The fact of such
 * a message stays, its advice is the window's own.
 */

/** What is said before the last `mark`: all of it where there is none. */
const before = (message: string, mark: string): string => (message.includes(mark) ? message.slice(0, message.lastIndexOf(mark)) : message);

/** The fact of a message, which ends where its advice begins, and other advice. */
const advised =
  (mark: string, advice: string) =>
  (message: string): string =>
    `${before(message, mark)}. ${advice}`;

const said = (text: string) => (): string => text;

const WORDS: Readonly<Record<string, (message: string) => string>> = {
  exists: advised(": ", "Choose another name, or say that it may be replaced."),
  "not-feasible": said("The machine cannot make this: mend what Check names, or say that it is to be written all the same."),
  "stage-not-reached": said("The design has no program yet: see what Check says."),
  "no-machine": said("No machine is chosen: choose one in the bar at the top."),
  "only-stencil": advised(": ", "Open it to trace on it, or to bend along the edges of its faces."),
  settled: advised(": ", "Open it without changing how it is read."),
  value: (message) => message.replace(/^-+/, ""),
  "no-driver": advised("; see ", "See Machine, Drivers: a driver that is not accepted yet is not used."),
  "driver-not-trusted": advised("; ", "If you trust its author, accept it under Machine, Drivers."),
  "driver-changed": advised("; ", "If that was an update of yours, accept it again under Machine, Drivers."),
  "no-port": said("Choose the port that the machine is at."),
  "files-only": advised(": ", "Write a file under Export, and use the machine\u2019s own program."),
  "not-confirmed": said("Nobody has said that the machine may move: look that it may, and say so."),
  "settings-differ": advised("; ", "Set the machine as its profile says, or say in Run that wires are made all the same."),
  unfinished: advised("; ", "Go on with it, or give it up: see Run."),
  "journal-damaged": advised("; `", "Give the wire up to begin it anew."),
  "in-doubt": advised("; look", "Look at the wire, resume once more, and say how much of the step is in it. Where you cannot tell, give the wire up and cut it off."),
  "other-step": advised("; say", "Resume once more."),
  contradiction: advised(". With ", "Stop the machine, then say step by step what was made."),
  "job-not-kept": advised(": ", "Open the design that it was made of."),
  "nothing-begun": said("No wire of this job was begun: there is nothing to go on with."),
  "nowhere-to-record": said("There is no folder of yours to keep journals of wires in: set HOME, and start the program again."),
  moves: advised("; ", "Record the moves again."),
  "moves-of-another": advised("; ", "They can be made all the same, if the machine has room for them."),
};

/** A message begins with a capital; the name of a file that it begins with stays as it is. */
const begun = (message: string): string => (/^[a-z]+[ ,]/.test(message) ? message.charAt(0).toUpperCase() + message.slice(1) : message);

/** A problem as the window says it. */
export function worded({ code, message }: { readonly code: string; readonly message: string }): string {
  // Only a code that is named here: not `constructor`.
  const words = Object.hasOwn(WORDS, code) ? WORDS[code] : undefined;
  return begun(words ? words(message) : message);
}
