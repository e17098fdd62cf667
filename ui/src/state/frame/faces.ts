/** The faces of a closed frame that are to be flat: those of a file, or vertices that a person has selected. */

import type { FacesChoice } from "../../generated/requests";
import type { SceneDesign } from "../../scene/interface";

export type Face = readonly number[];

/** A file of faces, or the vertices of each. */
export type Faces = { readonly file: string } | { readonly vertices: readonly Face[] };

/** Fewer are always on a plane. */
const FEWEST = 4;

const sorted = (vertices: Iterable<number>): number[] => [...new Set(vertices)].toSorted((a, b) => a - b);

const isSame = (one: Face, other: Face): boolean => one.join() === other.join();

/** Why these vertices cannot be a face more; null where they can. */
export function whyNoFace(faces: Faces | null, vertices: readonly number[]): string | null {
  if (faces && "file" in faces) return "The faces are those of a file.";
  if (vertices.length < FEWEST) return `Select ${FEWEST} or more vertices of a face, or the edges around it.`;
  const face = sorted(vertices);
  return faces?.vertices.some((other) => isSame(other, face)) ? "This face is in the list." : null;
}

/** With a face more, its vertices in the order of their ids. */
export function withFace(faces: Faces | null, vertices: readonly number[]): Faces {
  const before = faces && "vertices" in faces ? faces.vertices : [];
  return { vertices: [...before, sorted(vertices)] };
}

/** Null without any: all vertices count again. */
export function withoutFace(faces: Faces, gone: Face): Faces | null {
  if ("file" in faces) return faces;
  const vertices = faces.vertices.filter((face) => face !== gone);
  return vertices.length > 0 ? { vertices } : null;
}

/** A face whose vertices are not all there any more is none; the same object where nothing is gone. */
export function facesStillThere(faces: Faces | null, design: Pick<SceneDesign, "vertices">): Faces | null {
  if (!faces || "file" in faces) return faces;
  const gone = faces.vertices.filter((face) => !face.every((id) => design.vertices.has(id)));
  return gone.reduce<Faces | null>((left, face) => left && withoutFace(left, face), faces);
}

/** As it is asked of the Rust side. */
export function facesAsked(faces: Faces | null): FacesChoice | null {
  if (!faces) return null;
  if ("file" in faces) return { input: { file: faces.file } };
  return { vertices: faces.vertices.map((face) => [...face]) };
}
