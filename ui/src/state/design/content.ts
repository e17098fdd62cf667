/** Whether a design is what an answer is of. Undo makes it so again, however often it was changed in between. */

import type { EdgeView } from "../../generated/responses";
import type { SceneDesign, SceneEdge, SceneVertex } from "../../scene/interface";
import { useDesign } from "./design";

/** As the Rust side sends it; the scene draws edges of the ceiling as any other, and does not name them. */
type MarkedEdge = SceneEdge & Pick<EdgeView, "ceiling">;

/** What an answer is of: the wireframe, and all else that it depends on as one text. */
export interface Basis extends SceneDesign {
  readonly edges: ReadonlyMap<number, MarkedEdge>;
  readonly rest: string;
}

/** The design as it is, with this of all else. */
export function designNow(...rest: readonly unknown[]): Basis {
  const { vertices, edges } = useDesign.getState();
  return { vertices, edges, rest: JSON.stringify(rest) };
}

/** What is marked at vertices and edges, where an answer depends on it. */
export type Mark = "support" | "joint" | "ceiling";

/** Whether both are the same: a change that touches none of it leaves an answer as it is. */
export function isSame(a: Basis, b: Basis, marks: readonly Mark[]): boolean {
  const has = new Set(marks);
  const vertex = (one: SceneVertex, other: SceneVertex) =>
    one.at.every((value, axis) => value === other.at[axis]) &&
    (!has.has("support") || one.support === other.support) &&
    (!has.has("joint") || one.joint?.mass_g === other.joint?.mass_g);
  const edge = (one: MarkedEdge, other: MarkedEdge) =>
    one.a === other.a && one.b === other.b && (!has.has("ceiling") || Boolean(one.ceiling) === Boolean(other.ceiling));
  return a.rest === b.rest && sameAll(a.vertices, b.vertices, vertex) && sameAll(a.edges, b.edges, edge);
}

/** What a change does not touch stays the same object: only the others are looked into. */
function sameAll<T>(a: ReadonlyMap<number, T>, b: ReadonlyMap<number, T>, same: (a: T, b: T) => boolean): boolean {
  if (a === b) return true;
  if (a.size !== b.size) return false;
  for (const [id, one] of a) {
    const other = b.get(id);
    if (other === undefined || (one !== other && !same(one, other))) return false;
  }
  return true;
}
