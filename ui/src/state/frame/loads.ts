/** What acts on the frame besides gravity: forces that a person puts on vertices, and loads from a file. */

import type { LoadCaseEntry } from "../../generated/responses";
import { type FileKind, platform } from "../../platform";
import type { SceneHeld, Vec3 } from "../../scene/interface";
import { told } from "../asking/problems";
import { useDesign } from "../design/design";
import { type FrameChoice, useFrame } from "./frame";

export const DOWN: Vec3 = [0, 0, -1];

/** Puts a force on vertices; what was on them before goes. No force takes it away. */
export function putForce(vertices: Iterable<number>, force: Vec3): void {
  useFrame.setState(({ forces }) => {
    const after = new Map(forces);
    const acts = force.some((part) => part !== 0);
    for (const vertex of vertices) {
      if (acts) after.set(vertex, force);
      else after.delete(vertex);
    }
    return { forces: after };
  });
}

const LOADS: FileKind = { name: "Load cases of conmech", extensions: ["json"] };

/** Picks a file of load cases; one that is wrong is told, and what acted before stays. */
export async function pickLoads(): Promise<void> {
  const design = useDesign.getState().state?.name;
  const path = await told(platform.pickFile([LOADS]));
  if (!path) return;
  const read = await told(platform.ask("load-cases", { file: { file: path } }));
  const [first] = read?.cases ?? [];
  if (!read || !first || useDesign.getState().state?.name !== design) return;
  useFrame.setState({ loadFile: { path, cases: read.cases, chosen: first.name }, gravity: null });
}

export function chooseLoadCase(chosen: string): void {
  useFrame.setState(({ loadFile }) => ({ loadFile: loadFile && { ...loadFile, chosen } }));
}

export function dropLoads(): void {
  useFrame.setState(({ gravity }) => ({ loadFile: null, gravity: gravity ?? DOWN }));
}

/** The load case that acts. */
export const loadCase = ({ loadFile }: Pick<FrameChoice, "loadFile">): LoadCaseEntry | null =>
  loadFile?.cases.find(({ name }) => name === loadFile.chosen) ?? null;

/** The forces of both, as the view draws them. */
export function drawnForces(choice: Pick<FrameChoice, "forces" | "loadFile">): SceneHeld["forces"] {
  const { vertices } = useDesign.getState();
  const all = [
    ...choice.forces,
    ...(loadCase(choice)?.forces ?? []).map(({ vertex, force_n }) => [vertex, force_n] as const),
  ];
  return all.flatMap(([vertex, force]) => {
    const at = vertices.get(vertex)?.at;
    return at ? [[at, force] as const] : [];
  });
}
