import { count } from "../../shared/figures/format";
import { baseName } from "../../state/files/files";
import type { Faces } from "../../state/frame/faces";

/** What the faces are of: a file by its name, or how many were selected. */
export function nameOfFaces(faces: Faces): string {
  return "file" in faces ? baseName(faces.file) : count(faces.vertices.length, "face");
}

/** The same where nothing beside it says that these are faces. */
export const facesOf = (faces: Faces): string =>
  "file" in faces ? `Faces of ${nameOfFaces(faces)}` : nameOfFaces(faces);
