import type { EditRequest } from "../../generated/requests";
import type { SceneDesign, SceneJoint, Vec3, WireSelection } from "../../scene/interface";
import { edgesOf, verticesOf } from "./selecting";

/** What marks text on the clipboard as a piece of a wireframe, and its version. */
const FORMAT = "wirebend-piece";
const VERSION = 1;

/** More than anybody copies by hand; a mistake is caught before it is sent. */
const MAX_VERTICES = 100_000;

export type Piece = Extract<EditRequest, { edit: "paste" }>;

/** What is selected as something to paste; null of nothing. */
export function pieceOf(selection: WireSelection, design: SceneDesign): Piece | null {
  const ids = verticesOf(selection, design);
  if (ids.length === 0) return null;
  const places = new Map(ids.map((id, place) => [id, place]));
  const vertices = ids.flatMap((id) => {
    const vertex = design.vertices.get(id);
    if (!vertex) return [];
    const { at, support, joint } = vertex;
    return [{ at_mm: [...at] as [number, number, number], support, ...(joint ? { joint } : {}) }];
  });
  const edges = edgesOf(selection, design).flatMap((id) => {
    const edge = design.edges.get(id);
    const [a, b] = [edge && places.get(edge.a), edge && places.get(edge.b)];
    return a === undefined || b === undefined ? [] : [[a, b] as [number, number]];
  });
  return { edit: "paste", vertices, edges };
}

/** As text for the clipboard. */
export function toText({ vertices, edges }: Piece): string {
  return JSON.stringify({ format: FORMAT, version: VERSION, unit: "mm", vertices, edges });
}

function isJoint(value: unknown): value is SceneJoint {
  const { kind, mass_g } = (value ?? {}) as Record<string, unknown>;
  return ["snap-fit", "solder", "zip-tie"].includes(kind as string) && Number.isFinite(mass_g);
}

/** The piece of a text; a sentence for the person where it is none. */
export function fromText(text: string): Piece | string {
  const foreign = "The clipboard holds no part of a wireframe. Copy vertices or edges first, or open the file.";
  let read: unknown;
  try {
    read = JSON.parse(text);
  } catch {
    return foreign;
  }
  if (typeof read !== "object" || read === null) return foreign;
  const { format, version, vertices, edges } = read as Record<string, unknown>;
  if (format !== FORMAT) return foreign;
  if (version !== VERSION)
    return "The clipboard holds a piece from another version of this program. Copy it again in this one.";
  const damaged = "The piece on the clipboard is damaged: copy it again.";
  if (!Array.isArray(vertices) || !Array.isArray(edges) || vertices.length === 0 || vertices.length > MAX_VERTICES)
    return damaged;
  const isPlace = (value: unknown): value is number =>
    Number.isInteger(value) && (value as number) >= 0 && (value as number) < vertices.length;
  const isVertex = (value: unknown): value is Piece["vertices"][number] => {
    const { at_mm, support = false, joint } = (value ?? {}) as Record<string, unknown>;
    const isAt = Array.isArray(at_mm) && at_mm.length === 3 && at_mm.every(Number.isFinite);
    return isAt && typeof support === "boolean" && (joint === undefined || isJoint(joint));
  };
  const isEdge = (value: unknown): value is [number, number] =>
    Array.isArray(value) && value.length === 2 && value.every(isPlace) && value[0] !== value[1];
  if (!vertices.every(isVertex) || !edges.every(isEdge)) return damaged;
  const known = vertices.map(({ at_mm, support = false, joint }) => ({ at_mm, support, ...(joint ? { joint } : {}) }));
  return { edit: "paste", vertices: known, edges };
}

/** The same piece elsewhere, mm. */
export function moved(piece: Piece, by: Vec3): Piece {
  const vertices = piece.vertices.map(({ at_mm: [x, y, z], ...rest }) => ({
    ...rest,
    at_mm: [x + by[0], y + by[1], z + by[2]] as [number, number, number],
  }));
  return { ...piece, vertices };
}
