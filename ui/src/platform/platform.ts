import type { Requests } from "../generated/requests";
import type { Events, Responses } from "../generated/responses";
import { errorText } from "./error_text";

/** Something that can be asked of the Rust side. */
export type AskName = keyof Requests & keyof Responses;

/** What the Rust side sends without being asked. */
export type WindowEvent = {
  [K in Exclude<keyof Events, "refusal">]: { event: K; value: Events[K] };
}[Exclude<keyof Events, "refusal">];

/** Why something came to nothing: shown with its message; code by the code, never by the text. */
export class Refused extends Error {
  readonly refusal: Events["refusal"];

  constructor(refusal: Events["refusal"]) {
    super(errorText(refusal));
    this.refusal = refusal;
  }
}

/** A kind of files in a dialog. */
export interface FileKind {
  readonly name: string;
  /** Without the dot. */
  readonly extensions: readonly string[];
}

/** What the environment of the window does: the Rust side, dialogs, dropped files, closing. */
export interface Platform {
  /** Rejects with `Refused`. */
  ask<K extends AskName>(name: K, request: Requests[K]): Promise<Responses[K]>;
  /** The surface of a stencil of the open design: see `Workspace::stencil_mesh`. Empty without one. */
  stencilMesh(stencil: number): Promise<ArrayBuffer>;
  /** Hears of events; the function that is returned ends it. */
  listen(hear: (event: WindowEvent) => void): () => void;
  /** A file to open; null where the person has chosen none. */
  pickFile(kinds: readonly FileKind[]): Promise<string | null>;
  /** A file to write; null where the person has chosen none. The dialog has asked whether it may be replaced. */
  pickSave(suggested: string, kind: FileKind): Promise<string | null>;
  /** Hears of files that are dropped on the window, by their paths; `over` while they are above it. */
  onDrop(hear: (drop: { kind: "over" } | { kind: "left" } | { kind: "dropped"; paths: string[] }) => void): () => void;
  /** Hears of files that the system asks to open, as by a double click. */
  onOpen(hear: (path: string) => void): () => void;
  /** Those that it has asked for before the window heard of them, as by an argument; once. */
  filesToOpen(): Promise<readonly string[]>;
  /** Asked before the window closes: true lets it. */
  onClose(mayClose: () => Promise<boolean>): () => void;
  /** Closes the window without asking. */
  close(): Promise<void>;
  /** The title of the window. */
  setTitle(title: string): void;
  /** Stops the machine, whatever else is under way. Does not wait for other asks. */
  stop(): Promise<void>;
}
