/** The open design as a frame: what was chosen, and what was computed of it. */

import { create } from "zustand";
import type { ClosingName, ContinuumChoice, FrameDesign, FrameSupports, VaryName } from "../../generated/requests";
import type { FrameChoices, FrameShown, LoadCaseEntry, ToleranceResponse } from "../../generated/responses";
import { platform } from "../../platform";
import type { SceneDesign, Vec3 } from "../../scene/interface";
import { told } from "../asking/problems";
import { asking } from "../asking/work";
import { type Basis, designNow, isSame, type Mark } from "../design/content";
import { useDesign, wiresOf } from "../design/design";
import { useMachines } from "../machine/machines";
import { type Faces, facesAsked, facesStillThere } from "./faces";
import { showFrame } from "./shape";

/** What holds the frame. */
export type Hold = "design" | "free" | "chosen";

/** A file of load cases, and which of them acts. */
interface LoadFile {
  readonly path: string;
  readonly cases: readonly LoadCaseEntry[];
  readonly chosen: string;
}

export interface FrameChoice {
  /** Null: that of the design. */
  readonly material: string | null;
  readonly hold: Hold;
  /** Vertices that a person has chosen as supports. */
  readonly chosen: ReadonlySet<number>;
  /** Multiples of standard gravity; null: as the load case says. */
  readonly gravity: Vec3 | null;
  /** Forces that a person has put on vertices, N. */
  readonly forces: ReadonlyMap<number, Vec3>;
  readonly loadFile: LoadFile | null;
  readonly modes: number;
  /** How far struts bow while they vibrate, as a share of their length; 0: they are straight. */
  readonly bow: number;
  /** Errors of a machine with which the wires are made and closed; null: joints are not closed. */
  readonly errors: string | null;
  readonly closing: ClosingName;
  readonly runs: number;
  /** Whether wires may run along edges twice. */
  readonly double: boolean;
  /** The faces that are to be flat; null: all vertices count. */
  readonly faces: Faces | null;
}

/** What is required of the closed frame; null: nothing. */
export interface Required {
  readonly surface: number | null;
  readonly force: number | null;
  readonly stress: number | null;
  readonly vary: VaryName;
  /** A truss of closed formulas in place of the design. */
  readonly continuum: ContinuumChoice | null;
}

/** An answer, and what it is of. */
interface Answer<T> {
  readonly value: T;
  readonly basis: Basis;
  /** The faces that are measured; null: all vertices count. */
  readonly faces: Faces | null;
}

interface FrameStore extends FrameChoice {
  /** Whether clicks on vertices choose supports. */
  readonly picking: boolean;
  readonly answer: Answer<FrameShown> | null;
  readonly asking: boolean;
  /** A person has ended the last computation: what was there before is shown on. */
  readonly cancelled: boolean;
  /** Why there is none. */
  readonly problem: string | null;
  readonly required: Required;
  readonly tolerance: Answer<ToleranceResponse> | null;
  readonly askingTolerance: boolean;
  readonly toleranceProblem: string | null;
  /** Null before they are known. */
  readonly choices: FrameChoices | null;
}

const USUAL: FrameChoice = {
  material: null,
  hold: "design",
  chosen: new Set(),
  gravity: [0, 0, -1],
  forces: new Map(),
  loadFile: null,
  modes: 6,
  bow: 0,
  errors: null,
  closing: "aligned",
  runs: 100,
  double: false,
  faces: null,
};

const NO_ANSWERS = {
  picking: false,
  answer: null,
  asking: false,
  cancelled: false,
  problem: null,
  tolerance: null,
  askingTolerance: false,
  toleranceProblem: null,
} as const;

export const useFrame = create<FrameStore>()(() => ({
  ...USUAL,
  ...NO_ANSWERS,
  required: { surface: null, force: null, stress: null, vary: "feed", continuum: null },
  choices: null,
}));

export function chooseFrame(choice: Partial<FrameChoice>): void {
  useFrame.setState(choice);
}

export function require(required: Partial<Required>): void {
  useFrame.setState((frame) => ({ required: { ...frame.required, ...required } }));
}

let needed: Promise<void> | null = null;

/** Asks once what there is to choose from. */
export function needFrameChoices(): void {
  if (useFrame.getState().choices) return;
  needed ??= told(platform.ask("frame-choices", {}))
    .then((choices) => useFrame.setState({ choices }))
    .finally(() => (needed = null));
}

/** With other profiles there may be others. */
export async function reloadFrameChoices(): Promise<void> {
  if (!useFrame.getState().choices) return;
  const choices = await told(platform.ask("frame-choices", {}));
  if (choices) useFrame.setState({ choices });
}

/** Forgets why there was no answer. */
export function forgetFrameProblems(): void {
  const { problem, toleranceProblem } = useFrame.getState();
  if (problem || toleranceProblem) useFrame.setState({ problem: null, toleranceProblem: null });
}

/** While it is on, clicks on vertices choose supports. */
export function setPicking(picking: boolean): void {
  useFrame.setState(picking ? { picking, hold: "chosen" } : { picking });
}

/** Takes vertices as supports, or lets those go that are. */
export function toggleSupports(vertices: Iterable<number>): void {
  useFrame.setState(({ chosen }) => {
    const after = new Set(chosen);
    for (const vertex of vertices) if (!after.delete(vertex)) after.add(vertex);
    return { chosen: after };
  });
}

function supports({ hold, chosen }: FrameChoice): FrameSupports {
  if (hold === "chosen") return { vertices: [...chosen].toSorted((a, b) => a - b) };
  return hold;
}

/** What an answer is of: with anything of this another it is out of date. */
function basisOf(choice: FrameChoice): Basis {
  const { state } = useDesign.getState();
  const wires = choice.errors === null ? null : wiresOf(state);
  return designNow(useMachines.getState().changes, materialOf(choice), wires, frameRequest(choice));
}

/** What the struts are of: without a choice, and without one of the design, its machine decides. */
function materialOf({ material }: FrameChoice): unknown {
  const { state } = useDesign.getState();
  const own = material ?? state?.material ?? null;
  return own === null ? [state?.machine] : own;
}

/** What is asked of the Rust side. */
export function frameRequest(choice: FrameChoice): FrameDesign {
  const { material, gravity, forces, loadFile, modes, bow, errors, closing, runs, double, faces } = choice;
  return {
    material,
    supports: supports(choice),
    gravity: gravity && ([...gravity] as [number, number, number]),
    loads: loadFile && { file: { file: loadFile.path }, case: loadFile.chosen },
    forces: [...forces]
      .toSorted(([a], [b]) => a - b)
      .map(([vertex, force]) => ({ vertex, force_n: [...force] as [number, number, number] })),
    modes,
    bow: bow > 0 && modes > 0 ? { share: bow, seed: 1 } : null,
    close: errors === null ? null : { errors, closing, runs, seed: 1, faces: facesAsked(faces) },
    double: errors !== null && double,
  };
}

function toleranceBasis(frame: FrameStore): Basis {
  const { required, closing, double, faces } = frame;
  const design = required.continuum ? null : [wiresOf(useDesign.getState().state), closing, double, faces];
  const basis = designNow(design, useMachines.getState().changes, materialOf(frame), required);
  return design ? basis : { ...basis, vertices: NO_DESIGN.vertices, edges: NO_DESIGN.edges };
}

/** A truss of closed formulas is no design. */
const NO_DESIGN: SceneDesign = { vertices: new Map(), edges: new Map() };

/** Whether anything was changed since the frame was computed. */
export function isFrameStale(): boolean {
  const frame = useFrame.getState();
  const marks: readonly Mark[] = frame.hold === "design" ? ["joint", "support"] : ["joint"];
  return frame.answer !== null && !isSame(frame.answer.basis, basisOf(frame), marks);
}

export function isToleranceStale(): boolean {
  const frame = useFrame.getState();
  return frame.tolerance !== null && !isSame(frame.tolerance.basis, toleranceBasis(frame), ["joint"]);
}

/** What {@link isFrameStale} depends on: who shows it is drawn anew. */
function useBases(): void {
  useDesign();
  useFrame();
  useMachines(({ changes }) => changes);
}

export function useFrameStale(): boolean {
  useBases();
  return isFrameStale();
}

export function useToleranceStale(): boolean {
  useBases();
  return isToleranceStale();
}

const wordsOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** Of several questions only the last one's answer counts. */
let asked = 0;
/** How many designs there were: what was asked of one is no answer for another. */
let opened = 0;

/** Computes the design as a frame, and shows it. */
export async function computeFrame(): Promise<void> {
  const choice = useFrame.getState();
  if (choice.asking) return;
  const basis = basisOf(choice);
  asked += 1;
  const question = asked;
  useFrame.setState({ asking: true, picking: false, cancelled: false });
  let answer: Pick<FrameStore, "answer" | "problem">;
  try {
    const value = await asking("frame", frameRequest(choice));
    answer = { answer: { value, basis, faces: choice.faces }, problem: null };
  } catch (error) {
    answer = { answer: null, problem: wordsOf(error) };
  }
  if (question !== asked) return;
  useFrame.setState({ ...answer, asking: false });
  // A view of the design as it was does not take the place of the one that is being changed.
  showFrame(answer.answer && !isFrameStale() ? firstView(answer.answer.value) : null);
}

/** A person has had enough: what was computed before stays. */
export function cancelFrame(): void {
  if (!useFrame.getState().asking) return;
  asked += 1;
  useFrame.setState({ asking: false, cancelled: true });
  // What cannot be stopped is answered some time, and nobody hears it.
  void platform.ask("stop-frame", {}).catch(() => {});
}

/** What is shown first of an answer: what it carries, else how it vibrates. */
function firstView({ shapes, result }: FrameShown): Parameters<typeof showFrame>[0] {
  if (shapes.loaded) return { kind: "loaded" };
  const bends = result.modes.findIndex(({ kind }) => kind !== "rigid");
  return bends >= 0 ? { kind: "mode", mode: bends } : null;
}

/** Asks how good a machine must be. */
export async function askTolerance(): Promise<void> {
  const frame = useFrame.getState();
  if (frame.askingTolerance) return;
  const { required, material, closing, double, faces } = frame;
  const basis = toleranceBasis(frame);
  useFrame.setState({ askingTolerance: true });
  const before = opened;
  let answer: Pick<FrameStore, "tolerance" | "toleranceProblem">;
  try {
    const { surface, force, stress, vary, continuum } = required;
    const value = await asking("tolerance", {
      material,
      required: { surface_mm: surface, force_n: force, stress_mpa: stress },
      vary,
      closing,
      double,
      faces: continuum ? null : facesAsked(faces),
      continuum,
    });
    answer = { tolerance: { value, basis, faces: continuum ? null : faces }, toleranceProblem: null };
  } catch (error) {
    answer = { tolerance: null, toleranceProblem: wordsOf(error) };
  }
  if (before === opened) useFrame.setState({ ...answer, askingTolerance: false });
}

/** Forgets what was of a design that was closed. */
export function forgetFrame(): void {
  asked += 1;
  opened += 1;
  if (useFrame.getState().asking) void platform.ask("stop-frame", {}).catch(() => {});
  const { gravity } = useFrame.getState();
  useFrame.setState({
    ...NO_ANSWERS,
    hold: "design",
    chosen: new Set(),
    gravity: gravity ?? USUAL.gravity,
    forces: new Map(),
    loadFile: null,
    faces: null,
  });
  showFrame(null);
}

/** Supports and forces at vertices that are not there any more go with them, and so do their faces. */
export function keepSupports(): void {
  const { vertices } = useDesign.getState();
  const { chosen, forces, faces } = useFrame.getState();
  const flat = facesStillThere(faces, { vertices });
  if (flat !== faces) useFrame.setState({ faces: flat });
  const left = [...chosen].filter((id) => vertices.has(id));
  if (left.length < chosen.size) useFrame.setState({ chosen: new Set(left) });
  const loaded = [...forces].filter(([id]) => vertices.has(id));
  if (loaded.length < forces.size) useFrame.setState({ forces: new Map(loaded) });
}
